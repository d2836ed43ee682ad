// Polish in the window: its rows count for the next net, and the net goes on getting better until it is over
// or stopped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/unfold/net_size.h"
#include "tests/gui_support.h"
#include "ui/panels.h"

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

TEST(PolishPanel, ChartsWhatTheCutsAndThePaperCameDownTo) {
  Gui gui;
  gui.open_sample("Bunny");
  EXPECT_FALSE(gui.widgets.find("polish/chart"));
  gui.enter("polish/seconds", "1");
  gui.key(' ');
  ASSERT_TRUE(gui.until([&] { return gui.session().figures().polish_stations.size() > 1; }));
  gui.frames(2);
  EXPECT_TRUE(gui.widgets.find("polish/chart")) << "while it goes on";
  const auto first = gui.session().project().tree;
  ASSERT_TRUE(gui.until([&] { return is_idle(gui) && gui.session().project().tree != first; }));
  gui.frames(2);
  EXPECT_TRUE(gui.widgets.find("polish/chart")) << "and when it is over";
  const RunFigures figures = gui.session().figures();
  const Net& net = gui.session().shown()->net;
  EXPECT_DOUBLE_EQ(figures.polish_stations.back().cut_length, cut_length(net));
  EXPECT_DOUBLE_EQ(figures.polish_stations.back().paper, paper_area(piece_hulls(net)));
  const double cuts = figures.polish_stations.back().cut_length / figures.polish_stations.front().cut_length;
  EXPECT_LT(cuts, 1);
  EXPECT_TRUE(polish_shares(figures).starts_with("Cuts " + std::to_string(std::lround(100 * cuts)) + " %"))
      << polish_shares(figures);
}

TEST(PolishPanel, TheTimelineMarksItsPlaceInTheChart) {
  Gui gui;
  gui.open_sample("Bunny");
  gui.enter("polish/seconds", "1");
  gui.key(' ');
  ASSERT_TRUE(gui.until([&] { return is_idle(gui) && !gui.session().runs().empty(); }));
  gui.session().view_run(gui.session().runs().back()->number);
  ASSERT_TRUE(gui.session().timeline());
  const int last = gui.session().timeline()->n_steps - 1;
  const std::vector<PolishStation> stations = gui.session().figures().polish_stations;
  gui.session().seek(last - 1);
  const double before = gui.session().figures().at_polish;
  EXPECT_TRUE(std::ranges::find(stations, before, &PolishStation::fraction) != stations.end());
  EXPECT_LT(before, stations.back().fraction);
  gui.session().seek(0);
  EXPECT_LT(gui.session().figures().at_polish, 0) << "the search, before there was a net";
}

/// How far the corners of the net as it is drawn went between two frames, at most.
class Motion {
 public:
  double next(Gui& gui) {
    const Net* net = gui.app.workspace().scene().net();
    double way = 0;
    std::vector<glm::dvec2> corners;
    for (const HalfedgeId h : net->mesh().halfedges()) corners.push_back(net->corner(h));
    for (std::size_t i = 0; i < last_.size(); ++i) way = std::max(way, glm::distance(corners[i], last_[i]));
    last_ = std::move(corners);
    return way;
  }

 private:
  std::vector<glm::dvec2> last_;
};

TEST(PolishView, TheNetGlidesFromOneProvedNetToTheNext) {
  Gui gui;
  gui.ui().settings.show_pages = false;
  gui.open_sample("Bunny");
  gui.enter("polish/seconds", "1");
  gui.key(' ');
  ASSERT_TRUE(gui.until([&] { return is_idle(gui) && !gui.session().runs().empty(); }));
  gui.session().view_run(gui.session().runs().back()->number);
  const int last = gui.session().timeline()->n_steps - 1;
  const Scene& scene = gui.app.workspace().scene();
  const auto show = [&](int position) {
    const auto before = gui.session().shown();
    gui.session().seek(position);
    return gui.until([&] { return gui.session().shown() != before; });
  };
  ASSERT_TRUE(show(last - 1));
  gui.frames(60);
  Motion motion;
  motion.next(gui);
  const Net before = *scene.net();
  ASSERT_TRUE(show(last));
  gui.frames();
  ASSERT_TRUE(scene.is_gliding());
  double most = 0;
  int n_frames = 0;
  for (double step = 1; step > 0 && n_frames < 100; ++n_frames) {
    gui.frames();
    step = motion.next(gui);
    most = std::max(most, step);
  }
  EXPECT_GT(n_frames, 5);
  EXPECT_LT(n_frames, 100) << "and rests then";
  const Net& own = gui.session().shown()->net;
  const Net drawn = *scene.net();
  const HalfedgeId first = own.mesh().first(FaceId(0));
  double way = 0;
  double way_of_own = 0;
  for (const HalfedgeId h : own.mesh().halfedges()) {
    ASSERT_NEAR(glm::distance(drawn.corner(h), drawn.corner(first)),
                glm::distance(own.corner(h), own.corner(first)), 1e-9)
        << "it ends as the net is, wherever that lies";
    way = std::max(way, glm::distance(drawn.corner(h), before.corner(h)));
    way_of_own += std::pow(glm::distance(own.corner(h), before.corner(h)), 2);
    way_of_own -= std::pow(glm::distance(drawn.corner(h), before.corner(h)), 2);
  }
  EXPECT_GT(most, 0);
  EXPECT_LT(most, 0.6 * way) << "no jump";
  EXPECT_GT(way_of_own, 0) << "the net keeps its place better than its root would";
  gui.session().view_run(0);
  gui.frames(60);
  EXPECT_FALSE(scene.is_gliding());
  for (const HalfedgeId h : own.mesh().halfedges())
    ASSERT_NEAR(glm::distance(scene.net()->corner(h), gui.session().shown()->net.corner(h)), 0, 1e-9);
}

TEST(PolishView, NothingGlidesWhereTheDesktopAsksForLessMotion) {
  Gui gui;
  gui.ui().is_motion_reduced = true;
  gui.ui().settings.show_pages = false;
  gui.open_sample("Bunny");
  gui.enter("polish/seconds", "1");
  gui.key(' ');
  bool has_glided = false;
  ASSERT_TRUE(gui.until([&] {
    has_glided |= gui.app.workspace().scene().is_gliding();
    return is_idle(gui) && !gui.session().runs().empty();
  }));
  EXPECT_FALSE(has_glided);
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
