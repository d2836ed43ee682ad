// What the user decided about tabs and printed sheets, to and from a project file's JSON.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/base/image.h"
#include "core/base/json.h"
#include "core/mesh/mesh.h"
#include "core/sheet/export_settings.h"
#include "core/sheet/sheet_settings.h"
#include "core/unfold/glue_tabs.h"

namespace netwright {

Json tabs_json(const TabSettings& tabs, const Mesh& mesh);
/// Members that are missing have their usual values, `json` may be null. What is beyond its limits is
/// refused. Throws Error(Read).
TabSettings read_tabs(const Json* json, const std::string& file, const Mesh& mesh);

Json exports_json(const ExportSettings& exports);
ExportSettings read_exports(const Json* json, const std::string& file);

/// `number_of` keeps a picture and says its number, from 1.
Json sheet_json(const SheetSettings& sheet, const Mesh& mesh,
                const std::function<int(const std::shared_ptr<const Image>&)>& number_of);
/// `pictures` are those of the file, in the order of their numbers.
SheetSettings read_sheet(const Json* json, const std::string& file, const Mesh& mesh,
                         const std::vector<std::shared_ptr<const Image>>& pictures);

}  // namespace netwright
