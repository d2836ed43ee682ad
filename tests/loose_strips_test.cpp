// Loose strips: each cut without a tab has one on the sheets where there is room, clear of all else.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/sheet/sheet.h"
#include "core/solve/solve.h"
#include "tests/support.h"

namespace netwright {
namespace {

/// Closed cut lines of four corners with a tab fold through the middle.
std::vector<Box2> strips_on(const Sheet& sheet) {
  std::vector<Box2> boxes;
  for (const Stroke& stroke : sheet.strokes) {
    if (stroke.layer != Layer::Cut || !stroke.is_closed || stroke.points.size() != 4) continue;
    Box2 box;
    for (const glm::dvec2 p : stroke.points) box.add(p);
    boxes.push_back(box);
  }
  return boxes;
}

class LooseStrips : public ::testing::Test {
 protected:
  LooseStrips() {
    Progress progress;
    net_ = solve(testing::make_dual(shapes::icosahedron()), {.seed = 1, .streams = 1, .threads = 1}, progress)
               .net;
    layout_ = arrange(net_, {}, {});
    for (const EdgeId e : net_.mesh().edges())
      if (!net_.tree.is_fold(net_.mesh(), e)) layout_.tabs.missing.push_back(e);
  }
  Net net_;
  PageLayout layout_;
};

TEST_F(LooseStrips, LieBesideTheNetForCutsWithoutTab) {
  const Sheet sheet = draw_sheets(net_, layout_, {}).front();
  const std::vector<Box2> strips = strips_on(sheet);
  ASSERT_FALSE(strips.empty());
  const double length = net_.mesh().length(layout_.tabs.missing.front()) * layout_.scale;
  for (const Box2& strip : strips) {
    EXPECT_NEAR(std::max(strip.size().x, strip.size().y), length - 1, 1e-6);
    EXPECT_NEAR(std::min(strip.size().x, strip.size().y), 10, 1e-6);
    EXPECT_GE(strip.min.x, layout_.frame.net.min.x - 1e-9);
    EXPECT_LE(strip.max.y, layout_.frame.net.max.y + 1e-9);
    for (const Stroke& stroke : sheet.strokes) {
      if (stroke.layer != Layer::Cut || stroke.points.size() == 4) continue;
      for (const glm::dvec2 p : stroke.points)
        EXPECT_FALSE(p.x > strip.min.x && p.x < strip.max.x && p.y > strip.min.y && p.y < strip.max.y);
    }
  }
  const auto folds =
      std::ranges::count_if(sheet.strokes, [](const Stroke& s) { return s.layer == Layer::TabFold; });
  EXPECT_EQ(static_cast<std::size_t>(folds), strips.size());
}

TEST_F(LooseStrips, CarryTheNumberOfTheirCutOnBothHalves) {
  const Sheet with = draw_sheets(net_, layout_, {}).front();
  SheetSettings without;
  without.loose_strips = false;
  const Sheet bare = draw_sheets(net_, layout_, {}, without).front();
  const auto n_labels = [](const Sheet& sheet) {
    return std::ranges::count_if(sheet.texts, [](const Text& t) { return t.layer == Layer::Labels; });
  };
  EXPECT_TRUE(strips_on(bare).empty());
  EXPECT_GT(n_labels(with), n_labels(bare));
  EXPECT_EQ((n_labels(with) - n_labels(bare)) % 2, 0);
}

TEST_F(LooseStrips, AreNotMadeWhereEveryCutHasItsTab) {
  layout_.tabs.missing.clear();
  EXPECT_TRUE(strips_on(draw_sheets(net_, layout_, {}).front()).empty());
}

}  // namespace
}  // namespace netwright
