// What the editor remembers of files and folders, over restarts: in the menu, in the empty state, in the
// dialogs that open and export.
#include <gtest/gtest.h>

#include "core/mesh/shapes.h"
#include "tests/gui_support.h"
#include "ui/recent_files.h"

namespace netwright::testing {
namespace {

namespace fs = std::filesystem;

class RecentFiles : public ::testing::Test {
 protected:
  RecentFiles() {
    fs::create_directories(folder.path() / "models");
    fs::create_directories(folder.path() / "other");
    cube = folder.write("models/cube.obj", shapes::to_obj(shapes::cube(), ""));
    other_cube = folder.write("other/cube.obj", shapes::to_obj(shapes::grid_cube(2), ""));
  }

  [[nodiscard]] std::unique_ptr<Gui> start() const {
    return std::make_unique<Gui>(glm::ivec2(1440, 900), 1, folder.path() / "settings.conf");
  }
  static void open(Gui& gui, const fs::path& file) {
    gui.session().open(file);
    ASSERT_TRUE(gui.until([&] { return gui.session().has_model() && gui.session().project().path == file; }));
    gui.frames(3);
  }

  TemporaryFolder folder;
  fs::path cube;
  fs::path other_cube;
};

TEST_F(RecentFiles, AreInTheMenuAfterARestart) {
  {
    const auto gui = start();
    open(*gui, cube);
    open(*gui, other_cube);
  }
  const auto gui = start();
  EXPECT_EQ(gui->ui().settings.recent, (std::vector<fs::path>{other_cube, cube}));
  gui->click("menu/File");
  gui->click("menu/Recent");
  gui->click("menu/Recent/" + cube.string());
  ASSERT_TRUE(gui->until([&] { return gui->session().has_model(); }));
  EXPECT_EQ(gui->session().project().path, cube);
  gui->frames(3);
  EXPECT_EQ(gui->ui().settings.recent.front(), cube);
}

TEST_F(RecentFiles, AreRememberedAtOnce) {
  const auto gui = start();
  open(*gui, cube);
  const Settings saved = load_settings(folder.path() / "settings.conf");
  EXPECT_EQ(saved.recent, std::vector<fs::path>{cube}) << "even if the editor dies now";
}

TEST_F(RecentFiles, OpenFromTheEmptyState) {
  {
    const auto gui = start();
    open(*gui, cube);
  }
  const auto gui = start();
  gui->click("recent/cube.obj");
  ASSERT_TRUE(gui->until([&] { return gui->session().has_model(); }));
  EXPECT_EQ(gui->session().project().path, cube);
}

TEST_F(RecentFiles, AreForgottenWhenTheyAreGone) {
  {
    const auto gui = start();
    open(*gui, cube);
  }
  fs::remove(cube);
  const auto gui = start();
  gui->click("recent/cube.obj");
  gui->frames(3);
  EXPECT_TRUE(gui->ui().settings.recent.empty());
  ASSERT_EQ(gui->ui().toasts.size(), 1U);
  EXPECT_NE(gui->ui().toasts.front().text.find("cube.obj is no longer in "), std::string::npos);
  EXPECT_TRUE(gui->ui().error.empty());
}

TEST_F(RecentFiles, AreForgottenOnRequest) {
  const auto gui = start();
  open(*gui, cube);
  gui->click("menu/File");
  gui->click("menu/Recent");
  gui->click("menu/Recent/Forget these files");
  gui->frames(3);
  EXPECT_TRUE(gui->ui().settings.recent.empty());
  gui->click("menu/File");
  EXPECT_FALSE(gui->widgets.find("menu/Recent").has_value());
}

TEST_F(RecentFiles, LeadTheOpenDialogToTheirFolder) {
  {
    const auto gui = start();
    open(*gui, cube);
    open(*gui, other_cube);
  }
  {
    const auto gui = start();
    gui->key('O', kControl);
    gui->frames(4);
    gui->double_click(centre(gui->rect("browser/cube.obj")));
    ASSERT_TRUE(gui->until([&] { return gui->session().has_model(); }));
    EXPECT_EQ(gui->session().project().path, other_cube);
  }
  fs::remove_all(folder.path() / "other");
  Settings settings = load_settings(folder.path() / "settings.conf");
  EXPECT_EQ(latest_folder(settings), folder.path() / "models")
      << "a folder that is gone is no place to start";
}

TEST_F(RecentFiles, TheFolderOfExportsIsRemembered) {
  {
    const auto gui = start();
    open(*gui, cube);
    ASSERT_TRUE(gui->unfold());
    ASSERT_TRUE(gui->until([&] { return gui->session().sheets() != nullptr; }));
    gui->key('P', kControl);
    gui->enter("browser/folder", (folder.path() / "other").string());
    gui->click("dialog/accept");
    ASSERT_TRUE(gui->until([&] { return fs::exists(folder.path() / "other" / "cube.pdf"); }));
    gui->frames(3);
  }
  EXPECT_EQ(load_settings(folder.path() / "settings.conf").export_folder,
            fs::weakly_canonical(folder.path() / "other"));
}

TEST(FolderText, IsShort) {
  EXPECT_EQ(folder_text("/srv/a.obj"), "/srv");
  EXPECT_EQ(folder_text("/media/stick/a folder with a name/that goes on and on and on/models/a.obj"),
            "/media/…/models");
}

}  // namespace
}  // namespace netwright::testing
