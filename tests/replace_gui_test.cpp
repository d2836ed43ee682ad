// Another version of the model, from the menu to the list of what was kept.
#include <gtest/gtest.h>

#include "tests/gui_support.h"
#include "tests/support.h"
#include "ui/actions.h"

namespace netwright::testing {
namespace {

/// A ball beside a box; the new version has no box.
PolygonSoup ball_and_box() { return shapes::combined(shapes::icosphere(3), shapes::cube(), {3, 0, 0}); }

bool until_rest(Gui& gui) {
  return gui.until([&] {
    if (gui.session().state() == RunState::Replaying) gui.session().skip_replay();
    return gui.session().state() == RunState::Idle && !gui.session().is_replacing() &&
           gui.session().chore() == nullptr;
  });
}

/// Two pinned folds of the box, one of the ball; unfolded.
void open_pinned(Gui& gui, const TemporaryFolder& folder) {
  gui.window.drop({folder.write("toy.obj", shapes::to_obj(ball_and_box()))});
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); })) << gui.ui().error;
  const Mesh& mesh = gui.session().project().dual->mesh();
  Constraints pins;
  const FaceId of_box(mesh.n_faces() - 1);
  set_pin(pins, mesh.edge(mesh.first(of_box)), EdgePin::MustFold);
  set_pin(pins, mesh.edge(mesh.next(mesh.first(of_box))), EdgePin::MustFold);
  set_pin(pins, mesh.edge(mesh.first(FaceId(20))), EdgePin::MustFold);
  gui.session().set_pins(pins, "pin");
  ASSERT_TRUE(gui.unfold());
}

void choose_version(Gui& gui, const TemporaryFolder& folder, const PolygonSoup& soup) {
  static_cast<void>(folder.write("toy2.obj", shapes::to_obj(soup)));
  gui.click("menu/File");
  gui.click("menu/Replace model…");
  ASSERT_EQ(gui.ui().dialog, Dialog::Replace);
  ASSERT_TRUE(gui.widgets.find("browser/toy.obj").has_value()) << "it begins where the old version lies";
  gui.double_click(centre(gui.rect("browser/toy2.obj")));
  ASSERT_TRUE(until_rest(gui)) << gui.ui().error;
  gui.frames(4);
}

TEST(ReplaceGui, TheMenuReplacesTheModelAndTheListLightsWhatWasLost) {
  Gui gui;
  const TemporaryFolder folder;
  open_pinned(gui, folder);
  gui.ui().settings.is_open(Section::Model) = false;
  choose_version(gui, folder, shapes::icosphere(3));
  EXPECT_EQ(gui.session().project().source->name, "toy2.obj");
  EXPECT_TRUE(gui.session().shown()->is_proved);
  EXPECT_TRUE(gui.session().keeps_pins());
  EXPECT_TRUE(gui.ui().settings.is_open(Section::Model)) << "where the list is";
  const auto report = gui.session().replacement();
  ASSERT_NE(report, nullptr);
  EXPECT_EQ(report->n_kept, 1);
  EXPECT_EQ(report->n_lost, 2);
  const std::string lost = "replaced/" + std::to_string(report->lines.size() - 1);
  gui.click(lost);
  gui.frames(30);
  EXPECT_EQ(gui.ui().lit.segments.size(), 2U) << "drawn where the box stood";
  gui.click("replaced/close");
  gui.frames(2);
  EXPECT_FALSE(gui.widgets.find(lost).has_value());
  EXPECT_TRUE(gui.ui().lit.segments.empty());
  EXPECT_EQ(gui.session().undo_label(), "Undo replace model");
  gui.key('Z', kControl);
  gui.frames(3);
  EXPECT_EQ(gui.session().project().source->name, "toy.obj");
  EXPECT_EQ(gui.session().project().pins.must_fold.size(), 3U);
  EXPECT_TRUE(gui.until([&] { return gui.session().shown() && gui.session().shown()->is_proved; }));
}

TEST(ReplaceGui, ABrokenVersionIsAskedAboutAndThenReplaces) {
  Gui gui;
  const TemporaryFolder folder;
  open_pinned(gui, folder);
  PolygonSoup broken = ball_and_box();
  broken.add_face(std::vector<int>(broken.face(0).begin(), broken.face(0).end()));
  choose_version(gui, folder, broken);
  ASSERT_NE(gui.session().pending(), nullptr);
  EXPECT_TRUE(gui.widgets.find("repair/doubled_faces").has_value());
  EXPECT_EQ(gui.session().project().source->name, "toy.obj");
  gui.click("dialog/accept");
  ASSERT_TRUE(until_rest(gui));
  EXPECT_EQ(gui.session().project().source->name, "toy2.obj");
  EXPECT_EQ(gui.session().replacement()->n_lost, 0);
  EXPECT_TRUE(gui.session().shown()->is_proved);
}

TEST(ReplaceGui, WithoutAModelThereIsNothingToReplace) {
  Gui gui;
  const UiContext context{gui.session(), gui.ui()};
  EXPECT_EQ(action(ActionId::ReplaceModel).why_not(context), "Open a model first.");
  gui.key('R', kControl);
  EXPECT_EQ(gui.ui().dialog, Dialog::None);
}

}  // namespace
}  // namespace netwright::testing
