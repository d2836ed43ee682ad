// Draws over the window without a screen and looks at single pixels: the colours that carry a meaning, lines
// where lines belong, pictures that are kept until something in them changes; and the headless window's own
// promises.
#include <gtest/gtest.h>

#include <imgui.h>

#include <array>
#include <atomic>
#include <memory>
#include <thread>

#include "app/window_headless.h"
#include "core/mesh/shapes.h"
#include "core/unfold/fold.h"
#include "render/renderers.h"

namespace netwright {
namespace {

constexpr glm::ivec2 kSize{320, 240};

struct Pixel {
  int r = 0;
  int g = 0;
  int b = 0;
};

Pixel pixel(const Image& image, glm::dvec2 at) {
  const auto x = static_cast<std::size_t>(at.x);
  const auto y = static_cast<std::size_t>(at.y);
  const std::size_t k = (y * static_cast<std::size_t>(image.width) + x) * 4;
  return {image.rgba.at(k), image.rgba.at(k + 1), image.rgba.at(k + 2)};
}

bool is_near(const Pixel& p, const Colour& c, int tolerance) {
  const auto differs = [tolerance](int byte, float x) {
    return std::abs(byte - static_cast<int>(x * 255)) > tolerance;
  };
  return !differs(p.r, c.r) && !differs(p.g, c.g) && !differs(p.b, c.b);
}

int count_near(const Image& image, const Colour& colour, int tolerance) {
  int n = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) n += is_near(pixel(image, {x, y}), colour, tolerance) ? 1 : 0;
  return n;
}

/// A cube whose net is its first face with the four around it and the last one behind.
Net cube_net(double edge = 1) {
  const auto dual = std::make_shared<const DualGraph>(std::make_shared<const Mesh>(shapes::cube(edge)));
  const Mesh& mesh = dual->mesh();
  UnfoldTree tree(mesh.n_faces());
  FaceId last;
  for (const HalfedgeId h : mesh.halfedges(FaceId(0))) {
    last = mesh.neighbour(h);
    tree.set_parent(last, mesh.twin(h));
  }
  for (const HalfedgeId h : mesh.halfedges(last)) {
    const FaceId beyond = mesh.neighbour(h);
    if (beyond != FaceId(0) && tree.is_root(beyond)) tree.set_parent(beyond, mesh.twin(h));
  }
  return layout(dual, tree);
}

class Rendering : public testing::Test {
 protected:
  static void SetUpTestSuite() { window() = std::make_unique<HeadlessWindow>(WindowOptions{"test", kSize}); }
  static void TearDownTestSuite() { window().reset(); }
  static std::unique_ptr<HeadlessWindow>& window() {
    static std::unique_ptr<HeadlessWindow> the_window;
    return the_window;
  }

  Rendering() {
    orbit_.set_size(kSize);
    orbit_.frame(net_.mesh().box());
    flat_.set_size(kSize);
    flat_.frame(net_.box(), 20);
  }

  Image draw_model(const FaceStates& states, const TreeLook* tree = nullptr, const MeshLook& look = {}) {
    renderers_.model_picture.invalidate();
    renderers_.model_picture.redraw(kSize, {}, [&] {
      renderers_.background.draw_gradient(colours_);
      renderers_.mesh.set_model(net_.dual);
      renderers_.mesh.draw(orbit_, colours_, states, look);
      if (tree == nullptr) return;
      renderers_.tree.set_tree(net_, {}, {}, 1);
      renderers_.tree.draw_on_model(orbit_, colours_, *tree);
    });
    return renderers_.model_picture.read_pixels();
  }

  Image draw_net(const FaceStates& states, bool with_tree = false, std::uint64_t version = 1) {
    renderers_.net_picture.invalidate();
    renderers_.net_picture.redraw(kSize, {}, [&] {
      Background::clear_desk(colours_);
      renderers_.net.set_net(net_, edge_kinds(net_), version);
      renderers_.net.draw(flat_, colours_, states, {});
      if (!with_tree) return;
      renderers_.tree.set_tree(net_, {}, {}, version);
      renderers_.tree.draw_on_net(flat_, colours_, {});
    });
    return renderers_.net_picture.read_pixels();
  }

  /// Off the middle, where neither tree nor root mark is.
  [[nodiscard]] glm::dvec2 inside(FaceId f) const {
    return flat_.to_pixel(net_.placement[f](glm::dvec2(0.21, 0.3)));
  }
  /// Where the middle of the face nearest to the eye is seen.
  [[nodiscard]] FaceId front_face() const {
    const Mesh& mesh = net_.mesh();
    FaceId best(0);
    for (const FaceId f : mesh.faces())
      if (glm::length(mesh.centre(f) - orbit_.eye()) < glm::length(mesh.centre(best) - orbit_.eye()))
        best = f;
    return best;
  }
  [[nodiscard]] glm::dvec2 middle(FaceId f) const {
    return glm::dvec2(orbit_.project(net_.mesh().centre(f)));
  }

  Net net_ = cube_net();
  FaceStates none_{net_.mesh().n_faces()};
  const Palette& colours_ = palette(Theme::Light);
  OrbitCamera orbit_;
  PanZoomCamera flat_;
  Renderers renderers_;
};

TEST_F(Rendering, PutsTheLitModelBeforeTheGradient) {
  const Image image = draw_model(none_);
  EXPECT_TRUE(is_near(pixel(image, {2, 1}), colours_.background_top, 4));
  EXPECT_TRUE(is_near(pixel(image, {2, 238}), colours_.background_bottom, 4));
  const Pixel lit = pixel(image, middle(front_face()));
  EXPECT_GT(lit.r, 110);
  EXPECT_FALSE(is_near(lit, colours_.background_top, 4));
}

TEST_F(Rendering, ShadesTheSidesOfACubeDifferently) {
  const Image image = draw_model(none_);
  const Pixel top =
      pixel(image, glm::dvec2(orbit_.project({0, net_.mesh().box().max.y, 0})) + glm::dvec2(4, 4));
  const Pixel side = pixel(image, middle(front_face()) + glm::dvec2(4, 4));
  EXPECT_GT(std::abs(top.r - side.r), 12);
}

TEST_F(Rendering, ShowsModelsOfAnyUnitAlike) {
  const int n_edge_pixels = count_near(draw_model(none_), colours_.model_edge, 24);
  for (const double edge : {1e-30, 1e30}) {
    net_ = cube_net(edge);
    orbit_.frame(net_.mesh().box());
    const Image image = draw_model(none_);
    EXPECT_GT(pixel(image, middle(front_face())).r, 110) << edge;
    EXPECT_NEAR(count_near(image, colours_.model_edge, 24), n_edge_pixels, 0.02 * n_edge_pixels) << edge;
  }
}

TEST_F(Rendering, DrawsTheEdgesOfTheModelOnlyWhenAsked) {
  MeshLook bare;
  bare.shows_edges = false;
  const int with = count_near(draw_model(none_), colours_.model_edge, 24);
  const int without = count_near(draw_model(none_, nullptr, bare), colours_.model_edge, 24);
  EXPECT_GT(with, without + 150);
}

TEST_F(Rendering, MarksOverlappingFacesRedWithAHatch) {
  FaceStates states = none_;
  states.add(FaceId(2), FaceState::Overlapping);
  const Image image = draw_net(states);
  int hatched = 0;
  int plain = 0;
  const glm::dvec2 at = inside(FaceId(2));
  for (int dx = -6; dx <= 6; ++dx) {
    const Pixel p = pixel(image, at + glm::dvec2(dx, 0));
    EXPECT_GT(p.r, p.g + 40);
    EXPECT_GT(p.r, p.b + 40);
    (p.g < 70 ? hatched : plain) += 1;
  }
  EXPECT_GT(hatched, 0);
  EXPECT_GT(plain, 0);
  EXPECT_TRUE(is_near(pixel(image, inside(FaceId(1))), colours_.paper, 3));
}

TEST_F(Rendering, MarksOverlapsOnTheModelToo) {
  FaceStates states = none_;
  states.add(front_face(), FaceState::Overlapping);
  const Pixel p = pixel(draw_model(states), middle(front_face()));
  EXPECT_GT(p.r, p.g + 30);
}

TEST_F(Rendering, PaintsTheRootOrangeAndItsMarkOnTop) {
  FaceStates states = none_;
  states.add(FaceId(0), FaceState::Root);
  const Image image = draw_net(states, true);
  const Pixel face = pixel(image, inside(FaceId(0)));
  EXPECT_GT(face.r, 230);
  EXPECT_LT(face.b, 90);
  EXPECT_TRUE(
      is_near(pixel(image, flat_.to_pixel(net_.placement[FaceId(0)](glm::dvec2(0)))), colours_.root, 3));
}

TEST_F(Rendering, LightsUpTheHoveredFaceAndNoOther) {
  const Image before = draw_net(none_);
  FaceStates states = none_;
  states.add(FaceId(3), FaceState::Hovered);
  const Image after = draw_net(states);
  EXPECT_LT(pixel(after, inside(FaceId(3))).r, pixel(before, inside(FaceId(3))).r - 20);
  EXPECT_EQ(pixel(after, inside(FaceId(1))).r, pixel(before, inside(FaceId(1))).r);
}

TEST_F(Rendering, DrawsCutsDarkAlongTheOutline) {
  const Image image = draw_net(none_);
  const Mesh& mesh = net_.mesh();
  const IdVector<EdgeId, EdgeKind> kinds = edge_kinds(net_);
  for (const EdgeId e : mesh.edges()) {
    if (kinds[e] != EdgeKind::Cut) continue;
    const HalfedgeId h = mesh.halfedge(e);
    const Pixel p = pixel(image, flat_.to_pixel((net_.corner(h) + net_.corner(mesh.next(h))) * 0.5));
    EXPECT_LT(p.r, 140) << "edge " << e.value;
  }
}

TEST_F(Rendering, DashesMountainFolds) {
  const Image image = draw_net(none_);
  const Mesh& mesh = net_.mesh();
  const HalfedgeId h = net_.tree.to_parent(FaceId(1));
  int drawn = 0;
  int left_out = 0;
  for (int k = 10; k <= 90; ++k) {
    const glm::dvec2 at = glm::mix(net_.corner(h), net_.corner(mesh.next(h)), k / 100.0);
    const Pixel p = pixel(image, flat_.to_pixel(at));
    const bool is_red = p.r > p.g + 20;
    drawn += is_red ? 1 : 0;
    left_out += is_near(p, colours_.paper, 6) ? 1 : 0;
  }
  EXPECT_GT(drawn, 20);
  EXPECT_GT(left_out, 8);
}

TEST_F(Rendering, DrawsTheTreeInBlueAcrossEveryFold) {
  const Image image = draw_net(none_, true);
  const Mesh& mesh = net_.mesh();
  for (const FaceId f : mesh.faces()) {
    if (net_.tree.is_root(f)) continue;
    const HalfedgeId h = net_.tree.to_parent(f);
    const glm::dvec2 fold = (net_.corner(h) + net_.corner(mesh.next(h))) * 0.5;
    const glm::dvec2 on_the_way = glm::mix(net_.placement[f](glm::dvec2(0)), fold, 0.5);
    const Pixel p = pixel(image, flat_.to_pixel(on_the_way));
    EXPECT_GT(p.b, p.r + 40) << "face " << f.value;
  }
}

TEST_F(Rendering, HidesTheTreeBehindTheModel) {
  TreeLook look;
  look.shows_roots = false;
  const Image image = draw_model(none_, &look);
  EXPECT_GT(count_near(image, colours_.tree, 30), 60);
  // Seen from the front, the stroke on the back of the cube is not there: only visible faces carry blue.
  const FaceId front = front_face();
  FaceId hidden(0);
  for (const FaceId f : net_.mesh().faces())
    if (glm::dot(net_.mesh().normal(f), net_.mesh().normal(front)) < -0.9) hidden = f;
  const HalfedgeId h = net_.tree.is_root(hidden) ? net_.mesh().first(hidden) : net_.tree.to_parent(hidden);
  const glm::dvec3 stroke =
      glm::mix(net_.mesh().centre(hidden),
               (net_.mesh().position(h) + net_.mesh().position(net_.mesh().next(h))) * 0.5, 0.3);
  const glm::dvec2 at(orbit_.project(stroke));
  EXPECT_EQ(pixel(image, at).r, pixel(draw_model(none_), at).r);
}

TEST_F(Rendering, OutlinesSelectedFacesInGreen) {
  FaceStates states = none_;
  states.add(FaceId(1), FaceState::Selected);
  EXPECT_GT(count_near(draw_net(states), colours_.selection, 12), 60);
  EXPECT_EQ(count_near(draw_net(none_), colours_.selection, 12), 0);
}

TEST_F(Rendering, FollowsANetOnlyWhenItsVersionChanges) {
  draw_net(none_);
  const glm::dvec2 place = inside(FaceId(2));
  for (const FaceId f : net_.mesh().faces()) net_.placement[f].x += 1000;
  EXPECT_TRUE(is_near(pixel(draw_net(none_, false, 1), place), colours_.paper, 3));
  EXPECT_TRUE(is_near(pixel(draw_net(none_, false, 2), place), colours_.desk, 3));
}

TEST_F(Rendering, LeavesFoldsOutUntilTheNetIsGivenAgainWithThem) {
  const auto draw = [&](std::uint64_t version, bool has_folds) {
    renderers_.net_picture.invalidate();
    renderers_.net_picture.redraw(kSize, {}, [&] {
      Background::clear_desk(colours_);
      renderers_.net.set_net(net_, edge_kinds(net_), version, has_folds);
      renderers_.net.draw(flat_, colours_, none_, {});
      renderers_.tree.set_tree(net_, {}, {}, version, has_folds);
      renderers_.tree.draw_on_net(flat_, colours_, {});
    });
    return renderers_.net_picture.read_pixels();
  };
  const Image full = draw_net(none_, true);
  const Image rough = draw(2, false);
  EXPECT_LT(count_near(rough, colours_.tree, 24) + 50, count_near(full, colours_.tree, 24));
  EXPECT_GT(count_near(rough, colours_.cut, 24), 100) << "cuts are always drawn";
  EXPECT_EQ(draw(2, true).rgba, full.rgba) << "the same net with its folds";
  EXPECT_EQ(draw(2, false).rgba, full.rgba) << "folds that are there stay";
}

TEST_F(Rendering, LaysSheetsUnderTheNet) {
  Box2 border = net_.box();
  border.min -= 0.2;
  border.max += 0.2;
  const std::array<SheetOutline, 1> sheets{SheetOutline{border, net_.box()}};
  renderers_.net.set_sheets(sheets);
  flat_.frame(border, 20);
  const Image image = draw_net(none_);
  EXPECT_TRUE(is_near(pixel(image, flat_.to_pixel(border.min + 0.1)), colours_.sheet, 3));
  EXPECT_TRUE(is_near(pixel(image, {2, 2}), colours_.desk, 3));
}

TEST_F(Rendering, KeepsAPictureUntilItsKeyOrSizeChanges) {
  int painted = 0;
  const auto paint = [&painted] { ++painted; };
  Viewport viewport;
  EXPECT_TRUE(viewport.redraw(kSize, PictureKey().add(orbit_).add(1), paint));
  EXPECT_FALSE(viewport.redraw(kSize, PictureKey().add(orbit_).add(1), paint));
  EXPECT_TRUE(viewport.redraw(kSize, PictureKey().add(orbit_).add(2), paint));
  orbit_.orbit({1, 0});
  EXPECT_TRUE(viewport.redraw(kSize, PictureKey().add(orbit_).add(2), paint));
  EXPECT_TRUE(viewport.redraw(kSize / 2, PictureKey().add(orbit_).add(2), paint));
  EXPECT_EQ(painted, 4);
}

TEST_F(Rendering, TellsTheThemesApartWithTheSameMeanings) {
  const Palette& dark = palette(Theme::Dark);
  EXPECT_EQ(dark.tree, colours_.tree);
  EXPECT_EQ(dark.root, colours_.root);
  EXPECT_LT(dark.desk.r, colours_.desk.r);
  EXPECT_GT(dark.cut_halo.a, 0) << "dark cuts need a rim on the dark desk";
}

/// One frame of an interface with a button in the corner; true when it was clicked.
bool button_frame(HeadlessWindow& window) {
  window.begin_frame();
  ImGui::NewFrame();
  ImGui::SetNextWindowPos(ImVec2(0, 0));
  ImGui::Begin("test", nullptr, ImGuiWindowFlags_NoDecoration);
  const bool is_clicked = ImGui::Button("press", ImVec2(80, 40));
  ImGui::End();
  ImGui::Render();
  window.present();
  return is_clicked;
}

TEST_F(Rendering, ClicksAButtonWithoutAScreen) {
  HeadlessWindow& w = *window();
  w.move_mouse({30, 25});
  for (int k = 0; k < 3; ++k) EXPECT_FALSE(button_frame(w));
  w.press_mouse();
  EXPECT_FALSE(button_frame(w));
  w.release_mouse();
  EXPECT_TRUE(button_frame(w));
  const Image shot = w.read_pixels();
  EXPECT_EQ(shot.width, kSize.x);
  EXPECT_NE(pixel(shot, {30, 25}).b, pixel(shot, {300, 200}).b);
}

TEST_F(Rendering, QueuesKeysDropsAndCloseInOrder) {
  HeadlessWindow& w = *window();
  w.take_events();
  w.press_key('O', kControl);
  w.drop({"bunny.obj"});
  w.type_text("ü");
  w.request_close();
  const std::vector<WindowEvent> events = w.take_events();
  ASSERT_EQ(events.size(), 4U);
  EXPECT_EQ(events[0].key, 'O');
  EXPECT_EQ(events[0].modifiers, kControl);
  EXPECT_EQ(events[1].paths.at(0), "bunny.obj");
  EXPECT_EQ(events[2].code_point, U'ü');
  EXPECT_EQ(events[3].kind, WindowEvent::Kind::Close);
  EXPECT_TRUE(w.take_events().empty());
  button_frame(w);
  button_frame(w);
}

TEST_F(Rendering, WakesFromAnotherThread) {
  HeadlessWindow& w = *window();
  w.take_events();
  std::atomic<bool> was_woken = false;
  std::thread other([&] {
    was_woken = true;
    w.wake();
  });
  w.wait_events(3600);  // a lost call would keep the test here until its time runs out
  EXPECT_TRUE(was_woken);
  other.join();
}

}  // namespace
}  // namespace netwright
