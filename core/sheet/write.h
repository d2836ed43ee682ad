// Exporting: the file's extension picks the writer. Every file appears whole or not at all.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/sheet/export_settings.h"
#include "core/sheet/sheet.h"

namespace netwright {

struct ExportFormat {
  std::string_view extension;    ///< lower case with dot: ".pdf"
  std::string_view description;  ///< for dialogs: "PDF, true to scale"
};

/// The one table of output formats: dialogs, command line and README show it.
std::span<const ExportFormat> export_formats();

/// True when the path's extension (case ignored) is in the table.
bool is_export_format(const std::filesystem::path& path);

/// name.png, or name_3.png for index 2 of several.
std::filesystem::path page_path(const std::filesystem::path& file, std::size_t index, std::size_t count);

/// What was written. Formats that know no pages (FOLD, OBJ) have none.
struct WrittenDrawing {
  std::vector<std::filesystem::path> files;
  std::size_t n_pages = 0;        ///< all of them,
  std::size_t n_backs = 0;        ///< these among them
  bool has_instructions = false;  ///< and a page with instructions
};

/// "4 pages", "6 pages with 2 backs and the instructions".
std::string pages_text(const WrittenDrawing& written);

/// Draws the net and writes it. PDF and FOLD are one file; PNG, SVG and DXF are one
/// per page: name.png, or name_1.png, name_2.png … when there are several; SVG and DXF on request one for
/// all. OBJ has its materials and pictures beside it. Throws Error(Usage) for an unknown extension, naming
/// the known ones, and Error(Write) when a file cannot be written.
WrittenDrawing write_drawing(const std::filesystem::path& path, const Net& net, const PageLayout& layout,
                             const SheetInfo& info, const SheetSettings& settings = {},
                             const ExportSettings& exports = {});

/// The single writers: sheets to bytes. The same sheets give the same bytes. Several sheets lie side by side
/// in SVG and DXF. DXF has no Layer::Print: it is for machines.
std::string pdf_bytes(std::span<const Sheet> sheets, const std::string& title);
std::string png_bytes(const Sheet& sheet, double dpi = 300);
std::string svg_bytes(std::span<const Sheet> sheets, const std::string& title,
                      const ExportSettings& settings = {});
inline std::string svg_bytes(const Sheet& sheet, const std::string& title,
                             const ExportSettings& settings = {}) {
  return svg_bytes(std::span(&sheet, 1), title, settings);
}
std::string dxf_bytes(std::span<const Sheet> sheets, const ExportSettings& settings = {});

}  // namespace netwright
