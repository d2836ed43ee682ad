// The maths of the two cameras and of picking: what the mouse does to them, and that pixels and the world
// agree.
#include <gtest/gtest.h>

#include <memory>

#include "core/mesh/shapes.h"
#include "core/unfold/net.h"
#include "render/camera.h"
#include "render/picker.h"

namespace netwright {
namespace {

Box3 unit_box() {
  Box3 box;
  box.add({-0.5, -0.5, -0.5});
  box.add({0.5, 0.5, 0.5});
  return box;
}

OrbitCamera framed_camera(glm::dvec2 size_px = {800, 600}) {
  OrbitCamera camera;
  camera.set_size(size_px);
  camera.frame(unit_box());
  return camera;
}

std::shared_ptr<const DualGraph> dual_of(const PolygonSoup& soup) {
  return std::make_shared<const DualGraph>(std::make_shared<const Mesh>(soup));
}

TEST(OrbitCamera, LooksFromTheSideItIsToldWithEitherAxisUp) {
  for (const UpAxis axis : {UpAxis::Y, UpAxis::Z}) {
    OrbitCamera camera = framed_camera();
    camera.set_up_axis(axis);
    for (const glm::dvec3& side :
         {glm::dvec3(1, 0.2, 0.1), glm::dvec3(-0.3, -0.5, 2), glm::dvec3(0, 1, -3)}) {
      const double distance = camera.distance();
      camera.look_from(side);
      EXPECT_NEAR(glm::dot(glm::normalize(camera.eye() - camera.target()), glm::normalize(side)), 1, 1e-9);
      EXPECT_DOUBLE_EQ(camera.distance(), distance);
    }
    const OrbitCamera before = camera;
    camera.look_from(glm::dvec3(0));
    EXPECT_EQ(camera, before);
  }
}

TEST(OrbitCamera, FliesFromOneViewToAnotherTheShorterWayRound) {
  OrbitCamera from = framed_camera();
  from.look_from({-0.1, 0, -1});
  OrbitCamera to = from;
  to.look_from({0.1, 0.3, -1});
  to.zoom(4, {400, 300});
  const auto near = [](const OrbitCamera& a, const OrbitCamera& b) {
    return glm::distance(a.eye(), b.eye()) + glm::distance(a.target(), b.target()) < 1e-9;
  };
  EXPECT_TRUE(near(OrbitCamera::between(from, to, 0), from));
  EXPECT_TRUE(near(OrbitCamera::between(from, to, 1), to));
  const OrbitCamera half = OrbitCamera::between(from, to, 0.5);
  EXPECT_NEAR(half.distance(), from.distance() / 2, 1e-9);
  EXPECT_LT((half.eye() - half.target()).z, 0) << "not through the front";
}

TEST(OrbitCamera, ShowsEveryCornerOfAFramedBoxInWideAndTallViews) {
  for (const glm::dvec2 size : {glm::dvec2(800, 600), glm::dvec2(300, 900), glm::dvec2(1600, 200)}) {
    const OrbitCamera camera = framed_camera(size);
    double widest = 0;
    for (int k = 0; k < 8; ++k) {
      const glm::dvec3 corner((k & 1) - 0.5, ((k >> 1) & 1) - 0.5, ((k >> 2) & 1) - 0.5);
      const glm::dvec3 p = camera.project(corner);
      EXPECT_GT(p.x, 0);
      EXPECT_LT(p.x, size.x);
      EXPECT_GT(p.y, 0);
      EXPECT_LT(p.y, size.y);
      EXPECT_GT(p.z, 0);
      EXPECT_LT(p.z, 1);
      widest = std::max({widest, std::abs(p.x / size.x - 0.5), std::abs(p.y / size.y - 0.5)});
    }
    EXPECT_GT(widest, 0.35) << "the box should fill most of the view";
  }
}

TEST(OrbitCamera, UnprojectsWhatItProjected) {
  const OrbitCamera camera = framed_camera();
  const glm::dvec3 point(0.3, -0.2, 0.41);
  const glm::dvec3 back = camera.unproject(camera.project(point));
  EXPECT_NEAR(glm::length(back - point), 0, 1e-9);
}

TEST(OrbitCamera, SendsItsRayThroughThePixelOfAPoint) {
  const OrbitCamera camera = framed_camera();
  const glm::dvec3 point(-0.3, 0.45, 0.2);
  const Ray ray = camera.ray(glm::dvec2(camera.project(point)));
  EXPECT_NEAR(glm::length(glm::cross(ray.direction, point - ray.origin)), 0, 1e-9);
  EXPECT_GT(glm::dot(ray.direction, point - ray.origin), 0);
}

TEST(OrbitCamera, ZoomKeepsThePointUnderThePointerAndDoublesItsSize) {
  OrbitCamera camera = framed_camera();
  const glm::dvec2 pointer(620, 140);
  const double depth = camera.project(camera.target()).z;
  const glm::dvec3 held = camera.unproject({pointer, depth});
  const double scale = camera.pixels_per_unit();
  camera.zoom(2, pointer);
  const glm::dvec3 after = camera.project(held);
  EXPECT_NEAR(after.x, pointer.x, 1e-6);
  EXPECT_NEAR(after.y, pointer.y, 1e-6);
  EXPECT_NEAR(camera.pixels_per_unit(), 2 * scale, 1e-9 * scale);
}

TEST(OrbitCamera, PanCarriesTheTargetWithThePointer) {
  OrbitCamera camera = framed_camera();
  const glm::dvec3 target = camera.target();
  camera.pan({50, -30});
  const glm::dvec3 p = camera.project(target);
  EXPECT_NEAR(p.x, 450, 1e-6);
  EXPECT_NEAR(p.y, 270, 1e-6);
}

TEST(OrbitCamera, OrbitMovesTheNearSideWithThePointerAndNeverTips) {
  OrbitCamera camera = framed_camera();
  const Ray ray = camera.ray({400, 300});
  const glm::dvec3 near_point = ray.origin + ray.direction * (camera.distance() - 0.5);
  camera.orbit({20, 12});
  EXPECT_GT(camera.project(near_point).x, 400);
  EXPECT_GT(camera.project(near_point).y, 300);
  camera.orbit({0, 1e6});
  EXPECT_LE(camera.screen_direction({0, 1, 0}).y, 0) << "up never points down on the screen";
}

TEST(OrbitCamera, StandsModelsUpAlongTheirUpAxis) {
  OrbitCamera camera = framed_camera();
  EXPECT_LT(camera.screen_direction({0, 1, 0}).y, -0.8);
  camera.set_up_axis(UpAxis::Z);
  EXPECT_LT(camera.screen_direction({0, 0, 1}).y, -0.8);
  EXPECT_NEAR(camera.screen_direction({0, 0, 1}).x, 0, 1e-12);
}

TEST(OrbitCamera, KeepsTheModelBetweenItsPlanesHoweverFarItIsZoomed) {
  OrbitCamera camera = framed_camera();
  for (int k = 0; k < 200; ++k) camera.zoom(0.8, {400, 300});
  EXPECT_LT(camera.project({0, 0, -0.5}).z, 1);
  EXPECT_GT(camera.project({0, 0, 0.5}).z, 0);
}

TEST(PanZoomCamera, FramesABoxWithItsMarginAndYPointingUp) {
  PanZoomCamera camera;
  camera.set_size({400, 300});
  Box2 box;
  box.add({10, 20});
  box.add({30, 40});
  camera.frame(box, 50);
  EXPECT_NEAR(camera.pixels_per_unit(), 10, 1e-9);
  const glm::dvec2 top_left = camera.to_pixel({10, 40});
  EXPECT_NEAR(top_left.x, 100, 1e-9);
  EXPECT_NEAR(top_left.y, 50, 1e-9);
}

TEST(PanZoomCamera, PansAndZoomsUnderThePointer) {
  PanZoomCamera camera;
  camera.set_size({400, 300});
  const glm::dvec2 held = camera.to_world({90, 210});
  camera.zoom(3, {90, 210});
  EXPECT_NEAR(glm::length(camera.to_pixel(held) - glm::dvec2(90, 210)), 0, 1e-9);
  camera.pan({25, -40});
  EXPECT_NEAR(glm::length(camera.to_pixel(held) - glm::dvec2(115, 170)), 0, 1e-9);
}

TEST(PanZoomCamera, AgreesWithItsOwnMatrix) {
  PanZoomCamera camera;
  camera.set_size({400, 300});
  camera.zoom(1.7, {33, 44});
  const glm::dvec2 point(0.4, -0.9);
  const glm::dvec4 clip = camera.view_projection() * glm::dvec4(point, 0, 1);
  const glm::dvec2 pixel((clip.x + 1) * 200, (1 - clip.y) * 150);
  EXPECT_NEAR(glm::length(pixel - camera.to_pixel(point)), 0, 1e-9);
}

TEST(ModelPicker, FindsTheFaceThatPlainSearchFinds) {
  const auto dual = dual_of(shapes::torus(24, 12));
  const Mesh& mesh = dual->mesh();
  ModelPicker picker;
  picker.set_model(dual);
  OrbitCamera camera;
  camera.set_size({640, 480});
  camera.frame(mesh.box());
  int hits = 0;
  for (int x = 4; x < 640; x += 37) {
    for (int y = 4; y < 480; y += 29) {
      const Ray ray = camera.ray({x, y});
      FaceId expected;
      double nearest = std::numeric_limits<double>::infinity();
      for (const FaceId f : mesh.faces()) {
        const double t = glm::dot(mesh.position(mesh.first(f)) - ray.origin, mesh.normal(f)) /
                         glm::dot(ray.direction, mesh.normal(f));
        const glm::dvec3 p = ray.origin + ray.direction * t;
        bool is_inside = t > 0 && t < nearest;
        for (const HalfedgeId h : mesh.halfedges(f)) {
          const glm::dvec3 a = mesh.position(h);
          const glm::dvec3 side = mesh.position(mesh.next(h)) - a;
          is_inside = is_inside && glm::dot(glm::cross(side, p - a), mesh.normal(f)) >= 0;
        }
        if (!is_inside) continue;
        nearest = t;
        expected = f;
      }
      EXPECT_EQ(picker.pick(ray), expected) << x << ' ' << y;
      hits += expected.is_valid() ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 50);
}

TEST(ModelPicker, LooksThroughTheNotchOfAConcaveFace) {
  const auto dual = dual_of(shapes::letter_l());
  ModelPicker picker;
  picker.set_model(dual);
  const Box3 box = dual->mesh().box();
  // From above into each quarter of the box: the L covers three of them.
  int covered = 0;
  for (const double x : {0.25, 0.75})
    for (const double z : {0.25, 0.75}) {
      const glm::dvec3 above = box.min + box.size() * glm::dvec3(x, 2, z);
      covered += picker.pick({above, {0, -1, 0}}).is_valid() ? 1 : 0;
    }
  EXPECT_EQ(covered, 3);
}

TEST(ModelPicker, ForgetsItsModel) {
  ModelPicker picker;
  picker.set_model(dual_of(shapes::cube()));
  const Ray ray{{0, 0, 9}, {0, 0, -1}};
  EXPECT_TRUE(picker.pick(ray).is_valid());
  picker.set_model(nullptr);
  EXPECT_FALSE(picker.pick(ray).is_valid());
}

/// Every face a piece of its own, all on top of each other with their middles at the origin.
Net stacked(const std::shared_ptr<const DualGraph>& dual) {
  Net net = layout(dual, UnfoldTree(dual->mesh().n_faces()));
  for (const FaceId f : net.mesh().faces()) net.placement[f] = Rigid2();
  return net;
}

TEST(NetPicker, FindsEveryFaceAtItsMiddle) {
  const auto dual = dual_of(shapes::cube());
  const Mesh& mesh = dual->mesh();
  UnfoldTree tree(mesh.n_faces());
  const FaceId root(0);
  FaceId last;
  for (const HalfedgeId h : mesh.halfedges(root)) {
    tree.set_parent(mesh.neighbour(h), mesh.twin(h));
    last = mesh.neighbour(h);
  }
  for (const HalfedgeId h : mesh.halfedges(last))
    if (mesh.neighbour(h) != root && tree.is_root(mesh.neighbour(h)))
      tree.set_parent(mesh.neighbour(h), mesh.twin(h));
  const Net net = layout(dual, tree);
  NetPicker picker;
  picker.set_net(net, 1);
  for (const FaceId f : mesh.faces()) EXPECT_EQ(picker.pick(net.placement[f](glm::dvec2(0))), f);
  EXPECT_FALSE(picker.pick(net.box().max + 0.1).is_valid());
}

TEST(NetPicker, TakesTheTopmostOfFacesThatLieOnEachOther) {
  const auto dual = dual_of(shapes::cube());
  const Net net = stacked(dual);
  NetPicker picker;
  picker.set_net(net, 1);
  EXPECT_EQ(picker.pick({0, 0}), FaceId(5));
}

TEST(NetPicker, KeepsItsNetUntilTheVersionChanges) {
  const auto dual = dual_of(shapes::cube());
  Net net = stacked(dual);
  NetPicker picker;
  picker.set_net(net, 1);
  for (const FaceId f : net.mesh().faces()) net.placement[f].x += 100;
  picker.set_net(net, 1);
  EXPECT_TRUE(picker.pick({0, 0}).is_valid());
  picker.set_net(net, 2);
  EXPECT_FALSE(picker.pick({0, 0}).is_valid());
  EXPECT_TRUE(picker.pick({100, 0}).is_valid());
}

}  // namespace
}  // namespace netwright
