// Finished runs as a person meets them: the list, the timeline under the net, the history, by mouse and by
// keys.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/base/random.h"
#include "tests/gui_support.h"
#include "tests/model_files.h"
#include "tests/support.h"
#include "ui/timeline.h"

namespace netwright::testing {
namespace {

/// Nearly flat terrain, full of saddles: its searches have many moves.
std::string terrain() {
  PolygonSoup soup = shapes::bumpy_patch(9, 9);
  Random random(1);
  for (glm::dvec3& p : soup.points) p.y = 0.05 * random.unit();
  return shapes::to_obj(soup);
}

/// A terrain with three finished runs; the last one's net is the project's.
void run_thrice(Gui& gui) {
  gui.session().open_bytes("terrain.obj", terrain());
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); }));
  gui.ui().settings.is_open(Section::Solve) = false;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    gui.session().set_seed(seed);
    ASSERT_TRUE(gui.unfold());
  }
  gui.frames(3);
  ASSERT_EQ(gui.session().runs().size(), 3U);
}

TEST(RunsPanel, ListsFinishedRunsTheNewestOnTop) {
  Gui gui;
  run_thrice(gui);
  EXPECT_LT(gui.rect("runs/3").min.y, gui.rect("runs/2").min.y);
  EXPECT_LT(gui.rect("runs/2").min.y, gui.rect("runs/1").min.y);
  EXPECT_FALSE(gui.rect("runs/accept").is_enabled) << "nothing is looked at";
  EXPECT_TRUE(gui.rect("runs/export-best").is_enabled);
}

TEST(RunsPanel, AClickLooksAndAnotherOneGoesBack) {
  Gui gui;
  run_thrice(gui);
  const Project before = gui.session().project();
  gui.click("runs/1");
  EXPECT_EQ(gui.session().viewed_run(), 1);
  ASSERT_TRUE(gui.until([&] { return gui.session().shown()->net.tree == *gui.session().runs()[0]->tree; }));
  EXPECT_EQ(gui.session().project(), before);
  gui.click("runs/1");
  EXPECT_EQ(gui.session().viewed_run(), 0);
  gui.click("runs/2");
  gui.key(keys::kEscape);
  EXPECT_EQ(gui.session().viewed_run(), 0);
}

TEST(RunsPanel, TakesAnotherRunsNetAndUndoesIt) {
  Gui gui;
  run_thrice(gui);
  gui.click("runs/1");
  gui.click("runs/accept");
  EXPECT_EQ(gui.session().accepted_run(), 1);
  gui.key('Z', kControl);
  EXPECT_EQ(gui.session().accepted_run(), 3);
}

TEST(RunsPanel, ObeysTheKeyboard) {
  Gui gui;
  run_thrice(gui);
  gui.key(keys::kPageDown);
  EXPECT_EQ(gui.session().viewed_run(), 2) << "the one below the present net's";
  gui.key(keys::kPageDown);
  gui.key(keys::kPageDown);
  EXPECT_EQ(gui.session().viewed_run(), 1);
  gui.key(keys::kPageUp);
  EXPECT_EQ(gui.session().viewed_run(), 2);
  gui.key(keys::kEnter);
  EXPECT_EQ(gui.session().accepted_run(), 2);
  gui.key(keys::kPageDown);
  gui.key(keys::kDelete, kShift);
  EXPECT_EQ(gui.session().runs().size(), 2U);
  EXPECT_EQ(gui.session().viewed_run(), 2) << "the neighbour is looked at next";
}

TEST(RunsPanel, TheBestRunIsExportedWhileASearchGoesOn) {
  Gui gui;
  const TemporaryFolder folder;
  run_thrice(gui);
  gui.session().set_speed(1);
  gui.session().new_seed();
  gui.frames(3);
  EXPECT_FALSE(gui.rect("toolbar/Export PDF…").is_enabled);
  EXPECT_FALSE(gui.rect("runs/1").is_enabled) << "the search is what is shown";
  gui.click("runs/export-best");
  ASSERT_TRUE(gui.widgets.find("dialog/accept").has_value());
  gui.session().export_run(gui.ui().export_run, folder.path() / "best.pdf");
  EXPECT_TRUE(gui.until([&] { return std::filesystem::exists(folder.path() / "best.pdf"); }));
  gui.key(keys::kEscape);
  gui.session().stop();
}

TEST(RunsPanel, ShowsAPictureOfTheNet) {
  Gui gui;
  run_thrice(gui);
  const WidgetRect row = gui.rect("runs/1");
  gui.point({2, 2});
  const Image window = gui.window.read_pixels();
  // The picture is at the left of the row: paper on a desk, two tones at least.
  double least = 255;
  double most = 0;
  for (int y = 10; y < 66; y += 4)
    for (int x = 10; x < 78; x += 4) {
      const double tone =
          brightness(window, {static_cast<int>(row.min.x) + x, static_cast<int>(row.min.y) + y});
      least = std::min(least, tone);
      most = std::max(most, tone);
    }
  EXPECT_GT(most - least, 12);
}

TEST(Timeline, GoesThroughTheMovesByMouseAndKeys) {
  Gui gui;
  run_thrice(gui);
  EXPECT_FALSE(gui.widgets.find("timeline/slider").has_value());
  gui.click("runs/1");
  gui.frames(3);
  const WidgetRect slider = gui.rect("timeline/slider");
  const int n = gui.session().timeline()->n_steps;
  ASSERT_GT(n, 20);
  gui.drag({slider.max.x - 8, slider.centre().y}, {slider.centre().x, slider.centre().y});
  EXPECT_NEAR(gui.session().timeline()->position, n * 0.5, n * 0.1);
  const int middle = gui.session().timeline()->position;
  gui.key(keys::kLeft);
  EXPECT_EQ(gui.session().timeline()->position, middle - 1);
  gui.key(keys::kRight);
  gui.key(keys::kRight);
  EXPECT_EQ(gui.session().timeline()->position, middle + 1);
  gui.click("timeline/back");
  EXPECT_EQ(gui.session().timeline()->position, middle);
  const RunLog& log = *gui.session().runs()[0]->log;
  EXPECT_EQ(gui.session().figures().overlaps, log.overlaps(middle));
  ASSERT_TRUE(gui.until([&] { return !gui.session().shown()->is_proved; }));
  gui.key('V');
  EXPECT_TRUE(gui.session().timeline()->is_playing);
  gui.frames(60);
  EXPECT_GT(gui.session().timeline()->position, middle);
  gui.click("timeline/play");
  EXPECT_FALSE(gui.session().timeline()->is_playing);
  gui.key(keys::kEscape);
  gui.frames(3);
  EXPECT_FALSE(gui.widgets.find("timeline/slider").has_value());
}

TEST(Timeline, PlaysFasterWhenItsSpeedIsDraggedUp) {
  Gui gui;
  run_thrice(gui);
  gui.click("runs/1");
  gui.frames(3);
  const WidgetRect speed = gui.rect("timeline/speed");
  const double before = gui.session().timeline()->speed;
  gui.drag(centre(speed), {speed.max.x - 1, speed.centre().y});
  EXPECT_GT(gui.session().timeline()->speed, before);
}

TEST(Timeline, ItsSpeedsReachFromOneMoveASecondToTheWholeRunInTwoSeconds) {
  EXPECT_DOUBLE_EQ(play_speed_of_slider(0, 500000), 1);
  EXPECT_NEAR(play_speed_of_slider(1, 500000), 250000, 1e-6);
  for (const double t : {0.0, 0.3, 0.9, 1.0})
    EXPECT_NEAR(slider_of_play_speed(play_speed_of_slider(t, 800), 800), t, 1e-12);
}

TEST(HistoryPanel, ListsStepsAndGoesToThem) {
  Gui gui;
  run_thrice(gui);
  gui.session().pin_root(FaceId(4));
  gui.ui().settings.is_open(Section::Runs) = false;
  gui.ui().settings.is_open(Section::Paper) = false;
  gui.key('H', kControl);
  ASSERT_TRUE(gui.widgets.find("history/4").has_value());
  EXPECT_FALSE(gui.widgets.find("history/5").has_value());
  gui.click("history/1");
  EXPECT_EQ(gui.session().history_position(), 1U);
  EXPECT_EQ(gui.session().accepted_run(), 1);
  gui.click("history/4");
  EXPECT_EQ(gui.session().project().pins.root, FaceId(4));
  gui.click("history/0");
  EXPECT_EQ(gui.session().project().tree, nullptr);
}

TEST(RunsPanel, EverythingFitsANarrowWindow) {
  Gui gui({1024, 700});
  run_thrice(gui);
  gui.click("runs/1");
  gui.frames(3);
  for (const char* name : {"timeline/back", "timeline/play", "timeline/on", "timeline/slider"}) {
    const WidgetRect rect = gui.rect(name);
    EXPECT_GE(rect.min.x, 280) << name;
    EXPECT_LE(rect.max.x, 1024) << name;
    EXPECT_LE(rect.max.y, 700) << name;
  }
  for (const char* name : {"runs/accept", "runs/export-best", "runs/delete"})
    EXPECT_LE(gui.rect(name).max.x, 280) << name;
}

}  // namespace
}  // namespace netwright::testing
