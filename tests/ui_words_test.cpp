// What the interface says and remembers: texts of the status bar, the speed slider, keys, settings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "tests/gui_support.h"
#include "ui/actions.h"
#include "ui/status.h"

namespace netwright::testing {
namespace {

TEST(StatusWords, CountWithTheRightNumber) {
  EXPECT_EQ(counted(1, "move", "moves"), "1 move");
  EXPECT_EQ(counted(0, "move", "moves"), "0 moves");
  EXPECT_EQ(counted(12000, "move", "moves"), "12\u2009000 moves");
  EXPECT_EQ(grouped(1234567), "1\u2009234\u2009567");
  EXPECT_EQ(grouped(999), "999");
}

TEST(StatusWords, SayHowHardAModelWillBe) {
  EXPECT_EQ(difficulty_text(0.2), "easy, hardly a move");
  EXPECT_EQ(difficulty_text(7.6), "easy, about 8 moves");
  EXPECT_EQ(difficulty_text(43.4), "easy, about 43 moves");
  EXPECT_EQ(difficulty_text(876), "medium, about 880 moves");
  EXPECT_EQ(difficulty_text(23456), "hard, about 23\u2009000 moves");
}

TEST(StatusWords, GiveTimesInTheUnitThatFits) {
  EXPECT_EQ(duration_text(0.00004), "under 0.1 ms");
  EXPECT_EQ(duration_text(0.0024), "2.4 ms");
  EXPECT_EQ(duration_text(0.44), "0.4 s");
  EXPECT_EQ(duration_text(12.2), "12 s");
  EXPECT_EQ(duration_text(125), "2 min 5 s");
}

TEST(StatusWords, AnEmptySessionHasNoModel) {
  const Session session([] { return 0.0; });
  EXPECT_EQ(status_of(session).text, "no model");
}

TEST(StatusWords, SayHowLongWorkStillTakesOnceThatCanBeTold) {
  EXPECT_EQ(seconds_left(0.01, 10), 0) << "too little is done to tell";
  EXPECT_EQ(seconds_left(0.5, 0.1), 0);
  EXPECT_EQ(seconds_left(1, 10), 0);
  EXPECT_DOUBLE_EQ(seconds_left(0.25, 3), 9);
}

TEST(SpeedSlider, GoesFromOneMoveASecondToFullSpeedAndBack) {
  EXPECT_DOUBLE_EQ(speed_of_slider(0), 1);
  EXPECT_TRUE(std::isinf(speed_of_slider(1)));
  double before = 0;
  for (double t = 0; t < 0.97; t += 0.05) {
    const double speed = speed_of_slider(t);
    EXPECT_GT(speed, before);
    EXPECT_NEAR(slider_of_speed(speed), t, 1e-9);
    before = speed;
  }
  EXPECT_EQ(speed_text(std::numeric_limits<double>::infinity()), "full speed");
  EXPECT_EQ(speed_text(1), "one move a second");
}

TEST(FacesSlider, GoesFromTheFewestToAllAndBack) {
  EXPECT_EQ(faces_of_slider(0, 20, 12000), 20);
  EXPECT_EQ(faces_of_slider(1, 20, 12000), 12000);
  EXPECT_NEAR(faces_of_slider(0.5, 20, 12000), std::sqrt(20.0 * 12000), 1);
  for (const int faces : {20, 33, 400, 5000, 12000})
    EXPECT_EQ(faces_of_slider(slider_of_faces(faces, 20, 12000), 20, 12000), faces);
  EXPECT_DOUBLE_EQ(slider_of_faces(6, 6, 6), 1);
  EXPECT_EQ(faces_of_slider(0.2, 6, 6), 6);
}

TEST(StatusWords, GiveLengthsAndFacesAsPeopleReadThem) {
  constexpr LengthUnit kMm = LengthUnit::Millimetre;
  EXPECT_EQ(length_text(0.002, kMm), "under 0.01 mm");
  EXPECT_EQ(length_text(0.034, kMm), "0.03 mm");
  EXPECT_EQ(length_text(0.84, kMm), "0.8 mm");
  EXPECT_EQ(length_text(9.97, kMm), "10 mm");
  EXPECT_EQ(area_text(215.9, 279.4, kMm), "216 × 279 mm");
  EXPECT_EQ(faces_text(400, 12000), "400 of 12\u2009000 faces");
  EXPECT_EQ(faces_text(370, 370), "370 faces");
}

TEST(StatusWords, GiveLengthsInInchesWhereThatIsWanted) {
  constexpr LengthUnit kInch = LengthUnit::Inch;
  EXPECT_EQ(length_text(0.01, kInch), "under 0.001 in");
  EXPECT_EQ(length_text(0.8, kInch), "0.031 in");
  EXPECT_EQ(length_text(31.75, kInch), "1.25 in");
  EXPECT_EQ(length_text(317.5, kInch), "12.5 in");
  EXPECT_EQ(area_text(215.9, 279.4, kInch), "8.5 × 11 in");
}

TEST(Shortcuts, AreNamedAsOnTheKeyboardAndNeverTwice) {
  EXPECT_EQ(shortcut_text(action(ActionId::Open).shortcut), "Ctrl+O");
  EXPECT_EQ(shortcut_text(action(ActionId::Unfold).shortcut), "Space");
  EXPECT_EQ(shortcut_text(action(ActionId::Stop).shortcut), "Esc");
  EXPECT_EQ(shortcut_text(action(ActionId::ToggleSide).shortcut), "F9");
  EXPECT_EQ(shortcut_text(action(ActionId::Keys).shortcut), "?");
  std::map<std::string, std::string_view> owner;
  for (const Action& entry : actions()) {
    const std::string keys = shortcut_text(entry.shortcut);
    if (keys.empty()) continue;
    EXPECT_TRUE(owner.emplace(keys, entry.name).second)
        << keys << ": " << owner[keys] << " and " << entry.name;
  }
}

TEST(Settings, KnowWhichPaperPrintersHoldWhere) {
  for (const char* locale : {"en_US.UTF-8", "fr_CA", "es_MX.UTF-8@x"})
    EXPECT_EQ(paper_of_locale(locale), "Letter") << locale;
  for (const char* locale : {"de_DE.UTF-8", "en_GB", "C", "C.UTF-8", "POSIX", "", "US"})
    EXPECT_EQ(paper_of_locale(locale), "A4") << locale;
  Settings settings;
  settings.paper = "A3";
  EXPECT_EQ(paper_of(settings), "A3") << "what the user chose counts";
}

TEST(SettingsFile, ComesBackAsItWasSaved) {
  const TemporaryFolder folder;
  Settings settings;
  settings.theme = ThemeChoice::Dark;
  settings.scale_percent = 150;
  settings.splitter = 0.25F;
  settings.show_tree = false;
  settings.unit = LengthUnit::Inch;
  settings.paper = "Letter";
  settings.autosave_minutes = 7;
  settings.threads = 3;
  settings.streams = 4;
  settings.time_limit_s = 0;
  settings.uses_desktop_dialogs = true;
  settings.is_open(Section::Paper) = false;
  settings.is_open(Section::History) = true;
  settings.is_done(FirstHint::Runs) = true;
  settings.window_width = 1200;
  settings.window_x = -40;
  settings.is_maximized = true;
  settings.show_textures = false;
  settings.recent = {"/tmp/a b.obj", "/tmp/ü.stl"};
  settings.export_folder = "/tmp/paper nets";
  const auto file = folder.path() / "deep" / "settings.conf";
  ASSERT_TRUE(save_settings(settings, file));
  EXPECT_EQ(load_settings(file), settings);
}

TEST(SettingsFile, NonsenseMeansTheDefaults) {
  const TemporaryFolder folder;
  EXPECT_EQ(load_settings(folder.path() / "none"), Settings());
  const auto file =
      folder.write("settings.conf",
                   "theme = purple\nunit = ell\npaper = Foolscap\nthreads = 1000\nautosave_minutes = "
                   "-2\nscale_percent = -3\nsplitter = 7\nshow_tree = maybe\n===\nx\n");
  EXPECT_EQ(load_settings(file), Settings());
}

TEST(SettingsFile, RemembersEachFileOnceAndOnlyTheLatest) {
  Settings settings;
  for (int i = 0; i < 20; ++i) remember(settings, "/tmp/" + std::to_string(i) + ".obj");
  remember(settings, "/tmp/15.obj");
  EXPECT_EQ(settings.recent.size(), Settings::kMaxRecent);
  EXPECT_EQ(settings.recent.front(), "/tmp/15.obj");
  EXPECT_EQ(std::count(settings.recent.begin(), settings.recent.end(), "/tmp/15.obj"), 1);
}

}  // namespace
}  // namespace netwright::testing
