// Project files in the window: save, open, the question about unsaved changes, and recovery.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "core/project/project_file.h"
#include "tests/gui_support.h"
#include "tests/support.h"
#include "ui/actions.h"
#include "ui/recovery.h"

namespace netwright::testing {
namespace {

namespace fs = std::filesystem;

/// A cube whose size was changed: work that could be lost.
void make_changes(Gui& gui, double height_mm = 77) {
  if (!gui.session().has_model()) gui.open_sample("Cube");
  gui.session().set_size({PrintSize::Kind::Height, height_mm});
  gui.frames(2);
}

bool is_asked(const Gui& gui) { return gui.widgets.find("unsaved/text").has_value(); }

void save_as(Gui& gui, const fs::path& file) {
  gui.key('S', kControl | kShift);
  gui.enter("browser/name", file.string());
  if (gui.widgets.find("dialog/accept")) gui.click("dialog/accept");
  ASSERT_TRUE(gui.until([&] { return !gui.session().is_saving(); }));
  gui.frames(3);
}

double height_in(const fs::path& file) { return load_project(file).project.size.height_mm; }

TEST(ProjectGui, SavesUnderANameAndThenToTheSameFile) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "cube.netwright";
  Gui gui;
  gui.open_sample("Cube");
  EXPECT_EQ(gui.window.title().find("•"), std::string::npos) << gui.window.title();
  make_changes(gui);
  EXPECT_TRUE(gui.window.title().starts_with("• cube.obj")) << gui.window.title();
  save_as(gui, file);
  EXPECT_EQ(height_in(file), 77);
  EXPECT_TRUE(gui.window.title().starts_with("cube.netwright")) << gui.window.title();
  EXPECT_EQ(gui.ui().settings.recent.front(), file);
  make_changes(gui, 78);
  gui.key('S', kControl);
  ASSERT_TRUE(gui.until([&] { return !gui.session().is_modified(); }));
  EXPECT_EQ(height_in(file), 78);
  EXPECT_EQ(gui.ui().dialog, Dialog::None);
}

TEST(ProjectGui, SavingForTheFirstTimeAsksForAName) {
  const TemporaryFolder folder;
  Gui gui;
  make_changes(gui);
  gui.click("toolbar/Save");
  EXPECT_EQ(gui.ui().dialog, Dialog::Save);
  gui.key(keys::kEscape);
  EXPECT_EQ(gui.ui().dialog, Dialog::None);
  EXPECT_TRUE(gui.session().is_modified());
}

TEST(ProjectGui, OpensADroppedProjectWithItsNet) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "ball.netwright";
  {
    Gui gui;
    gui.open_sample("Icosphere");
    ASSERT_TRUE(gui.unfold());
    save_as(gui, file);
  }
  Gui gui;
  gui.window.drop({file});
  gui.frames(2);
  ASSERT_TRUE(gui.until([&] { return gui.session().sheets() != nullptr; })) << gui.ui().error;
  gui.frames(3);
  EXPECT_TRUE(gui.session().shown()->is_proved);
  EXPECT_TRUE(gui.window.title().starts_with("ball.netwright – one piece, proved")) << gui.window.title();
  EXPECT_TRUE(gui.app.workspace().scene().is_on_pages());
}

TEST(ProjectGui, ClosingWithNothingUnsavedAsksNothing) {
  Gui gui;
  gui.open_sample("Cube");
  gui.key('Q', kControl);
  EXPECT_TRUE(gui.app.is_over());
}

TEST(ProjectGui, ClosingAsksAboutUnsavedChangesAndCancelStays) {
  Gui gui;
  make_changes(gui);
  gui.window.request_close();
  gui.frames(4);
  ASSERT_TRUE(is_asked(gui));
  EXPECT_FALSE(gui.app.is_over());
  gui.click("dialog/cancel");
  EXPECT_FALSE(gui.app.is_over());
  EXPECT_EQ(gui.ui().dialog, Dialog::None);
  gui.key('Q', kControl);
  ASSERT_TRUE(is_asked(gui));
  gui.key(keys::kEscape);
  EXPECT_FALSE(gui.app.is_over());
  gui.frames(5);
  EXPECT_FALSE(is_asked(gui)) << "it asks once";
}

TEST(ProjectGui, DontSaveClosesWithoutSaving) {
  Gui gui;
  make_changes(gui);
  gui.key('Q', kControl);
  gui.click("dialog/drop");
  EXPECT_TRUE(gui.app.is_over());
}

TEST(ProjectGui, SaveInTheQuestionSavesAndThenCloses) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "cube.netwright";
  Gui gui;
  make_changes(gui);
  save_as(gui, file);
  make_changes(gui, 99);
  gui.key('Q', kControl);
  gui.click("dialog/accept");
  ASSERT_TRUE(gui.until([&] { return gui.app.is_over(); }));
  EXPECT_EQ(height_in(file), 99);
}

TEST(ProjectGui, SaveInTheQuestionAsksForANameWhereThereIsNone) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "cube.netwright";
  Gui gui;
  make_changes(gui);
  gui.key('Q', kControl);
  gui.click("dialog/accept");
  ASSERT_EQ(gui.ui().dialog, Dialog::Save);
  gui.enter("browser/name", file.string());
  if (gui.widgets.find("dialog/accept")) gui.click("dialog/accept");
  ASSERT_TRUE(gui.until([&] { return gui.app.is_over(); }));
  EXPECT_EQ(height_in(file), 77);
}

TEST(ProjectGui, ASaveThatFailsDoesNotClose) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "stick");
  const fs::path file = folder.path() / "stick" / "cube.netwright";
  Gui gui;
  make_changes(gui);
  save_as(gui, file);
  make_changes(gui, 99);
  fs::remove_all(folder.path() / "stick");  // pulled out
  gui.key('Q', kControl);
  gui.click("dialog/accept");
  ASSERT_TRUE(gui.until([&] { return !gui.ui().error.empty(); }));
  gui.frames(5);
  EXPECT_FALSE(gui.app.is_over());
  EXPECT_TRUE(gui.session().is_modified());
  EXPECT_NE(gui.ui().error.find("Nothing is lost"), std::string::npos) << gui.ui().error;
  EXPECT_TRUE(gui.widgets.find("error/text").has_value());
}

TEST(ProjectGui, OpeningAnotherFileAsksToo) {
  const TemporaryFolder folder;
  const fs::path model = folder.write("other.obj", shapes::to_obj(shapes::octahedron()));
  Gui gui;
  make_changes(gui);
  gui.window.drop({model});
  gui.frames(4);
  ASSERT_TRUE(is_asked(gui));
  gui.click("dialog/cancel");
  EXPECT_EQ(gui.session().project().dual->mesh().n_faces(), 6U);
  gui.window.drop({model});
  gui.frames(4);
  gui.click("dialog/drop");
  ASSERT_TRUE(gui.until([&] { return gui.session().project().dual->mesh().n_faces() == 8; }));
  EXPECT_FALSE(gui.session().is_modified());
}

TEST(ProjectGui, ClosingWhileAnotherDialogIsOpenAsksAllTheSame) {
  Gui gui;
  make_changes(gui);
  gui.key('O', kControl);
  EXPECT_EQ(gui.ui().dialog, Dialog::Open);
  gui.window.request_close();
  gui.frames(8);
  ASSERT_TRUE(is_asked(gui));
  gui.click("dialog/drop");
  EXPECT_TRUE(gui.app.is_over());
}

TEST(ProjectGui, OffersWorkOfAnEditorThatDied) {
  const TemporaryFolder folder;
  const fs::path state = folder.path() / "state";
  fs::create_directories(state);
  {
    Gui gui;
    gui.session().keep_changes_in(state);
    make_changes(gui, 55);
    gui.now += 61;
    ASSERT_TRUE(gui.until([&] { return fs::exists(state / "1.netwright"); }));
  }  // gone without having been asked to quit
  {
    Gui gui;
    gui.session().keep_changes_in(state);
    ASSERT_TRUE(gui.until([&] { return gui.ui().dialog == Dialog::Recover; }));
    gui.frames(3);
    gui.click("dialog/later");
    EXPECT_EQ(gui.ui().dialog, Dialog::None);
    gui.frames(5);
    EXPECT_EQ(gui.ui().dialog, Dialog::None) << "once a start is enough";
    gui.click("menu/File");
    gui.click("menu/Recover unsaved work…");
    gui.frames(3);
    gui.click("recover/0/recover");
    ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); }));
    gui.frames(4);
    EXPECT_EQ(gui.ui().dialog, Dialog::None);
    EXPECT_EQ(gui.session().project().size.height_mm, 55);
    EXPECT_TRUE(gui.window.title().starts_with("• cube.obj")) << gui.window.title();
    gui.key('Q', kControl);
    ASSERT_TRUE(is_asked(gui));
    gui.click("dialog/drop");
    EXPECT_TRUE(gui.app.is_over());
  }
  EXPECT_TRUE(fs::is_empty(state)) << "who says so does not want it any more";
}

TEST(ProjectGui, DiscardedWorkIsGone) {
  const TemporaryFolder folder;
  const fs::path state = folder.path() / "state";
  {
    Gui gui;
    gui.session().keep_changes_in(state);
    make_changes(gui, 55);
    gui.now += 61;
    ASSERT_TRUE(gui.until([&] { return fs::exists(state / "1.netwright"); }));
  }
  Gui gui;
  gui.session().keep_changes_in(state);
  ASSERT_TRUE(gui.until([&] { return gui.ui().dialog == Dialog::Recover; }));
  gui.frames(3);
  gui.click("recover/0/discard");
  gui.frames(4);
  EXPECT_FALSE(fs::exists(state / "1.netwright"));
  EXPECT_EQ(gui.ui().dialog, Dialog::None);
  EXPECT_FALSE(gui.session().has_model());
}

TEST(MomentText, IsShortForRecentMoments) {
  setenv("TZ", "UTC", 1);
  using namespace std::chrono;
  const system_clock::time_point now{sys_days{2026y / March / 1} + 9h + 5min};
  EXPECT_EQ(moment_text(now - 1h, now), "today at 8:05");
  EXPECT_EQ(moment_text(now - 10h, now), "yesterday at 23:05");
  EXPECT_EQ(moment_text(now - 24h * 40, now), "20 January at 9:05");
  EXPECT_EQ(moment_text(now - 24h * 400, now), "25 January 2025 at 9:05");
}

}  // namespace
}  // namespace netwright::testing
