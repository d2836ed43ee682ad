// The table of output formats, and one writer for each.
#include "core/sheet/write.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/atomic_file.h"
#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/sheet/fold_file.h"
#include "core/sheet/instructions.h"
#include "core/sheet/net_obj.h"
#include "core/sheet/number_text.h"

namespace netwright {

namespace {

using std::filesystem::path;

constexpr std::array<ExportFormat, 6> kFormats = {
    {{".pdf", "PDF, true to scale, all pages"},
     {".svg", "SVG with layers for cutting machines"},
     {".dxf", "DXF for cutting machines, one unit is 1 mm"},
     {".png", "PNG, true to scale, one file per page"},
     {".obj", "OBJ with the net as texture coordinates, for painting"},
     {".fold", "FOLD 1.2, the net as data that can be verified"}}};

std::string lower_extension(const path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// One file per sheet, or one for all; `to_bytes` takes a span of sheets.
template <class ToBytes>
std::vector<path> write_pages(const path& file, std::span<const Sheet> sheets, bool is_one_file,
                              const ToBytes& to_bytes) {
  std::vector<path> written;
  const std::size_t per_file = is_one_file ? sheets.size() : 1;
  for (std::size_t i = 0; i < sheets.size(); i += per_file) {
    written.push_back(page_path(file, i, is_one_file ? 1 : sheets.size()));
    write_file(written.back(), to_bytes(sheets.subspan(i, per_file)));
  }
  return written;
}

/// 400 million pixels take 1.6 GB.
void refuse_huge_picture(std::span<const Sheet> sheets, int dpi) {
  constexpr double kMostPixels = 4e8;
  for (const Sheet& sheet : sheets) {
    const double width = sheet.width_mm / 25.4 * dpi;
    const double height = sheet.height_mm / 25.4 * dpi;
    if (width * height > kMostPixels)
      throw Error(ErrorKind::Usage, "A picture of this paper at " + std::to_string(dpi) + " dpi has " +
                                        decimal_number(width, 0) + " x " + decimal_number(height, 0) +
                                        " pixels, which is too many; choose fewer dots per inch, or PDF.");
  }
}

std::vector<path> write_sheets(const path& file, const std::string& extension, std::span<const Sheet> sheets,
                               const std::string& title, const ExportSettings& exports) {
  using Sheets = std::span<const Sheet>;
  if (extension == ".svg")
    return write_pages(file, sheets, exports.is_one_file,
                       [&](Sheets some) { return svg_bytes(some, title, exports); });
  if (extension == ".dxf")
    return write_pages(file, sheets, exports.is_one_file,
                       [&](Sheets some) { return dxf_bytes(some, exports); });
  if (extension == ".png") {
    const int dpi = std::clamp(exports.png_dpi, kLeastDpi, kMostDpi);
    refuse_huge_picture(sheets, dpi);
    return write_pages(file, sheets, false, [&](Sheets some) { return png_bytes(some.front(), dpi); });
  }
  write_file(file, pdf_bytes(sheets, title));
  return {file};
}

}  // namespace

path page_path(const path& file, std::size_t index, std::size_t count) {
  if (count == 1) return file;
  path numbered = file;
  numbered.replace_filename(file.stem().string() + "_" + std::to_string(index + 1) +
                            file.extension().string());
  return numbered;
}

std::span<const ExportFormat> export_formats() { return kFormats; }

bool is_export_format(const path& file) {
  const std::string extension = lower_extension(file);
  return std::any_of(kFormats.begin(), kFormats.end(),
                     [&](const ExportFormat& format) { return format.extension == extension; });
}

std::string pages_text(const WrittenDrawing& written) {
  std::string text = counted(static_cast<std::int64_t>(written.n_pages), "page", "pages");
  if (written.n_backs > 0)
    text += " with " + counted(static_cast<std::int64_t>(written.n_backs), "back", "backs");
  if (written.has_instructions)
    text += written.n_backs > 0 ? " and the instructions" : " with the instructions";
  return text;
}

WrittenDrawing write_drawing(const path& file, const Net& net, const PageLayout& layout,
                             const SheetInfo& info, const SheetSettings& settings,
                             const ExportSettings& exports) {
  const std::string extension = lower_extension(file);
  if (!is_export_format(file)) {
    std::string known;
    for (const ExportFormat& format : kFormats)
      known += (known.empty() ? "" : ", ") + std::string(format.extension);
    throw Error(ErrorKind::Usage,
                file.string() + " names no format that can be written; end it in one of " + known + ".");
  }
  const std::string title = info.title.empty() ? path(net.mesh().name()).stem().string() : info.title;
  if (extension == ".fold") {
    FlatNet flat = to_flat_net(spread_pieces(net), layout.scale);
    flat.title = title;
    write_fold(file, flat);
    return {{file}};
  }
  if (extension == ".obj") return {write_net_obj(file, net, layout, settings, exports)};
  std::vector<Sheet> sheets = draw_sheets(net, layout, info, settings);
  const bool has_instructions = exports.instructions != InstructionPage::None && extension != ".dxf";
  if (has_instructions)
    add_instructions(sheets, instruction_sheet(net, layout, info, settings), exports.instructions);
  const auto n_backs = static_cast<std::size_t>(std::ranges::count_if(sheets, &Sheet::is_back));
  return {write_sheets(file, extension, sheets, title, exports), sheets.size(), n_backs, has_instructions};
}

}  // namespace netwright
