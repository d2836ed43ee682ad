// Polish in the window: its rows count for the next net, and the net goes on getting better until it is over
// or stopped.
#include <gtest/gtest.h>

#include "tests/gui_support.h"

namespace netwright::testing {
namespace {

bool is_idle(Gui& gui) { return gui.session().state() == RunState::Idle && gui.session().pages() != nullptr; }

TEST(PolishPanel, SetsHowLongAndWhatFor) {
  Gui gui;
  gui.open_sample("Cube");
  gui.enter("polish/seconds", "3");
  EXPECT_EQ(gui.session().polish().effort, 3);
  EXPECT_EQ(gui.session().polish().fits_paper, 0);
  EXPECT_FALSE(gui.widgets.find("polish/page"));
  gui.click("polish/weights");
  gui.frames(2);
  gui.click("polish/page");
  EXPECT_NEAR(gui.session().polish().fits_paper, 1.5, 0.2) << "the middle of its slider";
  gui.enter("polish/seconds", "0");
  gui.frames(2);
  EXPECT_FALSE(gui.widgets.find("polish/page")) << "nothing to weigh when nothing is polished";
}

TEST(PolishPanel, PolishesTheNextNet) {
  Gui gui;
  gui.open_sample("Bunny");
  const auto first = gui.session().project().tree;
  gui.enter("polish/seconds", "1");
  gui.key(' ');
  ASSERT_TRUE(gui.until([&] { return !gui.session().figures().polish_costs.empty(); }));
  ASSERT_TRUE(gui.until([&] { return is_idle(gui) && gui.session().project().tree != first; }));
  const std::vector<double>& costs = gui.session().figures().polish_costs;
  ASSERT_GT(costs.size(), 2U);
  EXPECT_LT(costs.back(), 0.9 * costs.front());
  EXPECT_TRUE(gui.session().project().run->is_proved);
}

TEST(PolishPanel, StopKeepsTheBestNet) {
  Gui gui;
  gui.open_sample("Bunny");
  const auto first = gui.session().project().tree;
  gui.enter("polish/seconds", "600");
  gui.key(' ');
  ASSERT_TRUE(gui.until([&] { return gui.session().figures().polish_costs.size() > 2; }));
  gui.session().stop();
  ASSERT_TRUE(gui.until([&] { return is_idle(gui) && gui.session().project().tree != first; }));
  EXPECT_TRUE(gui.session().project().run->is_proved);
}

}  // namespace
}  // namespace netwright::testing
