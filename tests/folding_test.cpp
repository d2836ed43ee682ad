// The fold slider under the model's view, as a person uses it.
#include <gtest/gtest.h>

#include "core/mesh/shapes.h"
#include "tests/gui_support.h"
#include "tests/support.h"
#include "ui/actions.h"

namespace netwright::testing {
namespace {

const Scene& scene_of(Gui& gui) { return gui.app.workspace().scene(); }

TEST(FoldSlider, MovesTheNetFromTheModelToThePlaneAndBack) {
  Gui gui;
  gui.open_sample("Bunny");
  ASSERT_TRUE(gui.unfold());
  gui.point({2, 2});
  const Image model = gui.window.read_pixels();
  EXPECT_TRUE(scene_of(gui).pose().is_model());
  const WidgetRect slider = gui.rect("fold/amount");
  gui.drag({slider.max.x - 8, slider.centre().y}, {slider.min.x - 20, slider.centre().y});
  EXPECT_DOUBLE_EQ(gui.ui().folding.amount, 0);
  ASSERT_FALSE(scene_of(gui).pose().is_model());
  const ModelPose flat = scene_of(gui).pose();
  const glm::dvec3 up = flat.normal(FaceId(0));
  for (const HalfedgeId h : flat.mesh().halfedges())
    ASSERT_NEAR(glm::dot(up, flat.position(h) - flat.position(HalfedgeId(0))), 0, 1e-9);
  gui.drag({slider.min.x + 8, slider.centre().y}, {slider.max.x + 20, slider.centre().y});
  EXPECT_DOUBLE_EQ(gui.ui().folding.amount, 1);
  EXPECT_TRUE(scene_of(gui).pose().is_model());
  gui.point({2, 2});
  EXPECT_EQ(gui.window.read_pixels().rgba, model.rgba) << "folded all the way it is the model, to the pixel";
}

TEST(FoldSlider, ComesToTheModelWithoutAJump) {
  Gui gui;
  gui.open_sample("Bunny");
  ASSERT_TRUE(gui.unfold());
  gui.ui().folding.amount = 1 - 1e-9;
  gui.frames(2);
  const ModelPose pose = scene_of(gui).pose();
  ASSERT_FALSE(pose.is_model());
  for (const HalfedgeId h : pose.mesh().halfedges())
    ASSERT_LT(glm::distance(pose.position(h), pose.mesh().position(h)), 1e-6 * pose.mesh().box().diagonal());
}

TEST(FoldSlider, PlaysDownAndUpAgain) {
  Gui gui;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  gui.key('U');
  EXPECT_TRUE(gui.ui().folding.is_playing);
  gui.frames(60);
  EXPECT_GT(gui.ui().folding.amount, 0.3);
  EXPECT_LT(gui.ui().folding.amount, 0.9);
  ASSERT_TRUE(gui.until([&] { return !gui.ui().folding.is_playing; }));
  EXPECT_DOUBLE_EQ(gui.ui().folding.amount, 0);
  gui.frames(2);
  gui.click("fold/play");
  EXPECT_GT(gui.ui().folding.amount, 0);
  gui.click("fold/play");
  const double held = gui.ui().folding.amount;
  gui.frames(20);
  EXPECT_DOUBLE_EQ(gui.ui().folding.amount, held) << "pressed again it stands still";
  EXPECT_LT(held, 0.5);
}

TEST(FoldSlider, DrawsALargeModelWithLessWhileItMovesAndInFullAtRest) {
  Gui gui;
  gui.session().open_bytes("patch.obj", shapes::to_obj(shapes::bumpy_patch(40, 40)));
  ASSERT_TRUE(gui.until([&] { return gui.session().state() == RunState::Idle; }));
  ASSERT_TRUE(gui.unfold());
  gui.point({2, 2});
  ASSERT_TRUE(gui.until([&] { return gui.ui().frames_wanted == 0; }));
  ASSERT_FALSE(scene_of(gui).is_rough());
  const Image at_rest = gui.window.read_pixels();
  gui.ui().folding.amount = 0.5;
  gui.frames(2);
  EXPECT_TRUE(scene_of(gui).is_rough());
  gui.ui().folding.amount = 1;
  gui.frames(1);
  EXPECT_TRUE(scene_of(gui).is_rough());
  EXPECT_NE(gui.window.read_pixels().rgba, at_rest.rgba);
  ASSERT_TRUE(gui.until([&] { return gui.ui().frames_wanted == 0; })) << "frames go on until it rests";
  EXPECT_FALSE(scene_of(gui).is_rough());
  EXPECT_EQ(gui.window.read_pixels().rgba, at_rest.rgba);
}

TEST(FoldSlider, KeysFoldALittle) {
  Gui gui;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  gui.key(',');
  gui.key(',');
  EXPECT_NEAR(gui.ui().folding.amount, 0.9, 1e-12);
  gui.key('.');
  EXPECT_NEAR(gui.ui().folding.amount, 0.95, 1e-12);
  for (int i = 0; i < 3; ++i) gui.key('.');
  EXPECT_DOUBLE_EQ(gui.ui().folding.amount, 1);
}

TEST(FoldSlider, NeedsANetAndSaysSo) {
  Gui gui;
  gui.open_sample("Cube");
  gui.key('U');
  EXPECT_FALSE(gui.ui().folding.is_playing);
  ASSERT_FALSE(gui.ui().toasts.empty());
  EXPECT_NE(gui.ui().toasts.back().text.find("Unfold the model first"), std::string::npos);
  EXPECT_FALSE(gui.rect("fold/amount").is_enabled);
}

TEST(FoldSlider, FacesArePointedAtWhereTheyAre) {
  Gui gui;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  gui.ui().folding.amount = 0;
  gui.frames(3);
  const ModelPose pose = scene_of(gui).pose();
  const WidgetRect picture = gui.rect("model/picture");
  const OrbitCamera& camera = gui.app.workspace().model_view().camera();
  for (const FaceId f : pose.mesh().faces()) {
    gui.point(glm::dvec2(picture.min.x, picture.min.y) + glm::dvec2(camera.project(pose.centre(f))));
    EXPECT_EQ(gui.ui().hovered, f) << "a flat net shows all its faces";
  }
}

TEST(FoldSlider, FollowsASearchThatRuns) {
  Gui gui;
  gui.session().open_bytes("hats.obj", shapes::to_obj(endless_search()));
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); }));
  gui.session().set_speed(30);
  gui.session().unfold();
  ASSERT_TRUE(gui.until([&] { return gui.session().shown() != nullptr; }));
  gui.ui().folding.amount = 0.5;
  gui.frames(2);
  const auto net = gui.session().shown();
  const auto pose = scene_of(gui).pose_version();
  ASSERT_TRUE(gui.until([&] { return gui.session().shown() != net; }));
  gui.frames(2);
  EXPECT_NE(scene_of(gui).pose_version(), pose);
  EXPECT_FALSE(scene_of(gui).pose().is_model());
  gui.session().stop();
  EXPECT_TRUE(gui.until([&] { return gui.session().state() == RunState::Idle; }));
}

TEST(FoldSlider, AnotherModelStandsFolded) {
  Gui gui;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  gui.ui().folding.amount = 0.2;
  gui.frames(2);
  gui.session().open_bytes("tetrahedron.obj", shapes::to_obj(shapes::tetrahedron()));
  ASSERT_TRUE(gui.until([&] { return gui.session().project().dual->mesh().n_faces() == 4; }));
  gui.frames(2);
  EXPECT_TRUE(scene_of(gui).pose().is_model());
}

}  // namespace
}  // namespace netwright::testing
