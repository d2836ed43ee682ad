// The interface as a person uses it: everything here goes through mouse, keys and dropped files, and looks at
// what the session and the screen say afterwards.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "core/mesh/formats.h"
#include "tests/gui_support.h"
#include "tests/support.h"
#include "ui/actions.h"
#include "ui/status.h"

namespace netwright::testing {
namespace {

std::string content_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void expect_toolbar_inside(Gui& gui) {
  const glm::ivec2 size = gui.window.size_px();
  int seen = 0;
  for (const auto& [name, rect] : gui.widgets.all()) {
    if (!name.starts_with("toolbar/")) continue;
    ++seen;
    EXPECT_GE(rect.min.x, 0) << name;
    EXPECT_LE(rect.max.x, static_cast<float>(size.x)) << name << " at " << size.x << "x" << size.y;
  }
  EXPECT_GE(seen, 10);
}

TEST(Gui, OpensASampleFromItsPicture) {
  Gui gui;
  gui.frames(8);
  EXPECT_EQ(gui.session().state(), RunState::Empty);
  gui.open_sample("Bunny");
  ASSERT_TRUE(gui.session().has_model());
  EXPECT_EQ(gui.session().project().dual->mesh().n_faces(), 370U);
  EXPECT_NE(gui.window.title().find("bunny_370"), std::string::npos) << gui.window.title();
}

TEST(Gui, OpensASampleFromTheMenu) {
  Gui gui;
  gui.click("menu/File");
  gui.click("menu/Samples");
  gui.click("menu/Samples/Cube");
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); }));
  EXPECT_EQ(gui.session().project().dual->mesh().n_faces(), 6U);
}

TEST(Gui, SpaceUnfoldsToTheEndAndTheStatusSaysSo) {
  Gui gui;
  gui.open_sample("Bunny");
  gui.key(keys::kSpace);
  ASSERT_TRUE(
      gui.until([&] { return gui.session().state() == RunState::Idle && gui.session().shown() != nullptr; }));
  const Status status = status_of(gui.session());
  EXPECT_EQ(status.tone, Tone::Good);
  EXPECT_TRUE(status.text.starts_with("one piece, proved · 370 faces")) << status.text;
  gui.frames(2);
  EXPECT_NE(gui.window.title().find("one piece, proved"), std::string::npos);
  EXPECT_TRUE(gui.app.workspace().scene().is_on_pages());
}

TEST(Gui, ThePlayedBackSearchCanBeSkippedWithEscape) {
  Gui gui;
  gui.open_sample("Bunny");
  gui.key(keys::kSpace);
  ASSERT_TRUE(gui.until([&] { return gui.session().state() == RunState::Replaying; }));
  const double before = gui.now;
  gui.key(keys::kEscape);
  EXPECT_EQ(gui.session().state(), RunState::Idle);
  EXPECT_LT(gui.now - before, 0.2);
  EXPECT_TRUE(gui.session().shown()->is_proved);
}

TEST(Gui, PausesStepsAndStops) {
  Gui gui;
  gui.session().open_bytes("hats.obj", shapes::to_obj(endless_search()));
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); }));
  gui.key('S');
  ASSERT_TRUE(gui.until([&] { return gui.session().figures().moves == 1; }));
  EXPECT_EQ(gui.session().state(), RunState::Paused);
  gui.frames(30);
  EXPECT_EQ(gui.session().figures().moves, 1) << "a paused search must stand still";
  gui.key('S');
  ASSERT_TRUE(gui.until([&] { return gui.session().figures().moves == 2; }));
  ASSERT_NE(gui.session().shown(), nullptr);
  EXPECT_TRUE(gui.session().shown()->last_move.has_value());
  EXPECT_TRUE(gui.widgets.find("progress/stop").has_value());
  gui.click("toolbar/Stop");
  ASSERT_TRUE(gui.until([&] { return gui.session().state() == RunState::Idle; }));
  EXPECT_TRUE(status_of(gui.session()).in_short.ends_with("left")) << status_of(gui.session()).in_short;
}

TEST(Gui, SpacePausesASlowSearchAndGoesOn) {
  Gui gui;
  gui.open_sample("Teapot");
  gui.session().set_speed(1);
  gui.click("toolbar/Unfold");
  ASSERT_TRUE(gui.until([&] { return gui.session().figures().moves >= 1; }));
  EXPECT_EQ(gui.session().state(), RunState::Running);
  gui.key(keys::kSpace);
  EXPECT_EQ(gui.session().state(), RunState::Paused);
  gui.key(keys::kSpace);
  EXPECT_EQ(gui.session().state(), RunState::Running);
  gui.key(keys::kEscape);
  EXPECT_TRUE(gui.until([&] { return gui.session().state() == RunState::Idle; }));
}

TEST(Gui, TheSpeedSliderReachesFromOneMoveASecondToFullSpeed) {
  Gui gui;
  gui.open_sample("Cube");
  const WidgetRect slider = gui.rect("toolbar/speed");
  gui.drag(centre(slider), {slider.min.x + 1, slider.centre().y});
  EXPECT_DOUBLE_EQ(gui.session().speed(), 1);
  gui.drag({slider.min.x + 8, slider.centre().y}, {slider.max.x + 20, slider.centre().y});
  EXPECT_TRUE(std::isinf(gui.session().speed()));
}

TEST(Gui, NewSeedAndTypedSeedsReachTheProject) {
  Gui gui;
  gui.open_sample("Icosphere");
  const auto before = gui.session().project().seed;
  gui.key('N');
  EXPECT_EQ(gui.session().project().seed, before + 1);
  EXPECT_TRUE(gui.until([&] { return gui.session().state() == RunState::Idle; }));
  gui.enter("solve/seed", "77");
  EXPECT_EQ(gui.session().project().seed, 77U);
}

TEST(Gui, LettersTypedIntoAFieldAreNoShortcuts) {
  Gui gui;
  gui.open_sample("Icosphere");
  gui.click("solve/seed");
  const auto before = gui.session().project().seed;
  gui.key('N');
  EXPECT_EQ(gui.session().project().seed, before);
  EXPECT_EQ(gui.session().state(), RunState::Idle);
}

TEST(Gui, PinsTheFaceUnderThePointerAndUndoesIt) {
  Gui gui;
  gui.open_sample("Bunny");
  gui.point(centre(gui.rect("model/picture")));
  const FaceId face = gui.ui().hovered;
  ASSERT_TRUE(face.is_valid());
  gui.key('R');
  EXPECT_EQ(gui.session().project().pins.root, face);
  gui.key('Z', kControl);
  EXPECT_FALSE(gui.session().project().pins.root.is_valid());
  gui.key('Y', kControl);
  EXPECT_EQ(gui.session().project().pins.root, face);
  ASSERT_TRUE(gui.unfold());
  EXPECT_TRUE(gui.session().shown()->net.tree.is_root(face)) << "runs must keep the pinned root";
  gui.point(centre(gui.rect("toolbar/Pin root")));
  ASSERT_FALSE(gui.ui().hovered.is_valid());
  gui.click("toolbar/Pin root");
  EXPECT_FALSE(gui.session().project().pins.root.is_valid()) << "the button lets go of the pin";
}

TEST(Gui, AFaceUnderThePointerLightsUpInBothViews) {
  Gui gui;
  gui.open_sample("Sand clock");
  ASSERT_TRUE(gui.unfold());
  gui.point({2, 2});
  const Image before = gui.app.workspace().scene().states().size() > 0 ? gui.window.read_pixels() : Image();
  const FaceId face(5);
  gui.point(gui.net_pixel(face));
  EXPECT_EQ(gui.ui().hovered, face);
  gui.frames(2);
  EXPECT_TRUE(gui.app.workspace().scene().states().has(face, FaceState::Hovered));
  EXPECT_NE(gui.ui().hint.find("Face 6"), std::string::npos) << gui.ui().hint;
  gui.click("net/picture");
  gui.point(centre(gui.rect("model/picture")));
  const FaceId in_space = gui.ui().hovered;
  ASSERT_TRUE(in_space.is_valid());
  const Image after = gui.window.read_pixels();
  const auto pixel = glm::ivec2(gui.net_pixel(in_space));
  EXPECT_GT(
      std::abs(brightness(after, pixel + glm::ivec2(7, 0)) - brightness(before, pixel + glm::ivec2(7, 0))), 1)
      << "the net's picture must show what is hovered in space";
}

TEST(Gui, ClickSelectsAndEscapeClears) {
  Gui gui;
  gui.open_sample("Cube");
  gui.click("model/picture");
  EXPECT_TRUE(gui.ui().selected.is_valid());
  gui.key(keys::kEscape);
  EXPECT_FALSE(gui.ui().selected.is_valid());
}

TEST(Gui, MouseMovesTheCameras) {
  Gui gui;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  const glm::dvec2 space = centre(gui.rect("model/picture"));
  const OrbitCamera seen = gui.app.workspace().model_view().camera();
  gui.drag(space, space + glm::dvec2(60, 20));
  EXPECT_NE(gui.app.workspace().model_view().camera().view(), seen.view());
  const WidgetRect net = gui.rect("net/picture");
  const glm::dvec2 corner(net.min.x + 4, net.min.y + 4);
  const glm::dvec2 middle = gui.app.workspace().net_view().camera().centre();
  gui.drag(corner, corner + glm::dvec2(50, 40));
  EXPECT_NE(gui.app.workspace().net_view().camera().centre(), middle);
  const double zoom = gui.app.workspace().net_view().camera().pixels_per_unit();
  gui.point(centre(net));
  gui.window.scroll({0, 2});
  gui.frames(2);
  EXPECT_GT(gui.app.workspace().net_view().camera().pixels_per_unit(), zoom);
  gui.key('F');
  EXPECT_NEAR(gui.app.workspace().net_view().camera().pixels_per_unit(), zoom, zoom * 1e-9);
}

TEST(Gui, DoubleClickCentresAFaceInBothViews) {
  Gui gui;
  gui.open_sample("Bunny");
  ASSERT_TRUE(gui.unfold());
  const FaceId face(100);
  gui.double_click(gui.net_pixel(face));
  EXPECT_LT(glm::length(gui.app.workspace().model_view().camera().target() -
                        gui.session().project().dual->mesh().centre(face)),
            1e-9);
}

TEST(Gui, ExportsAPdfAndAsksBeforeReplacingIt) {
  Gui gui;
  const TemporaryFolder folder;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  gui.key('P', kControl);
  gui.enter("browser/folder", folder.path().string());
  gui.click("dialog/accept");
  const auto file = folder.path() / "cube.pdf";
  ASSERT_TRUE(gui.until([&] { return std::filesystem::exists(file) && gui.session().chore() == nullptr; }));
  EXPECT_TRUE(content_of(file).starts_with("%PDF"));
  std::ofstream(file) << "mine";
  gui.key('P', kControl);
  gui.click("dialog/accept");
  EXPECT_EQ(content_of(file), "mine") << "an existing file must not be replaced without a question";
  gui.click("dialog/accept");
  EXPECT_TRUE(gui.until([&] { return content_of(file).starts_with("%PDF"); }));
}

TEST(Gui, ExportsTheFormatThatWasChosen) {
  Gui gui;
  const TemporaryFolder folder;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  gui.key('P', kControl);
  gui.enter("browser/folder", folder.path().string());
  gui.click("export/format/SVG");
  gui.click("dialog/accept");
  ASSERT_TRUE(gui.until([&] { return std::filesystem::exists(folder.path() / "cube.svg"); }));
  EXPECT_NE(content_of(folder.path() / "cube.svg").find("<svg"), std::string::npos);
}

TEST(Gui, ExportsAFolderForACutterAndReplacesItWhenAsked) {
  Gui gui;
  const TemporaryFolder folder;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  for (int round = 0; round < 2; ++round) {
    gui.click("menu/File");
    gui.click("menu/Export as");
    gui.click("menu/Laser cutter folder…");
    gui.enter("browser/folder", folder.path().string());
    EXPECT_FALSE(gui.widgets.find("export/format/PDF").has_value()) << "nothing to choose among";
    gui.click("dialog/accept");
    if (round == 1) gui.click("dialog/accept");  // "Replace"
    ASSERT_TRUE(gui.until([&] { return gui.session().chore() == nullptr; }));
    const auto svg = folder.path() / "cube.laser" / "cube-cut.svg";
    ASSERT_TRUE(gui.until([&] { return content_of(svg).find("Fold Mountain") != std::string::npos; }));
    std::filesystem::remove(svg);
  }
}

TEST(Gui, OpensAFileFromTheBrowser) {
  Gui gui;
  const TemporaryFolder folder;
  const auto model = folder.write(
      "pyramid.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0.3 1 0.3\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n");
  (void)folder.write("notes.txt", "no model");
  gui.key('O', kControl);
  gui.enter("browser/folder", folder.path().string());
  EXPECT_FALSE(gui.widgets.find("browser/notes.txt").has_value())
      << "files that cannot be opened are not listed";
  gui.double_click(centre(gui.rect("browser/pyramid.obj")));
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); }));
  EXPECT_EQ(gui.session().project().dual->mesh().n_faces(), 4U);
  gui.frames(2);
  ASSERT_FALSE(gui.ui().settings.recent.empty());
  EXPECT_EQ(gui.ui().settings.recent.front(), model);
}

/// How colourful the model's view is: the largest distance between two channels of a pixel, in the mean.
double colourfulness(Gui& gui) {
  const WidgetRect area = gui.rect("model/picture");
  const Image image = gui.window.read_pixels();
  double sum = 0;
  int n = 0;
  for (int y = static_cast<int>(area.min.y) + 60; y < static_cast<int>(area.max.y) - 60; ++y)
    for (int x = static_cast<int>(area.min.x) + 60; x < static_cast<int>(area.max.x) - 60; ++x, ++n) {
      const auto k = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                          static_cast<std::size_t>(x));
      const auto [low, high] = std::minmax({image.rgba[k], image.rgba[k + 1], image.rgba[k + 2]});
      sum += high - low;
    }
  return sum / n;
}

TEST(Gui, TellsWhichFormatsCanBeOpened) {
  Gui gui;
  gui.key('O', kControl);
  gui.frames(4);
  EXPECT_FALSE(gui.widgets.find("formats/3DS").has_value());
  gui.click("dialog/formats");
  gui.frames(4);
  for (const ModelFormat& format : model_formats())
    EXPECT_TRUE(gui.widgets.find("formats/" + std::string(format.label)).has_value()) << format.label;
  const WidgetRect title = gui.rect("dialog/title");
  gui.click("dialog/title");
  gui.frames(4);
  EXPECT_FALSE(gui.widgets.find("formats/3DS").has_value()) << "a click beside it closes it";
  EXPECT_EQ(gui.rect("dialog/title").min.x, title.min.x) << "the dialog stays";
}

TEST(Gui, ShowsTheModelsOwnLooksWhileTheyAreOn) {
  Gui gui;
  gui.open_sample("Globe");
  gui.frames(3);
  const double dressed = colourfulness(gui);
  gui.click("model/Textures");
  gui.frames(3);
  EXPECT_FALSE(gui.ui().settings.show_textures);
  EXPECT_LT(colourfulness(gui), dressed / 2);
  gui.click("model/Textures");
  gui.frames(3);
  EXPECT_DOUBLE_EQ(colourfulness(gui), dressed);
}

TEST(Gui, HasNoLooksToHideOnAPlainModel) {
  Gui gui;
  gui.open_sample("Cube");
  gui.frames(3);
  EXPECT_FALSE(gui.rect("model/Textures").is_enabled);
  gui.click("model/Textures");
  EXPECT_TRUE(gui.ui().settings.show_textures);
}

TEST(Gui, ABrokenFileIsExplainedAndTheModelStays) {
  Gui gui;
  const TemporaryFolder folder;
  gui.open_sample("Cube");
  gui.window.drop({folder.write("broken.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n")});
  ASSERT_TRUE(gui.until([&] { return !gui.ui().error.empty(); }));
  EXPECT_NE(gui.ui().error.find("broken.obj"), std::string::npos) << gui.ui().error;
  EXPECT_EQ(gui.session().project().dual->mesh().n_faces(), 6U);
  gui.frames(3);
  gui.click("error/close");
  EXPECT_TRUE(gui.ui().error.empty());
}

TEST(Gui, AnOpeningThatWasGivenUpLeavesThePresentModel) {
  Gui gui;
  const TemporaryFolder folder;
  gui.open_sample("Cube");
  gui.session().open(folder.write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"));
  EXPECT_EQ(gui.session().state(), RunState::Opening);
  gui.session().cancel_opening();
  EXPECT_EQ(gui.session().state(), RunState::Idle);
  gui.frames(30);
  EXPECT_EQ(gui.session().project().dual->mesh().n_faces(), 6U);
}

TEST(Gui, DroppingAModelOpensIt) {
  Gui gui;
  const TemporaryFolder folder;
  gui.window.drop({folder.write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")});
  EXPECT_TRUE(gui.until([&] { return gui.session().has_model(); })) << gui.ui().error;
}

TEST(Gui, TheToolbarFitsEveryWindow) {
  Gui gui;
  gui.open_sample("Cube");
  for (const glm::ivec2 size : {glm::ivec2(1024, 700), glm::ivec2(1440, 900), glm::ivec2(2560, 1440)}) {
    gui.window.resize(size);
    gui.frames(4);
    expect_toolbar_inside(gui);
    const WidgetRect net = gui.rect("net/picture");
    EXPECT_LE(net.max.x, static_cast<float>(size.x));
    EXPECT_GT(net.max.x - net.min.x, 200);
  }
  gui.ui().settings.scale_percent = 200;
  for (const glm::ivec2 size : {glm::ivec2(1440, 900), glm::ivec2(1024, 700)}) {
    gui.window.resize(size);
    gui.frames(4);
    expect_toolbar_inside(gui);
    EXPECT_GT(gui.rect("net/picture").max.x - gui.rect("net/picture").min.x, 200);
  }
  EXPECT_FALSE(gui.widgets.find("section/Solve").has_value()) << "a narrow window belongs to the views";
}

TEST(Gui, TheThemeChangesFromTheMenu) {
  Gui gui;
  const glm::ivec2 bar(1300, 50);
  EXPECT_GT(brightness(gui.window.read_pixels(), bar), 200);
  gui.click("menu/View");
  gui.click("menu/Theme");
  gui.click("menu/Theme/Dark");
  gui.frames(3);
  EXPECT_LT(brightness(gui.window.read_pixels(), bar), 80);
}

TEST(Gui, TheSplitterMovesAndDoubleClickHalvesAgain) {
  Gui gui;
  gui.open_sample("Cube");
  const glm::dvec2 at = centre(gui.rect("splitter"));
  const float before = gui.rect("model/picture").max.x;
  gui.drag(at, at + glm::dvec2(150, 0));
  gui.frames(2);
  EXPECT_NEAR(gui.rect("model/picture").max.x, before + 150, 3);
  gui.double_click(centre(gui.rect("splitter")));
  EXPECT_FLOAT_EQ(gui.ui().settings.splitter, 0.5F);
}

TEST(Gui, TheSidePanelFoldsAwayAndItsSectionsToo) {
  Gui gui;
  gui.open_sample("Cube");
  EXPECT_TRUE(gui.widgets.find("solve/seed").has_value());
  gui.click("section/Solve");
  EXPECT_FALSE(gui.widgets.find("solve/seed").has_value());
  const float left = gui.rect("model/picture").min.x;
  gui.key(keys::kF9);
  EXPECT_FALSE(gui.widgets.find("section/Solve").has_value());
  EXPECT_LT(gui.rect("model/picture").min.x, left);
}

TEST(Gui, PaperAndSizeAreEditsThatCanBeUndone) {
  Gui gui;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  gui.click("paper/size/Height");
  EXPECT_EQ(gui.session().project().size.kind, PrintSize::Kind::Height);
  gui.enter("paper/height", "600");
  EXPECT_DOUBLE_EQ(gui.session().project().size.height_mm, 600);
  ASSERT_TRUE(
      gui.until([&] { return gui.session().sheets() != nullptr && gui.session().sheets()->size() > 1; }));
  gui.key('Z', kControl);
  gui.key('Z', kControl);
  EXPECT_EQ(gui.session().project().size.kind, PrintSize::Kind::FitPage);
}

TEST(Gui, QuestionMarkListsTheKeysAndEscapeClosesTheList) {
  Gui gui;
  gui.window.type_text("?");
  gui.frames(4);
  EXPECT_TRUE(gui.widgets.find("dialog/accept").has_value());
  gui.key(keys::kEscape);
  gui.frames(2);
  EXPECT_FALSE(gui.widgets.find("dialog/accept").has_value());
}

TEST(Gui, TogglesChangeWhatIsDrawn) {
  Gui gui;
  gui.open_sample("Bunny");
  ASSERT_TRUE(gui.unfold());
  gui.point({2, 2});
  const Image with_tree = gui.window.read_pixels();
  gui.key('T');
  EXPECT_FALSE(gui.ui().settings.show_tree);
  gui.frames(2);
  EXPECT_NE(gui.window.read_pixels().rgba, with_tree.rgba);
  gui.click("net/Pages");
  gui.frames(2);
  EXPECT_FALSE(gui.app.workspace().scene().is_on_pages());
}

TEST(Gui, TheQuitKeyEndsTheLoop) {
  Gui gui;
  gui.key('Q', kControl);
  EXPECT_TRUE(gui.app.is_over());
}

TEST(Gui, ClosingTheWindowEndsTheLoop) {
  Gui gui;
  gui.window.request_close();
  gui.frames();
  EXPECT_TRUE(gui.app.is_over());
}

TEST(Gui, EveryButtonThatIsOffSaysWhy) {
  Gui gui;
  for (const Action& entry : actions()) {
    const UiContext context{gui.session(), gui.ui()};
    const std::string reason = entry.why_not(context);
    if (!reason.empty()) {
      EXPECT_TRUE(reason.ends_with('.')) << entry.name;
      EXPECT_NE(tip_of(context, entry).find(reason), std::string::npos);
    }
  }
  gui.key(keys::kSpace);
  EXPECT_FALSE(gui.ui().toasts.empty()) << "a key that does nothing must say why";
}

}  // namespace
}  // namespace netwright::testing
