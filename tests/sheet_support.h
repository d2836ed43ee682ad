// What the tests of pages and printing share: nets of the zoo's shapes, a folder that cleans up after itself,
// and a way to ask the PDF tools.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/random.h"
#include "core/base/subprocess.h"
#include "core/sheet/sheet.h"
#include "core/unfold/steepest_edge.h"
#include "tests/support.h"

namespace netwright::testing {

/// A net of the shape; it may overlap, which paper does not mind.
inline Net net_of(const PolygonSoup& soup) {
  const auto dual = make_dual(soup);
  Random random(7);
  return layout(dual, steepest_edge_tree(*dual, random));
}

/// A tab on every side that is cut, as wide as asked and a third of the side at most. They may cover what
/// they like.
inline GlueTabs tabs_everywhere(const Net& net, double scale, double width_mm = 3) {
  const Mesh& mesh = net.mesh();
  GlueTabs tabs;
  for (const HalfedgeId h : mesh.halfedges()) {
    if (mesh.is_border(mesh.edge(h)) || net.tree.is_fold(mesh, mesh.edge(h))) continue;
    const glm::dvec2 begin = net.corner(h) * scale;
    const glm::dvec2 end = net.corner(mesh.next(h)) * scale;
    const glm::dvec2 along = glm::normalize(end - begin);
    const double width = std::min(width_mm, glm::length(end - begin) / 3);
    const glm::dvec2 out = width * glm::dvec2(along.y, -along.x);
    tabs.tabs.push_back(
        {h, {end, begin, begin + out + along * width, end + out - along * width}, width, true});
  }
  return tabs;
}

/// Shows this much more of the canvas on every page, for tabs that the layout left no room for.
inline void widen(PageLayout& layout, double mm) {
  layout.frame.net.min -= mm;
  layout.frame.net.max += mm;
  for (PageLayout::Page& page : layout.pages) page.origin -= mm;
}

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "netwright_test_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  [[nodiscard]] std::vector<std::filesystem::path> files() const {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) found.push_back(entry.path());
    return found;
  }

 private:
  std::filesystem::path path_;
};

/// Runs a tool and returns what it printed; a missing or failing tool fails the test by name.
inline std::string output_of(std::vector<std::string> command) {
  const std::string tool = command.front();
  const ChildResult result = run_child("/usr/bin/env", command, "", {.seconds = 60});
  EXPECT_EQ(result.end, ChildResult::End::Exited) << tool << " did not end by itself";
  EXPECT_NE(result.exit_code, 127)
      << tool << " is not installed (packages poppler-utils, mupdf-tools, imagemagick, librsvg2-bin)";
  EXPECT_EQ(result.exit_code, 0) << tool << " failed (Python needs the package python3-ezdxf)";
  return result.output;
}

inline double length_of(const Stroke& stroke) {
  double length = 0;
  const std::size_t n = stroke.points.size();
  for (std::size_t i = 0; i + (stroke.is_closed ? 0 : 1) < n; ++i)
    length += glm::length(stroke.points[(i + 1) % n] - stroke.points[i]);
  return length;
}

inline bool is_of_net(const Stroke& stroke) {
  return stroke.layer == Layer::Cut || stroke.layer == Layer::Mountain || stroke.layer == Layer::Valley ||
         stroke.layer == Layer::TabFold;
}

}  // namespace netwright::testing
