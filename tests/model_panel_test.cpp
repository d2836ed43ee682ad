// The way of a model that needs work, as a person walks it: the question about a broken file, the report's
// lines, fewer faces, merged faces, and all of it undone.
#include <gtest/gtest.h>

#include <utility>

#include "tests/gui_support.h"
#include "tests/model_files.h"
#include "tests/support.h"
#include "ui/actions.h"
#include "ui/selection.h"

namespace netwright::testing {
namespace {

/// A ball as a careless program writes it: every facet with points of its own, two facets twice, two turned
/// inside out. 82 facets.
PolygonSoup careless_ball() {
  PolygonSoup ball = shapes::icosphere(2);
  ball.add_face(std::vector<int>(ball.face(3).begin(), ball.face(3).end()));
  ball.add_face(std::vector<int>(ball.face(60).begin(), ball.face(60).end()));
  for (const std::size_t f : {11U, 40U}) std::swap(ball.corners[3 * f], ball.corners[3 * f + 1]);
  return ball;
}

/// Drops it and waits for the question.
void drop_careless_ball(Gui& gui, const TemporaryFolder& folder) {
  gui.window.drop({folder.write("star.stl", to_binary_stl(careless_ball()))});
  ASSERT_TRUE(gui.until([&] { return gui.session().pending() != nullptr; })) << gui.ui().error;
  gui.frames(6);
}

/// Until the mesh that was asked for is there.
bool until_made(Gui& gui) {
  return gui.until([&] { return !gui.session().is_making(); });
}

bool until_rest(Gui& gui) {
  return gui.until([&] {
    if (gui.session().state() == RunState::Replaying) gui.session().skip_replay();
    const bool has_net = !gui.session().has_model() || gui.session().project().tree == nullptr ||
                         gui.session().shown() != nullptr;
    return gui.session().state() == RunState::Idle && !gui.session().is_making() && has_net;
  });
}

/// Pixels of a widget in the red of culprits.
int n_red(const Image& picture, const WidgetRect& rect) {
  int n = 0;
  for (int y = static_cast<int>(rect.min.y); y < static_cast<int>(rect.max.y); ++y) {
    for (int x = static_cast<int>(rect.min.x); x < static_cast<int>(rect.max.x); ++x) {
      const auto i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                          static_cast<std::size_t>(x));
      n += picture.rgba[i] > 215 && picture.rgba[i + 1] < 110 && picture.rgba[i + 2] < 110 ? 1 : 0;
    }
  }
  return n;
}

std::size_t n_faces(Gui& gui) { return gui.session().project().dual->mesh().n_faces(); }

TEST(RepairDialog, SaysWhatIsWrongAndRepairsOnEnter) {
  Gui gui;
  const TemporaryFolder folder;
  gui.open_sample("Cube");
  drop_careless_ball(gui, folder);
  EXPECT_EQ(gui.session().pending()->name, "star.stl");
  EXPECT_TRUE(gui.widgets.find("repair/refusal").has_value());
  EXPECT_TRUE(gui.widgets.find("repair/doubled_faces").has_value());
  EXPECT_FALSE(gui.widgets.find("repair/uneven").has_value()) << "triangles are flat already";
  EXPECT_EQ(n_faces(gui), 6U) << "nothing is opened without being asked";
  gui.key(keys::kEnter);
  ASSERT_EQ(gui.session().pending(), nullptr);
  EXPECT_EQ(n_faces(gui), 80U);
  EXPECT_TRUE(gui.session().project().dual->mesh().is_closed());
  gui.frames(3);
  EXPECT_FALSE(gui.widgets.find("dialog/title").has_value());
  EXPECT_TRUE(gui.widgets.find("model/faces").has_value()) << "the panel tells what was done";
}

TEST(RepairDialog, LeavesOutWhatIsSwitchedOffAndSaysWhenThatIsNotEnough) {
  Gui gui;
  const TemporaryFolder folder;
  drop_careless_ball(gui, folder);
  EXPECT_TRUE(gui.widgets.find("repair/doubled/count").has_value());
  EXPECT_FALSE(gui.widgets.find("repair/all").has_value()) << "everything is on";
  for (const char* step : {"repair/doubled", "repair/split"}) {
    gui.click(step);
    ASSERT_TRUE(until_made(gui));
    gui.frames(3);
  }
  EXPECT_FALSE(gui.session().pending()->is_fit());
  EXPECT_TRUE(gui.widgets.find("repair/not-enough").has_value());
  EXPECT_FALSE(gui.rect("dialog/accept").is_enabled);
  gui.key(keys::kEnter);
  EXPECT_NE(gui.session().pending(), nullptr);
  gui.click("repair/all");
  ASSERT_TRUE(until_made(gui));
  gui.frames(3);
  EXPECT_TRUE(gui.rect("dialog/accept").is_enabled);
  gui.click("dialog/accept");
  EXPECT_EQ(n_faces(gui), 80U);
}

TEST(RepairDialog, LeavesBothViewsWholeWhenNoModelWasOpenBefore) {
  Gui gui;
  const TemporaryFolder folder;
  drop_careless_ball(gui, folder);
  gui.click("dialog/accept");
  gui.point({2, 2});
  const WidgetRect net = gui.rect("net/picture");
  const glm::ivec2 edge(static_cast<int>(net.min.x) + 6, static_cast<int>(net.min.y) + 60);
  const Image picture = gui.window.read_pixels();
  EXPECT_NEAR(brightness(picture, edge), brightness(picture, edge + glm::ivec2(80, 0)), 1)
      << "the splitter covers the desk";
}

TEST(RepairDialog, CancelAndEscapeLeaveTheModelThatWasThere) {
  Gui gui;
  const TemporaryFolder folder;
  gui.open_sample("Cube");
  drop_careless_ball(gui, folder);
  gui.click("dialog/cancel");
  EXPECT_EQ(gui.session().pending(), nullptr);
  EXPECT_EQ(n_faces(gui), 6U);
  drop_careless_ball(gui, folder);
  gui.key(keys::kEscape);
  gui.frames(3);
  EXPECT_EQ(gui.session().pending(), nullptr);
  EXPECT_FALSE(gui.widgets.find("dialog/title").has_value());
  EXPECT_EQ(n_faces(gui), 6U);
}

TEST(RepairDialog, FitsASmallWindow) {
  Gui gui({1024, 700}, 2);
  const TemporaryFolder folder;
  drop_careless_ball(gui, folder);
  for (const char* name : {"dialog/title", "dialog/accept", "dialog/cancel"}) {
    const WidgetRect rect = gui.rect(name);
    EXPECT_GE(rect.min.x, 0) << name;
    EXPECT_GE(rect.min.y, 0) << name;
    EXPECT_LE(rect.max.x, 1024) << name;
    EXPECT_LE(rect.max.y, 700) << name;
  }
}

TEST(RepairDialog, FlattensUnevenFacesWhereThatIsWanted) {
  Gui gui;
  const TemporaryFolder folder;
  PolygonSoup bent = shapes::grid_cube(2);
  bent.points[0] += glm::dvec3(0.02, 0.03, 0.01);
  gui.window.drop({folder.write("bent.obj", shapes::to_obj(bent))});
  ASSERT_TRUE(gui.until([&] { return gui.session().pending() != nullptr; })) << gui.ui().error;
  gui.frames(6);
  gui.click("repair/uneven/Flatten");
  ASSERT_TRUE(until_made(gui));
  gui.frames(3);
  ASSERT_NE(gui.session().pending(), nullptr) << "nothing is opened without being asked";
  ASSERT_TRUE(gui.session().pending()->is_fit()) << gui.session().pending()->made->refusal;
  gui.click("dialog/accept");
  ASSERT_EQ(gui.session().pending(), nullptr) << gui.ui().error;
  EXPECT_EQ(n_faces(gui), 24U) << "no face was split";
  EXPECT_EQ(gui.session().recipe().uneven, UnevenFaces::Flatten);
}

TEST(ModelPanel, TheWayOfABrokenFileToANetAndAllTheWayBack) {
  Gui gui;
  const TemporaryFolder folder;
  drop_careless_ball(gui, folder);
  gui.click("dialog/accept");
  ASSERT_EQ(n_faces(gui), 80U);
  gui.frames(4);

  const WidgetRect slider = gui.rect("model/faces");
  const auto at = [&](double share) {
    return glm::dvec2(slider.min.x + share * (slider.max.x - slider.min.x), slider.centre().y);
  };
  gui.point(at(0.98));
  gui.window.press_mouse();
  gui.frames();
  std::size_t before = 80;
  for (const double share : {0.6, 0.3}) {
    gui.point(at(share));
    ASSERT_TRUE(gui.until([&] { return n_faces(gui) < before && gui.session().shown() != nullptr; }))
        << "the net keeps up while the slider is held";
    ASSERT_TRUE(until_made(gui));
    before = n_faces(gui);
  }
  gui.window.release_mouse();
  gui.frames(3);
  ASSERT_TRUE(until_rest(gui));
  EXPECT_LT(n_faces(gui), 60U);
  EXPECT_TRUE(gui.session().shown()->is_proved);

  gui.click("model/merge");
  ASSERT_TRUE(until_made(gui));
  EXPECT_TRUE(gui.session().recipe().merges);
  ASSERT_TRUE(until_rest(gui));
  EXPECT_EQ(gui.session().undo_label(), "Undo unfold") << "of the merged faces";
  const std::size_t n_steps = gui.session().history().size();
  while (gui.session().history_position() > 1) gui.key('Z', kControl);
  EXPECT_EQ(n_faces(gui), 80U);
  EXPECT_EQ(gui.session().recipe().faces, 0);
  EXPECT_EQ(gui.session().undo_label(), "Undo repair");
  gui.key('Z', kControl);
  gui.frames(3);
  EXPECT_FALSE(gui.session().can_undo());
  EXPECT_FALSE(gui.session().has_model());
  EXPECT_TRUE(gui.widgets.find("repair/refusal").has_value()) << "the question is there again";
  EXPECT_TRUE(gui.widgets.find("repair/doubled_faces").has_value());

  gui.click("dialog/cancel");
  EXPECT_FALSE(gui.widgets.find("repair/refusal").has_value());
  gui.click("unrepaired/repair");
  EXPECT_TRUE(gui.widgets.find("repair/refusal").has_value());
  gui.click("dialog/cancel");
  gui.key('Y', kControl);
  EXPECT_EQ(n_faces(gui), 80U) << "redone";
  EXPECT_EQ(gui.session().history().size(), n_steps);
  while (gui.session().can_redo()) gui.key('Y', kControl);
  ASSERT_TRUE(until_rest(gui));
  EXPECT_TRUE(gui.session().recipe().merges);
  EXPECT_TRUE(gui.session().shown()->is_proved);
}

/// An open ball with a hole, split into facets with points of their own: a file that opens, but could be
/// better.
PolygonSoup ball_with_a_hole() {
  PolygonSoup ball = shapes::icosphere(2);
  ball.corners.resize(ball.corners.size() - 3);
  ball.face_begin.pop_back();
  return ball;
}

TEST(ModelPanel, RepairsOneStepAtATimeAndUndoesEach) {
  Gui gui;
  const TemporaryFolder folder;
  gui.window.drop({folder.write("open.stl", to_binary_stl(ball_with_a_hole()))});
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); })) << gui.ui().error;
  gui.frames(3);
  gui.click("section/Model");
  gui.frames(2);
  EXPECT_FALSE(gui.widgets.find("repair/doubled").has_value()) << "there are none";
  gui.click("repair/holes");
  ASSERT_TRUE(until_made(gui));
  EXPECT_TRUE(gui.session().project().dual->mesh().is_closed());
  EXPECT_EQ(n_faces(gui), 80U);
  EXPECT_EQ(gui.session().undo_label(), "Undo close holes");
  gui.frames(3);
  gui.enter("repair/tolerance", "0.5");
  ASSERT_TRUE(until_made(gui));
  EXPECT_TRUE(gui.session().recipe().repairs.welds);
  EXPECT_DOUBLE_EQ(gui.session().recipe().repairs.weld_tolerance, 0.5) << "an STL is in millimetres";
  EXPECT_EQ(gui.session().undo_label(), "Undo weld points");
  gui.key('Z', kControl);
  gui.key('Z', kControl);
  EXPECT_FALSE(gui.session().can_undo());
  EXPECT_EQ(n_faces(gui), 79U);
  EXPECT_EQ(gui.session().recipe(), Recipe{});
}

TEST(ModelPanel, ARepairThatTheModelNeedsStays) {
  Gui gui;
  const TemporaryFolder folder;
  drop_careless_ball(gui, folder);
  gui.click("dialog/accept");
  gui.frames(4);
  Recipe without = gui.session().recipe();
  without.repairs.splits_non_manifold = false;
  gui.session().set_recipe(without, "keep shared edges");
  ASSERT_TRUE(until_made(gui));
  gui.frames(3);
  gui.click("repair/doubled");
  ASSERT_TRUE(until_made(gui));
  gui.frames(2);
  EXPECT_TRUE(gui.session().recipe().repairs.drops_doubled_faces);
  EXPECT_NE(gui.ui().error.find("same corners"), std::string::npos) << gui.ui().error;
  EXPECT_EQ(n_faces(gui), 80U);
}

TEST(ModelPanel, OneToastTellsOfARepairAndThePanelKeepsTheSteps) {
  Gui gui;
  const TemporaryFolder folder;
  drop_careless_ball(gui, folder);
  gui.click("dialog/accept");
  gui.frames(4);
  ASSERT_EQ(gui.ui().toasts.size(), 1U);
  EXPECT_EQ(gui.ui().toasts.front().text, "star.stl was repaired: 82 faces before, 80 after.");
  EXPECT_TRUE(gui.widgets.find("repair/doubled").has_value());
  EXPECT_TRUE(gui.widgets.find("repair/turn").has_value());
}

/// A crumb, a ball inside a box, that box.
PolygonSoup three_parts() {
  PolygonSoup big = shapes::icosphere(2);
  for (glm::dvec3& p : big.points) p *= 8;
  const PolygonSoup ball = shapes::combined(shapes::cube(1), big, {85, 20, 3});
  return shapes::combined(ball, shapes::cube(40), {80, 0, 0});
}

TEST(ModelPanel, PartsAreLitLeftOutAndTakenBack) {
  Gui gui;
  gui.session().open_bytes("parts.obj", shapes::to_obj(three_parts()));
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); })) << gui.ui().error;
  gui.frames(3);
  gui.click("section/Model");
  gui.frames(2);
  ASSERT_EQ(n_faces(gui), 92U);
  gui.point(centre(gui.rect("parts/2")));
  gui.frames(3);
  int n_lit = 0;
  for (const FaceId face : gui.session().project().dual->mesh().faces())
    n_lit += gui.app.workspace().scene().states().has(face, FaceState::Hovered) ? 1 : 0;
  EXPECT_EQ(n_lit, 80) << "the ball is lit";
  gui.point({2, 2});
  EXPECT_TRUE(gui.ui().hovered_part_faces.empty());

  gui.click("parts/small");
  ASSERT_TRUE(until_made(gui));
  gui.frames(2);
  EXPECT_EQ(n_faces(gui), 86U);
  EXPECT_EQ(gui.session().undo_label(), "Undo leave out small parts");
  gui.click("parts/inner");
  ASSERT_TRUE(until_made(gui));
  gui.frames(2);
  EXPECT_EQ(n_faces(gui), 6U);
  EXPECT_FALSE(gui.rect("parts/1").is_enabled) << "one part has to stay";
  gui.click("parts/3");
  ASSERT_TRUE(until_made(gui));
  EXPECT_EQ(n_faces(gui), 12U);
  EXPECT_EQ(gui.session().undo_label(), "Undo keep part 3");
  for (int i = 0; i < 3; ++i) gui.key('Z', kControl);
  EXPECT_FALSE(gui.session().can_undo());
  EXPECT_EQ(n_faces(gui), 92U);
}

void open_huge_cube(Gui& gui) {
  gui.session().open_bytes("huge.obj", shapes::to_obj(shapes::cube(3200)));
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); })) << gui.ui().error;
  gui.frames(3);
}

TEST(SizeBar, AsksOnceHowTallAHugeModelShallBe) {
  Gui gui;
  gui.open_sample("Cube");
  EXPECT_FALSE(gui.widgets.find("size/height").has_value());
  open_huge_cube(gui);
  ASSERT_TRUE(gui.session().asked_size());
  EXPECT_DOUBLE_EQ(gui.session().asked_size()->height_mm, 3200);
  gui.enter("size/height", "120");
  gui.click("size/set");
  gui.frames(2);
  EXPECT_FALSE(gui.widgets.find("size/height").has_value());
  EXPECT_EQ(gui.session().project().size, (PrintSize{PrintSize::Kind::Height, 120}));
  EXPECT_EQ(gui.session().undo_label(), "Undo print size");
  gui.key('Z', kControl);
  gui.frames(2);
  EXPECT_EQ(gui.session().project().size.kind, PrintSize::Kind::FitPage);
  EXPECT_FALSE(gui.widgets.find("size/height").has_value()) << "it asks once";
}

TEST(SizeBar, KeepsTheSizeWhenToldTo) {
  Gui gui({700, 700});
  open_huge_cube(gui);
  EXPECT_LE(gui.rect("size/keep").max.x, 700);
  gui.click("size/keep");
  gui.frames(2);
  EXPECT_FALSE(gui.widgets.find("size/keep").has_value());
  EXPECT_EQ(gui.session().project().size, PrintSize{});
  EXPECT_FALSE(gui.session().can_undo());
}

TEST(ModelPanel, AWholeDragOfTheSliderIsOneUndoStep) {
  Gui gui;
  gui.open_sample("Bunny");
  gui.click("section/Model");
  const WidgetRect slider = gui.rect("model/faces");
  const auto at = [&](double share) {
    return glm::dvec2(slider.min.x + share * (slider.max.x - slider.min.x), slider.centre().y);
  };
  gui.point(at(0.98));
  gui.window.press_mouse();
  for (const double share : {0.7, 0.5, 0.4}) {
    gui.point(at(share));
    // Rests until the net of this stop is found, as a person who looks at it does.
    ASSERT_TRUE(until_rest(gui));
    gui.frames(3);
  }
  gui.window.release_mouse();
  gui.frames(3);
  ASSERT_TRUE(until_rest(gui));
  EXPECT_LT(n_faces(gui), 200U);
  EXPECT_EQ(gui.session().undo_label(), "Undo unfold");
  gui.key('Z', kControl);
  EXPECT_EQ(gui.session().undo_label(), "Undo simplify");
  EXPECT_LT(n_faces(gui), 200U);
  gui.key('Z', kControl);
  EXPECT_EQ(n_faces(gui), 370U);
  EXPECT_FALSE(gui.session().can_undo());
}

TEST(ModelPanel, AnotherAxisIsUpWithOneClick) {
  Gui gui;
  gui.open_sample("Bunny");
  gui.click("section/Model");
  gui.click("model/up/Z");
  ASSERT_TRUE(until_rest(gui));
  EXPECT_EQ(gui.session().project().dual->mesh().up_axis(), UpAxis::Z);
  EXPECT_EQ(gui.session().undo_label(), "Undo up axis");
  gui.click("model/up/Y");
  ASSERT_TRUE(until_rest(gui));
  EXPECT_EQ(gui.session().project().dual->mesh().up_axis(), UpAxis::Y);
}

TEST(ModelPanel, TheNumberOfFacesCanBeTypedAndTakenBack) {
  Gui gui;
  gui.open_sample("Bunny");
  gui.click("section/Model");
  gui.enter("model/faces-field", "100");
  ASSERT_TRUE(until_rest(gui));
  EXPECT_LE(n_faces(gui), 100U);
  EXPECT_GE(n_faces(gui), 98U);
  ASSERT_TRUE(gui.until([&] { return gui.session().deviation_mm().has_value(); }));
  EXPECT_GT(gui.session().deviation_mm(), 0);
  gui.frames(2);
  EXPECT_TRUE(gui.rect("model/all").is_enabled);
  gui.click("model/all");
  ASSERT_TRUE(until_rest(gui));
  EXPECT_EQ(n_faces(gui), 370U);
  gui.frames(2);
  EXPECT_FALSE(gui.rect("model/all").is_enabled);
}

TEST(ModelPanel, SimplifyingKeepsTheCameraWhereItWas) {
  Gui gui;
  gui.open_sample("Bunny");
  const glm::dvec2 space = centre(gui.rect("model/picture"));
  gui.drag(space, space + glm::dvec2(80, 10));
  const OrbitCamera seen = gui.app.workspace().model_view().camera();
  gui.session().simplify_to(200, false);
  ASSERT_TRUE(until_rest(gui));
  gui.frames(3);
  ASSERT_LE(n_faces(gui), 200U);
  EXPECT_EQ(gui.app.workspace().model_view().camera(), seen);
}

TEST(ModelPanel, TheMenuMergesTheFacesOfOnePlaneAndPartsThemAgain) {
  Gui gui;
  gui.session().open_bytes("grid.obj", shapes::to_obj(shapes::grid_cube(4)));
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); }));
  gui.frames(3);
  gui.click("menu/Model");
  gui.click("menu/Merge faces of one plane");
  ASSERT_TRUE(until_made(gui));
  EXPECT_EQ(n_faces(gui), 6U);
  gui.key('M');
  ASSERT_TRUE(until_made(gui));
  EXPECT_EQ(n_faces(gui), 96U);
}

TEST(ModelPanel, AModelWithFewFacesSaysThatItHasNoneToSpare) {
  Gui gui;
  gui.open_sample("Cube");
  gui.click("section/Model");
  gui.frames(2);
  EXPECT_FALSE(gui.rect("model/faces").is_enabled);
  EXPECT_FALSE(gui.rect("model/all").is_enabled);
}

TEST(ModelPanel, ALineOfTheReportLightsItsFacesAndTurnsTheModelToThem) {
  Gui gui;
  // Two cubes that run through each other.
  const PolygonSoup crossed = shapes::combined(shapes::cube(), shapes::cube(), {0.4, 0.3, 0.2});
  gui.session().open_bytes("crossed.obj", shapes::to_obj(crossed));
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); })) << gui.ui().error;
  gui.frames(3);
  gui.click("section/Model");
  gui.frames(2);
  const OrbitCamera before = gui.app.workspace().model_view().camera();
  const MeshReport::Line* line = gui.session().report()->find(MeshReport::Topic::SelfIntersections);
  ASSERT_NE(line, nullptr);
  gui.click("report/self_intersections");
  gui.frames(30);
  EXPECT_EQ(gui.ui().lit.faces.size(), line->faces.size());
  const FaceStates& states = gui.app.workspace().scene().states();
  for (const FaceId face : gui.ui().lit.faces) EXPECT_TRUE(states.has(face, FaceState::Selected));
  EXPECT_NE(gui.app.workspace().model_view().camera(), before) << "the camera flies there";
  gui.click("report/self_intersections");
  gui.point({2, 2});
  EXPECT_TRUE(gui.ui().lit.faces.empty());
  for (const FaceId face : gui.session().project().dual->mesh().faces())
    EXPECT_FALSE(gui.app.workspace().scene().states().has(face, FaceState::Selected));
}

TEST(ModelPanel, ALineAboutBordersLightsTheirEdgesInBothViews) {
  Gui gui;
  PolygonSoup box = shapes::cube();
  box.face_begin.pop_back();
  box.corners.resize(static_cast<std::size_t>(box.face_begin.back()));
  gui.session().open_bytes("box.obj", shapes::to_obj(box));
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); })) << gui.ui().error;
  gui.frames(3);
  ASSERT_TRUE(gui.unfold());
  gui.click("section/Model");
  gui.frames(2);
  gui.point({2, 2});
  const Image before = gui.window.read_pixels();
  gui.click("report/borders");
  gui.point({2, 2});
  gui.frames(30);
  EXPECT_EQ(gui.ui().lit.edges.size(), 4U);
  EXPECT_TRUE(gui.ui().lit.segments.empty());
  EXPECT_GT(n_red(gui.window.read_pixels(), gui.rect("model/picture")), 200) << "on the model";
  EXPECT_GT(n_red(gui.window.read_pixels(), gui.rect("net/picture")), 200) << "in the net";
  EXPECT_EQ(n_red(before, gui.rect("model/picture")), 0);
  gui.click("report/borders");
  gui.point({2, 2});
  gui.frames(3);
  EXPECT_TRUE(gui.ui().lit.edges.empty());
  EXPECT_EQ(n_red(gui.window.read_pixels(), gui.rect("net/picture")), 0);
}

TEST(ModelPanel, PointsOfTheFileThatTheMeshHasNotAreShownWhereTheyWere) {
  Gui gui;
  PolygonSoup ball = shapes::icosphere(2);
  ball.points.push_back({0, 3, 0});
  gui.session().open_bytes("ball.obj", shapes::to_obj(ball));
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); })) << gui.ui().error;
  gui.frames(3);
  gui.click("section/Model");
  gui.frames(2);
  gui.click("report/file/isolated_points");
  gui.point({2, 2});
  gui.frames(30);
  ASSERT_EQ(gui.ui().lit.points.size(), 1U);
  EXPECT_EQ(gui.ui().lit.points.front(), glm::dvec3(0, 3, 0));
  EXPECT_GT(n_red(gui.window.read_pixels(), gui.rect("model/picture")), 20);
}

TEST(ModelPanel, WhatRepairingTookAwayIsShownWhereItWas) {
  Gui gui;
  const TemporaryFolder folder;
  drop_careless_ball(gui, folder);
  gui.click("dialog/accept");
  gui.frames(4);
  gui.click("report/file/doubled_faces");
  gui.frames(3);
  EXPECT_EQ(gui.ui().lit.segments.size(), 6U) << "the sides of two triangles that are gone";
  EXPECT_TRUE(gui.ui().lit.faces.empty());
  gui.click("report/file/turned_faces");
  gui.frames(3);
  EXPECT_EQ(gui.ui().lit.faces.size(), 2U);
  EXPECT_TRUE(gui.ui().lit.segments.empty());
}

TEST(ModelPanel, OneMergedFaceIsSplitAgainAndMergedAgain) {
  Gui gui;
  gui.session().open_bytes("grid.obj", shapes::to_obj(shapes::grid_cube(4)));
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); }));
  gui.frames(3);
  gui.key('M');
  ASSERT_TRUE(until_made(gui));
  gui.frames(3);
  ASSERT_EQ(n_faces(gui), 6U);
  gui.point({2, 2});
  select_face(gui.ui(), FaceId(2), false);
  gui.click("menu/Model");
  gui.click("menu/Split this face again");
  ASSERT_TRUE(until_made(gui));
  gui.frames(3);
  EXPECT_EQ(n_faces(gui), 5U + 16U);
  EXPECT_EQ(gui.session().undo_label(), "Undo split face");

  const Mesh& split = gui.session().project().dual->mesh();
  const int source = gui.session().recipe().apart.at(0).at(7);
  for (const FaceId face : split.faces())
    if (split.face_source(face) == source) select_face(gui.ui(), face, false);
  UiContext context{gui.session(), gui.ui()};
  run_action(context, ActionId::SplitFace);
  ASSERT_TRUE(until_made(gui));
  EXPECT_EQ(n_faces(gui), 6U);
  EXPECT_EQ(gui.session().undo_label(), "Undo merge face");
  EXPECT_TRUE(gui.session().recipe().apart.empty());
  gui.key('Z', kControl);
  EXPECT_EQ(n_faces(gui), 21U);
  gui.key('Z', kControl);
  EXPECT_EQ(n_faces(gui), 6U);
}

TEST(ModelPanel, AFaceThatWasNotMergedCannotBeSplit) {
  Gui gui;
  gui.open_sample("Cube");
  const UiContext context{gui.session(), gui.ui()};
  select_face(gui.ui(), FaceId(1), false);
  EXPECT_EQ(action(ActionId::SplitFace).why_not(context), "Merge the faces of one plane first (M).");
  gui.key('M');
  ASSERT_TRUE(until_made(gui));
  gui.frames(2);
  select_face(gui.ui(), FaceId(1), false);
  EXPECT_EQ(action(ActionId::SplitFace).why_not(context), "This face was not merged of several ones.");
}

TEST(ModelPanel, MergingUnfoldsAgainWhereThereWasANet) {
  Gui gui;
  gui.session().open_bytes("grid.obj", shapes::to_obj(shapes::grid_cube(3)));
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); }));
  gui.frames(3);
  ASSERT_TRUE(gui.unfold());
  gui.key('M');
  ASSERT_TRUE(gui.until([&] { return n_faces(gui) == 6; }));
  ASSERT_TRUE(until_rest(gui));
  ASSERT_NE(gui.session().shown(), nullptr);
  EXPECT_TRUE(gui.session().shown()->is_proved);
  EXPECT_EQ(gui.session().undo_label(), "Undo unfold");
  gui.key('Z', kControl);
  EXPECT_EQ(gui.session().undo_label(), "Undo merge faces");
  gui.key('Z', kControl);
  EXPECT_EQ(n_faces(gui), 54U);
  EXPECT_TRUE(gui.until([&] { return gui.session().shown() != nullptr; }))
      << "the net of the small faces is back";
}

}  // namespace
}  // namespace netwright::testing
