// Pointing at edges and faces and selecting them, in both views, as a person does it.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/edge_picker.h"
#include "tests/gui_support.h"
#include "tests/support.h"
#include "ui/selection.h"

namespace netwright::testing {
namespace {

const Mesh& mesh_of(Gui& gui) { return gui.session().project().dual->mesh(); }

glm::dvec2 corner_of(Gui& gui, const char* picture) {
  const WidgetRect rect = gui.rect(picture);
  return {rect.min.x, rect.min.y};
}

/// Pixel of the window: the middle of a side in the net, `inward_px` into its face.
glm::dvec2 side_pixel(Gui& gui, HalfedgeId h, double inward_px) {
  const Net& net = *gui.app.workspace().scene().net();
  const PanZoomCamera& camera = gui.app.workspace().net_view().camera();
  const glm::dvec2 a = camera.to_pixel(net.corner(h));
  const glm::dvec2 b = camera.to_pixel(net.corner(net.mesh().next(h)));
  const glm::dvec2 along = glm::normalize(b - a);
  // The face lies at the left of its sides; pixels have y down.
  return corner_of(gui, "net/picture") + (a + b) * 0.5 + inward_px * glm::dvec2(along.y, -along.x);
}

glm::dvec2 model_pixel(Gui& gui, const glm::dvec3& point) {
  return corner_of(gui, "model/picture") +
         glm::dvec2(gui.app.workspace().model_view().camera().project(point));
}

EdgeId first_of(Gui& gui, EdgeKind kind) {
  const auto& kinds = gui.session().shown()->kinds;
  for (const EdgeId e : kinds.ids())
    if (kinds[e] == kind) return e;
  ADD_FAILURE() << "the net has no such edge";
  return {};
}

void click_at(Gui& gui, glm::dvec2 at, int modifiers = 0) {
  gui.point(at);
  gui.window.hold_modifiers(modifiers);
  gui.frames();
  gui.window.press_mouse(0, modifiers);
  gui.frames();
  gui.window.release_mouse();
  gui.frames();
  gui.window.hold_modifiers(0);
  gui.frames(2);
}

/// A face of the cube that looks at the camera, and a visible edge of it.
struct Cube : Gui {
  Cube() {
    open_sample("Cube");
    EXPECT_TRUE(unfold());
  }
};

TEST(Pointing, BothSidesOfACutAreHoveredAndKnowTheirFace) {
  Cube gui;
  const EdgeId cut = first_of(gui, EdgeKind::Cut);
  const HalfedgeId h = mesh_of(gui).halfedge(cut);
  for (const HalfedgeId side : {h, mesh_of(gui).twin(h)}) {
    gui.point(side_pixel(gui, side, 4));
    EXPECT_EQ(gui.ui().hovered_side, side);
    EXPECT_EQ(gui.ui().hovered, mesh_of(gui).face(side)) << "the face under the pointer stays known";
    gui.point(side_pixel(gui, side, -4));
    EXPECT_EQ(gui.ui().hovered_side, side) << "from outside the paper, too";
    EXPECT_FALSE(gui.ui().hovered.is_valid());
  }
  gui.point(gui.net_pixel(mesh_of(gui).face(h)));
  EXPECT_FALSE(gui.ui().hovered_side.is_valid()) << "the middle of a face is no edge";
}

TEST(Pointing, TheStatusBarTellsKindAngleAndLengthOfAnEdge) {
  Cube gui;
  const EdgeId fold = first_of(gui, EdgeKind::Mountain);
  gui.point(side_pixel(gui, mesh_of(gui).halfedge(fold), 3));
  const double millimetres = mesh_of(gui).length(fold) * gui.session().pages()->scale;
  const std::string& hint = gui.ui().hint;
  EXPECT_TRUE(hint.starts_with("Edge " + std::to_string(fold.value + 1) + ": fold, 90° mountain, ")) << hint;
  const auto at = hint.find("mountain, ");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stod(hint.substr(at + 10)), millimetres, 0.051) << hint;
}

TEST(Pointing, AnEdgeHoveredInSpaceIsLitInTheNetWithTheWayToItsPartner) {
  Cube gui;
  gui.point({2, 2});
  const auto& lines = [&]() -> const OverlayLines& { return gui.app.workspace().overlay().lines(); };
  EXPECT_TRUE(lines().plane.empty());
  const Mesh& mesh = mesh_of(gui);
  const EdgeId cut = first_of(gui, EdgeKind::Cut);
  const HalfedgeId h = mesh.halfedge(cut);
  gui.point(side_pixel(gui, h, 3));
  gui.frames(2);
  EXPECT_EQ(lines().space.size(), 1U);
  const auto count = [&](OverlayStyle style) {
    return std::count_if(lines().plane.begin(), lines().plane.end(), [&](const LineSegment& line) {
      return line.style == static_cast<std::uint32_t>(style);
    });
  };
  EXPECT_EQ(count(OverlayStyle::Hovered), 2) << "both copies";
  ASSERT_GT(count(OverlayStyle::Partner), 8);
  const Net& net = *gui.app.workspace().scene().net();
  const auto first = std::find_if(lines().plane.begin(), lines().plane.end(), [](const LineSegment& line) {
    return line.style == static_cast<std::uint32_t>(OverlayStyle::Partner);
  });
  const glm::dvec2 middle = (net.corner(h) + net.corner(mesh.next(h))) * 0.5;
  EXPECT_LT(glm::distance(glm::dvec2(first->from), middle), 1e-4);
  gui.point(side_pixel(gui, mesh.halfedge(first_of(gui, EdgeKind::Mountain)), 3));
  gui.frames(2);
  EXPECT_EQ(count(OverlayStyle::Hovered), 1) << "a fold is there once";
  EXPECT_EQ(count(OverlayStyle::Partner), 0);
}

TEST(Pointing, AnEdgeOfTheModelIsHoveredAndSelectedByAClick) {
  Cube gui;
  const Mesh& mesh = mesh_of(gui);
  const OrbitCamera& camera = gui.app.workspace().model_view().camera();
  int n_seen = 0;
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    const glm::dvec3 middle = (mesh.position(h) + mesh.position(mesh.next(h))) * 0.5;
    const auto faces_eye = [&](FaceId f) {
      return glm::dot(mesh.normal(f), camera.eye() - mesh.centre(f)) > 0;
    };
    if (!faces_eye(mesh.face(h)) && !faces_eye(mesh.neighbour(h))) continue;
    ++n_seen;
    click_at(gui, model_pixel(gui, middle) + glm::dvec2(1, 1));
    EXPECT_EQ(gui.ui().selected_edges, std::vector<EdgeId>{e});
    EXPECT_TRUE(gui.ui().selected_faces.empty());
  }
  EXPECT_GE(n_seen, 9) << "three sides of a cube are seen from a corner";
  gui.key(keys::kEscape);
  EXPECT_FALSE(has_selection(gui.ui()));
}

TEST(Pointing, ShiftClickExtendsAndShrinksTheSelection) {
  Cube gui;
  const Mesh& mesh = mesh_of(gui);
  click_at(gui, gui.net_pixel(FaceId(1)));
  click_at(gui, gui.net_pixel(FaceId(4)), kShift);
  click_at(gui, side_pixel(gui, mesh.first(FaceId(2)), 3), kShift);
  EXPECT_EQ(gui.ui().selected_faces, (std::vector<FaceId>{FaceId(1), FaceId(4)}));
  EXPECT_EQ(gui.ui().selected, FaceId(4));
  EXPECT_EQ(gui.ui().selected_edges, std::vector<EdgeId>{mesh.edge(mesh.first(FaceId(2)))});
  EXPECT_TRUE(gui.app.workspace().scene().states().has(FaceId(1), FaceState::Selected));
  EXPECT_TRUE(gui.app.workspace().scene().states().has(FaceId(4), FaceState::Selected));
  EXPECT_TRUE(gui.ui().hint.starts_with("2 faces and 1 edge selected")) << gui.ui().hint;
  click_at(gui, gui.net_pixel(FaceId(4)), kShift);
  EXPECT_EQ(gui.ui().selected_faces, std::vector<FaceId>{FaceId(1)});
  EXPECT_EQ(gui.ui().selected, FaceId(1));
  click_at(gui, gui.net_pixel(FaceId(3)));
  EXPECT_EQ(gui.ui().selected_faces, std::vector<FaceId>{FaceId(3)}) << "without Shift it is selected alone";
  EXPECT_TRUE(gui.ui().selected_edges.empty());
}

TEST(Pointing, ARubberBandSelectsWhatItHolds) {
  Cube gui;
  const glm::dvec2 corner = corner_of(gui, "net/picture");
  const WidgetRect picture = gui.rect("net/picture");
  const PanZoomCamera before = gui.app.workspace().net_view().camera();
  gui.window.hold_modifiers(kShift);
  gui.drag(corner + glm::dvec2(2, 2), {picture.max.x - 3, picture.max.y - 3});
  gui.window.hold_modifiers(0);
  EXPECT_EQ(gui.ui().selected_faces.size(), 6U);
  EXPECT_EQ(gui.app.workspace().net_view().camera(), before) << "a band moves nothing";
  gui.key(keys::kEscape);
  const glm::dvec2 one = gui.net_pixel(FaceId(2));
  gui.window.hold_modifiers(kShift);
  gui.drag(one - glm::dvec2(9, 9), one + glm::dvec2(9, 9));
  gui.window.hold_modifiers(0);
  EXPECT_EQ(gui.ui().selected_faces, std::vector<FaceId>{FaceId(2)});
}

TEST(Pointing, ARubberBandOverTheModelTakesOnlyWhatIsSeen) {
  Cube gui;
  const WidgetRect picture = gui.rect("model/picture");
  const OrbitCamera before = gui.app.workspace().model_view().camera();
  gui.window.hold_modifiers(kShift);
  gui.drag({picture.min.x + 2, picture.min.y + 2}, {picture.max.x - 3, picture.max.y - 3});
  gui.window.hold_modifiers(0);
  EXPECT_EQ(gui.ui().selected_faces.size(), 3U) << "three sides of a cube are seen from a corner";
  EXPECT_EQ(gui.app.workspace().model_view().camera(), before);
}

TEST(Pointing, AnotherModelHasNothingSelected) {
  Cube gui;
  click_at(gui, side_pixel(gui, mesh_of(gui).first(FaceId(2)), 3));
  ASSERT_TRUE(has_selection(gui.ui()));
  gui.session().open_bytes("tetrahedron.obj", shapes::to_obj(shapes::tetrahedron()));
  ASSERT_TRUE(gui.until([&] { return mesh_of(gui).n_faces() == 4; }));
  gui.frames(2);
  EXPECT_FALSE(has_selection(gui.ui()));
}

TEST(EdgePicker, LeavesTheMiddleOfSmallFacesFree) {
  const auto dual = make_dual(shapes::cube());
  ModelPicker picker;
  picker.set_model(dual);
  OrbitCamera camera;
  camera.set_size({40, 40});
  camera.frame(dual->mesh().box());
  const FaceId f = picker.pick(camera.ray({20, 20}));
  ASSERT_TRUE(f.is_valid());
  const glm::dvec2 middle(camera.project(dual->mesh().centre(f)));
  const Pointed pointed = point_at(picker, ModelPose(dual->mesh()), camera, middle, 1000);
  EXPECT_EQ(pointed.face, f);
  EXPECT_FALSE(pointed.side.is_valid());
  const HalfedgeId h = dual->mesh().first(f);
  const glm::dvec2 rim(
      camera.project((dual->mesh().position(h) + dual->mesh().position(dual->mesh().next(h))) * 0.5));
  EXPECT_EQ(dual->mesh().edge(point_at(picker, ModelPose(dual->mesh()), camera, rim, 1000).side),
            dual->mesh().edge(h));
}

}  // namespace
}  // namespace netwright::testing
