// All formats of the same net, read by the libraries that other programs read them with, and held against
// each other.
#include <gtest/gtest.h>

#include "core/sheet/write.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::net_of;
using testing::output_of;

struct Case {
  const char* name;
  PolygonSoup soup;
};

std::string compared(const Net& net, const TabSettings& tabs, const ExportSettings& exports) {
  const testing::TemporaryFolder folder;
  // A wide margin is the tabs' own, so that none is cut off by the frame.
  PageLayout layout = arrange(net, {.margin_mm = 25}, {}, tabs);
  layout.frame.net = {layout.frame.net.min - 10.0, layout.frame.net.max + 10.0};
  for (PageLayout::Page& page : layout.pages) page.origin -= 10.0;
  layout.tabs = place_tabs(net, layout.scale, tabs);
  SheetSettings settings;
  settings.labels.edge_numbers = false;
  for (const char* const name : {"net.pdf", "net.svg", "net.dxf", "net.fold"})
    write_drawing(folder / name, net, layout, {}, settings, exports);
  const std::string script = NETWRIGHT_TESTS "/compare_exports.py";
  return output_of({"/usr/bin/python3", script, (folder / "net").string(),
                    std::to_string(layout.frame.width_mm), std::to_string(layout.frame.height_mm)});
}

std::vector<Case> zoo() {
  return {{"cube", shapes::cube()},
          {"star", shapes::star(7)},
          {"torus", shapes::torus(12, 8)},
          {"icosphere", shapes::icosphere(3)},
          {"two cubes", shapes::combined(shapes::cube(), shapes::cube(), {5, 0, 0})}};
}

TEST(CompareExports, AllFormatsAgreeOnNetsWithoutTabs) {
  for (const Case& c : zoo()) {
    const std::string words = compared(net_of(c.soup), no_tabs(), {});
    EXPECT_EQ(words.find("FAIL"), std::string::npos) << c.name << ":\n" << words;
    EXPECT_TRUE(words.ends_with("agree\n")) << c.name << ":\n" << words;
    EXPECT_NE(words.find("tabs 0\n"), std::string::npos) << c.name << ":\n" << words;
  }
}

TEST(CompareExports, AllFormatsAgreeOnNetsWithTabs) {
  for (const Case& c : zoo()) {
    const std::string words = compared(net_of(c.soup), {}, {});
    EXPECT_EQ(words.find("FAIL"), std::string::npos) << c.name << ":\n" << words;
    EXPECT_TRUE(words.ends_with("agree\n")) << c.name << ":\n" << words;
    EXPECT_EQ(words.find("tabs 0\n"), std::string::npos) << c.name << ":\n" << words;
  }
}

}  // namespace
}  // namespace netwright
