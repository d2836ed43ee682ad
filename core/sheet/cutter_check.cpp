// The cut files read back from their bytes, by readers that know as little as a machine does: the paths of a
// layer's group in the SVG, the polylines and lines of a layer in the DXF.
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>
#include <sstream>
#include <utility>

#include "core/base/error.h"
#include "core/sheet/cutter_package.h"
#include "core/sheet/vector_parts.h"

namespace netwright {

namespace {

constexpr double kRounding = 1e-3;  // mm: four decimals in the SVG, six in the DXF

struct ReadLine {
  Line points;
  bool is_closed = false;
};
using ReadLines = std::vector<ReadLine>;

/// Pairs "x,y" of path data; each M begins a line, Z closes it.
ReadLines lines_of_path(std::string_view data) {
  ReadLines lines;
  for (std::size_t at = 0; at < data.size(); ++at) {
    if (data[at] == 'Z' && !lines.empty()) lines.back().is_closed = true;
    if (data[at] != 'M' && data[at] != 'L') continue;
    if (data[at] == 'M') lines.emplace_back();
    glm::dvec2 p(0);
    const char* const end = data.data() + data.size();
    const auto x = std::from_chars(data.data() + at + 1, end, p.x);
    const auto y = std::from_chars(std::min(x.ptr + 1, end), end, p.y);
    if (x.ec != std::errc() || y.ec != std::errc() || lines.empty()) continue;
    lines.back().points.push_back(p);
  }
  return lines;
}

ReadLines lines_of_svg(std::string_view svg, std::string_view layer) {
  ReadLines lines;
  const std::size_t start = svg.find("inkscape:label=\"" + std::string(layer) + "\"");
  if (start == std::string_view::npos) return lines;
  const std::string_view group = svg.substr(start, svg.find("</g>", start) - start);
  constexpr std::string_view kData = " d=\"";
  for (std::size_t at = group.find(kData); at != std::string_view::npos; at = group.find(kData, at + 1)) {
    const std::size_t from = at + kData.size();
    for (ReadLine& line : lines_of_path(group.substr(from, group.find('"', from) - from)))
      lines.push_back(std::move(line));
  }
  return lines;
}

/// One entity of the file at a time: its group codes and values.
class DxfEntities {
 public:
  explicit DxfEntities(std::string_view dxf) : text_(std::string(dxf)) {}

  bool next() {
    values_.clear();
    if (!kind_of_next_.empty()) kind_ = std::exchange(kind_of_next_, "");
    std::string code;
    std::string value;
    while (std::getline(text_, code) && std::getline(text_, value)) {
      const int number = std::atoi(code.c_str());
      if (number == 0) {
        kind_of_next_ = value;
        return true;
      }
      values_[number] = value;
    }
    return false;
  }
  [[nodiscard]] const std::string& kind() const { return kind_; }
  [[nodiscard]] std::string text(int code) const {
    const auto found = values_.find(code);
    return found == values_.end() ? "" : found->second;
  }
  [[nodiscard]] double number(int code) const { return std::strtod(text(code).c_str(), nullptr); }

 private:
  std::istringstream text_;
  std::string kind_;
  std::string kind_of_next_;
  std::map<int, std::string> values_;
};

/// With y turned down again.
ReadLines lines_of_dxf(std::string_view dxf, const std::string& layer, double height_mm) {
  ReadLines lines;
  DxfEntities entities(dxf);
  while (entities.next()) {
    if (entities.text(8) != layer) continue;
    if (entities.kind() == "POLYLINE") lines.push_back({{}, (std::atoi(entities.text(70).c_str()) & 1) != 0});
    const glm::dvec2 p(entities.number(10), height_mm - entities.number(20));
    if (entities.kind() == "VERTEX" && !lines.empty()) lines.back().points.push_back(p);
    if (entities.kind() == "LINE")
      lines.push_back({{p, {entities.number(11), height_mm - entities.number(21)}}, false});
  }
  return lines;
}

bool is_same(const Line& a, const Line& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](glm::dvec2 p, glm::dvec2 q) {
           return glm::length(p - q) <= kRounding;
         });
}

/// The lines of a layer that the sheet has.
ReadLines drawn_lines(const Sheet& sheet, Layer layer) {
  ReadLines lines;
  for (const Fill& fill : sheet.fills)
    if (fill.layer == layer) lines.push_back({fill.points, true});
  for (const Stroke& stroke : sheet.strokes)
    if (stroke.layer == layer) lines.push_back({stroke.points, stroke.is_closed});
  return lines;
}

void compare(const ReadLines& drawn, const ReadLines& read, const std::string& what,
             const std::string& file) {
  const auto refuse = [&](const std::string& reason) {
    throw Error(ErrorKind::Write, "The cut " + file + " failed its check: " + reason +
                                      "; please report this model, and do not cut by the files.");
  };
  if (read.size() != drawn.size())
    refuse("it has " + std::to_string(read.size()) + " of " + std::to_string(drawn.size()) + " " + what);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i].is_closed && !read[i].is_closed) refuse("one of the " + what + " is not closed");
    if (!is_same(drawn[i].points, read[i].points)) refuse("one of the " + what + " lies elsewhere");
  }
}

}  // namespace

void check_cut_files(const Sheet& cut, std::string_view svg, std::string_view dxf) {
  const ReadLines outlines = drawn_lines(cut, Layer::Cut);
  for (const ReadLine& outline : outlines)
    if (!outline.is_closed || outline.points.size() < 3)
      throw Error(ErrorKind::Write, "An outline of sheet " + std::to_string(cut.number) +
                                        " is not closed, so no machine can cut it out; use larger paper or "
                                        "print the model smaller.");
  compare(outlines, lines_of_svg(svg, "Cut"), "outlines", "SVG");
  compare(outlines, lines_of_dxf(dxf, "CUT", cut.height_mm), "outlines", "DXF");
  const ReadLines marks = drawn_lines(cut, Layer::Regmarks);
  compare(marks, lines_of_svg(svg, "Regmarks"), "registration marks", "SVG");
  compare(marks, lines_of_dxf(dxf, "REG", cut.height_mm), "registration marks", "DXF");
}

}  // namespace netwright
