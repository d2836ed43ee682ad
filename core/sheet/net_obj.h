// OBJ with the net as texture coordinates: the model in space, and for every corner where it lies on paper. A
// 3-D program that paints on the model paints on the net.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/sheet/export_settings.h"
#include "core/sheet/sheet.h"

namespace netwright {

/// The model's faces as the mesh has them, in model units; vt is the place on the piece's canvas, (0, 0) at
/// its lower left, (1, 1) at its upper right corner. Canvas n wears the material `sheet_n`, counted from 1.
std::string net_obj_text(const Net& net, const PageLayout& layout, const std::string& mtl_name);

/// One sheet per canvas, as large as the canvas, with pictures, outlines and folds but neither labels nor
/// anything that stands around the net: what lies at vt (x, y) of that canvas is seen there.
std::vector<Sheet> canvas_sheets(const Net& net, const PageLayout& layout, const SheetSettings& settings);

/// Writes name.obj, name.mtl and a picture per canvas: name.png, or name_1.png, name_2.png …, with at most
/// 8192 pixels a side. Throws Error(Write), also when name.obj is a model that Netwright did not write, so
/// that none is lost.
std::vector<std::filesystem::path> write_net_obj(const std::filesystem::path& path, const Net& net,
                                                 const PageLayout& layout, const SheetSettings& settings,
                                                 const ExportSettings& exports);

}  // namespace netwright
