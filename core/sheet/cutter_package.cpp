// Puts a cutter's files together: refuses what cannot be cut, draws, writes, checks, and says what to mind.
#include "core/sheet/cutter_package.h"

#include <algorithm>
#include <system_error>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/sheet/number_text.h"
#include "core/sheet/outline.h"
#include "core/sheet/write.h"

namespace netwright {

namespace {

namespace fs = std::filesystem;

Box2 box_of(const std::vector<glm::dvec2>& points) {
  Box2 box{points.front(), points.front()};
  for (const glm::dvec2 p : points) box = {glm::min(box.min, p), glm::max(box.max, p)};
  return box;
}

/// Every mark with 1 mm of quiet around it must be free of the net.
void refuse_covered_marks(const Sheet& cut) {
  constexpr double kQuiet = 1;
  std::vector<Box2> marks;
  for (const Fill& fill : cut.fills)
    if (fill.layer == Layer::Regmarks) marks.push_back(box_of(fill.points));
  for (const Stroke& stroke : cut.strokes)
    if (stroke.layer == Layer::Regmarks)
      for (std::size_t i = 1; i < stroke.points.size(); ++i)
        marks.push_back(box_of({stroke.points[i - 1], stroke.points[i]}));
  for (Box2& mark : marks) mark = {mark.min - kQuiet, mark.max + kQuiet};
  for (const Stroke& stroke : cut.strokes) {
    if (stroke.layer != Layer::Cut) continue;
    for (const Box2& mark : marks)
      if (!clip_polyline(mark, stroke.points, stroke.is_closed).runs.empty())
        throw Error(ErrorKind::Usage, "The net covers a registration mark on sheet " +
                                          std::to_string(cut.number) +
                                          "; use wider margins or print the model smaller.");
  }
}

void refuse_tiles(const PageLayout& layout) {
  for (const PageLayout::Canvas& canvas : layout.canvases)
    if (canvas.is_tiled())
      throw Error(ErrorKind::Usage,
                  "A piece is larger than the paper, and no machine cuts across sheets; use larger paper, "
                  "print the model smaller or split the net to fit (Split to fit in the window, "
                  "--split-to-fit on the command line).");
}

std::vector<std::string> notes_on(const std::vector<CutterSheets>& sheets, CutterPreset preset) {
  std::vector<std::string> notes;
  if (preset != CutterPreset::Cricut) return notes;
  glm::dvec2 largest(0);
  for (const CutterSheets& sheet : sheets)
    for (const Stroke& stroke : sheet.cut.strokes)
      if (stroke.layer == Layer::Cut) {
        const glm::dvec2 size = box_of(stroke.points).size();
        largest = glm::max(largest, size.x > size.y ? size : glm::dvec2(size.y, size.x));
      }
  if (largest.x > kCricutArea.x || largest.y > kCricutArea.y)
    notes.push_back(
        "The largest piece measures " + decimal_number(largest.x, 0) + " x " + decimal_number(largest.y, 0) +
        " mm, and Cricut's Print then Cut takes at most 9.25 x 6.75 inches (235 x 171 mm): cut it "
        "without printing first, or print it smaller.");
  return notes;
}

std::string stem_of(const Net& net, const SheetInfo& info) {
  std::string stem = info.title.empty() ? fs::path(net.mesh().name()).stem().string() : info.title;
  std::ranges::replace(stem, '/', '_');
  return stem.empty() ? "net" : stem;
}

struct NamedBytes {
  std::string name;
  std::string bytes;
};

/// The cut files of all sheets, checked.
std::vector<NamedBytes> cut_files(const std::vector<CutterSheets>& sheets, const std::string& stem,
                                  ExportSettings exports) {
  exports.live_text = false;
  exports.real_dashes = true;
  std::vector<NamedBytes> files;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const Sheet& cut = sheets[i].cut;
    std::string svg = svg_bytes(cut, stem, exports);
    std::string dxf = dxf_bytes(std::span(&cut, 1), exports);
    check_cut_files(cut, svg, dxf);
    files.push_back({page_path(stem + "-cut.svg", i, sheets.size()).string(), std::move(svg)});
    files.push_back({page_path(stem + "-cut.dxf", i, sheets.size()).string(), std::move(dxf)});
  }
  return files;
}

}  // namespace

CutterPackage write_cutter_package(const fs::path& folder, const Net& net, const PageLayout& layout,
                                   const SheetInfo& info, const SheetSettings& settings,
                                   const ExportSettings& exports, CutterPreset preset) {
  refuse_tiles(layout);
  const std::string stem = stem_of(net, info);
  std::vector<CutterSheets> sheets;
  std::vector<Sheet> prints;
  for (const Sheet& sheet : draw_sheets(net, layout, info, settings)) {
    if (sheet.is_back) continue;
    sheets.push_back(cutter_sheets(sheet, layout, preset));
    refuse_covered_marks(sheets.back().cut);
    prints.push_back(sheets.back().print);
  }
  // Everything is made and checked before the first file is written.
  std::vector<NamedBytes> files = cut_files(sheets, stem, exports);
  files.insert(files.begin(), {stem + "-print.pdf", pdf_bytes(prints, stem)});
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed)
    throw Error(ErrorKind::Write,
                "The folder " + folder.string() + " cannot be made: " + failed.message() + ".");
  CutterPackage package;
  for (const NamedBytes& file : files) {
    package.files.push_back(folder / file.name);
    write_file(package.files.back(), file.bytes);
  }
  package.notes = notes_on(sheets, preset);
  return package;
}

}  // namespace netwright
