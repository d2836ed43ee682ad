// What a model looks like must survive everything that is done to it before unfolding: it is drawn from
// twelve sides before and after each step, and the pictures are compared. Leaving out texture coordinates or
// mixing up materials is noticed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/window_headless.h"
#include "core/base/image.h"
#include "core/mesh/repair.h"
#include "core/mesh/shapes.h"
#include "core/project/make_model.h"
#include "render/renderers.h"

namespace netwright {
namespace {

constexpr glm::ivec2 kSize{160, 160};
constexpr std::size_t kViews = 12;

// Mean difference of a channel over all pixels that the model covers, as a share of white. Steps that change
// no shape must keep the picture to the last bit but for a few pixels along edges. Those that move or drop
// corners turn faces and so change their shading; the bounds are about twice what that costs here.
constexpr double kSamePicture = 0.001;
constexpr double kOtherTriangles = 0.005;
constexpr double kFewerFaces = 0.025;
constexpr double kMovedCorners = 0.035;
/// What a step that loses the looks must cost at least, whatever the step.
constexpr double kLost = 0.15;

/// Smooth, with no symmetry: four corners of different colours and a dark disc off the middle.
std::shared_ptr<const Image> picture(glm::dvec3 tint) {
  constexpr int kSide = 64;
  Image image{kSide, kSide, {}};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::dvec2 at = glm::dvec2(x + 0.5, y + 0.5) / static_cast<double>(kSide);
      const double disc = glm::length(at - glm::dvec2(0.3, 0.4)) < 0.18 ? 0.25 : 1;
      const glm::dvec3 colour = tint * disc * glm::dvec3(at.x, 1 - at.x * at.y, at.y);
      for (int i = 0; i < 3; ++i)
        image.rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(colour[i], 0.0, 1.0))));
      image.rgba.push_back(255);
    }
  return std::make_shared<const Image>(std::move(image));
}

int side_of(const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x > size.y && size.x > size.z ? 0 : (size.y > size.z ? 1 : 2);
  return 2 * axis + (normal[axis] > 0 ? 1 : 0);
}

/// A cube of squares: four sides carry two pictures, each spread over a whole side, two sides are striped in
/// colours.
PolygonSoup dressed_cube(int n) {
  PolygonSoup soup = shapes::grid_cube(n);
  soup.materials = {{.name = "warm", .texture = picture({1, 0.9, 0.5})},
                    {.name = "cold", .texture = picture({0.4, 0.8, 1})},
                    {.name = "red", .colour = {0.6, 0.05, 0.05}, .texture = nullptr},
                    {.name = "green", .colour = {0.05, 0.5, 0.1}, .texture = nullptr}};
  const Mesh mesh(soup);
  for (const FaceId f : mesh.faces()) {
    const int side = side_of(mesh.normal(f));
    const int axis = side / 2;
    for (const HalfedgeId h : mesh.halfedges(f)) {
      const glm::dvec3 at = (mesh.position(h) - mesh.box().min) / mesh.box().size();
      soup.corner_uv.emplace_back(at[(axis + 1) % 3], at[(axis + 2) % 3]);
    }
    const double along = (mesh.centre(f) - mesh.box().min).x / mesh.box().size().x;
    const int stripe = 2 + static_cast<int>(along * 4) % 2;
    soup.face_material.push_back(axis == 1 ? stripe : side % 2);
  }
  return soup;
}

/// The same blown up to a ball; hardly any of its faces is flat.
PolygonSoup dressed_ball(int n) {
  PolygonSoup soup = dressed_cube(n);
  const glm::dvec3 middle = Mesh(soup).box().centre();
  for (glm::dvec3& p : soup.points) p = glm::normalize(p - middle);
  return soup;
}

/// Every face with points of its own, as STL and glTF have it.
PolygonSoup loose(const PolygonSoup& soup) {
  PolygonSoup apart = soup;
  apart.points.clear();
  apart.is_indexed = false;
  for (int& corner : apart.corners) {
    apart.points.push_back(soup.points[static_cast<std::size_t>(corner)]);
    corner = static_cast<int>(apart.points.size()) - 1;
  }
  return apart;
}

/// Every face cut into triangles from its first corner.
PolygonSoup fanned(const PolygonSoup& soup) {
  PolygonSoup cut = soup;
  cut.corners.clear();
  cut.face_begin = {0};
  cut.corner_uv.clear();
  cut.face_material.clear();
  for (int f = 0; f < soup.n_faces(); ++f) {
    const auto begin = static_cast<std::size_t>(soup.face_begin[static_cast<std::size_t>(f)]);
    for (std::size_t k = 2; k < soup.face(f).size(); ++k) {
      cut.add_face(std::vector<int>{soup.face(f)[0], soup.face(f)[k - 1], soup.face(f)[k]});
      for (const std::size_t c : {std::size_t{0}, k - 1, k})
        cut.corner_uv.push_back(soup.corner_uv[begin + c]);
      cut.face_material.push_back(soup.face_material[static_cast<std::size_t>(f)]);
    }
  }
  return cut;
}

std::shared_ptr<const DualGraph> as_it_is(const PolygonSoup& soup) {
  return std::make_shared<const DualGraph>(std::make_shared<const Mesh>(soup));
}

std::shared_ptr<const DualGraph> made(const PolygonSoup& soup, const Recipe& recipe) {
  Progress progress;
  MadeModel model = make_model(std::make_shared<const PolygonSoup>(soup), recipe, nullptr, progress);
  EXPECT_EQ(model.refusal, "");
  return model.dual;
}

class Looks : public testing::Test {
 protected:
  static void SetUpTestSuite() { window() = std::make_unique<HeadlessWindow>(WindowOptions{"test", kSize}); }
  static void TearDownTestSuite() { window().reset(); }
  static std::unique_ptr<HeadlessWindow>& window() {
    static std::unique_ptr<HeadlessWindow> the_window;
    return the_window;
  }

  /// The corners of an icosahedron, slightly turned so that no face is seen edge on.
  static glm::dvec3 direction(std::size_t view) {
    const double one = view / 3 % 2 == 0 ? 1 : -1;
    const double golden = view / 6 % 2 == 0 ? 1.618 : -1.618;
    const auto axis = static_cast<int>(view % 3);
    glm::dvec3 at(0.013);
    at[axis] += one;
    at[(axis + 1) % 3] += golden;
    return glm::normalize(at);
  }

  Image draw(const std::shared_ptr<const DualGraph>& dual, std::size_t view, bool shows_materials = true) {
    OrbitCamera camera;
    camera.set_size(kSize);
    camera.frame(box_);
    camera.look_from(direction(view));
    camera.zoom(1.6, glm::dvec2(kSize) * 0.5);
    MeshLook look;
    look.shows_edges = false;
    look.shows_materials = shows_materials;
    renderers_.model_picture.invalidate();
    renderers_.model_picture.redraw(kSize, {}, [&] {
      renderers_.background.draw_gradient(palette(Theme::Light));
      if (dual == nullptr) return;
      renderers_.mesh.set_model(dual);
      renderers_.mesh.draw(camera, palette(Theme::Light), FaceStates(dual->mesh().n_faces()), look);
    });
    return renderers_.model_picture.read_pixels();
  }

  /// Over all views, and over the pixels that one of the models covers.
  double difference(const std::shared_ptr<const DualGraph>& before,
                    const std::shared_ptr<const DualGraph>& after, bool shows_materials_after = true) {
    box_ = before->mesh().box();
    const Image bare = draw(nullptr, 0);
    double sum = 0;
    double count = 0;
    for (std::size_t view = 0; view < kViews; ++view) {
      const Image a = draw(before, view);
      const Image b = draw(after, view, shows_materials_after);
      const auto is_bare = [&bare](const Image& image, std::size_t k) {
        const auto at = static_cast<std::ptrdiff_t>(k);
        return std::equal(image.rgba.begin() + at, image.rgba.begin() + at + 3, bare.rgba.begin() + at);
      };
      for (std::size_t k = 0; k < a.rgba.size(); k += 4) {
        if (is_bare(a, k) && is_bare(b, k)) continue;
        for (std::size_t i = k; i < k + 3; ++i) sum += std::abs(a.rgba[i] - b.rgba[i]) / 255.0;
        count += 3;
      }
    }
    EXPECT_GT(count, kViews * 20000.0) << "the model fills hardly anything of the pictures";
    return sum / count;
  }

  Renderers renderers_;
  Box3 box_;
};

TEST_F(Looks, StayWhenPointsAreWelded) {
  const PolygonSoup apart = loose(fanned(dressed_ball(6)));
  const auto after = made(apart, {});
  EXPECT_TRUE(after->mesh().is_closed());
  EXPECT_LT(difference(as_it_is(apart), after), kSamePicture);
}

TEST_F(Looks, StayWhenAModelIsRepaired) {
  const PolygonSoup sound = fanned(dressed_ball(6));
  PolygonSoup broken = loose(sound);
  for (const int f : {5, 77}) {  // doubled
    const auto begin = static_cast<std::size_t>(broken.face_begin[static_cast<std::size_t>(f)]);
    broken.add_face(std::vector<int>(broken.face(f).begin(), broken.face(f).end()));
    for (std::size_t c = begin; c < begin + 3; ++c)
      broken.corner_uv.push_back(glm::dvec2(broken.corner_uv[c]));
    broken.face_material.push_back(broken.face_material[static_cast<std::size_t>(f)]);
  }
  for (const std::size_t f : {11U, 40U, 200U}) {  // inside out
    std::swap(broken.corners[3 * f], broken.corners[3 * f + 1]);
    std::swap(broken.corner_uv[3 * f], broken.corner_uv[3 * f + 1]);
  }
  const auto after = made(broken, {.repairs = Repairs{}});
  ASSERT_EQ(static_cast<int>(after->mesh().n_faces()), sound.n_faces());
  EXPECT_LT(difference(as_it_is(sound), after), kSamePicture);
}

TEST_F(Looks, StayWhenFacesAreMerged) {
  const auto before = as_it_is(dressed_cube(8));
  const auto after = made(dressed_cube(8), {.merges = true});
  EXPECT_EQ(after->mesh().n_faces(), 4U + 2 * 4U) << "a side with a picture is one face, a striped one four";
  EXPECT_LT(difference(before, after), kSamePicture);
}

TEST_F(Looks, StayWhenUnevenFacesAreSplit) {
  const auto before = as_it_is(fanned(dressed_ball(6)));
  const auto after = made(dressed_ball(6), {.uneven = UnevenFaces::Split});
  EXPECT_GT(after->mesh().n_faces(), 216U);
  EXPECT_LT(difference(before, after), kOtherTriangles);
}

TEST_F(Looks, StayWhenFacesAreFlattened) {
  const auto before = made(dressed_ball(6), {.uneven = UnevenFaces::Split});
  const auto after = made(dressed_ball(6), {.uneven = UnevenFaces::Flatten});
  EXPECT_EQ(after->mesh().n_faces(), 216U);
  EXPECT_LT(difference(before, after), kMovedCorners);
}

TEST_F(Looks, StayWhenTheModelIsSimplified) {
  const PolygonSoup fine = fanned(dressed_ball(16));
  const auto before = as_it_is(fine);
  const auto after = made(fine, {.faces = 800});
  EXPECT_LE(after->mesh().n_faces(), 800U);
  EXPECT_GT(before->mesh().n_faces(), 3000U);
  EXPECT_LT(difference(before, after), kFewerFaces);
}

TEST_F(Looks, StayThroughAllOfItTogether) {
  const PolygonSoup apart = loose(dressed_ball(14));
  const auto after =
      made(apart, {.repairs = Repairs{}, .uneven = UnevenFaces::Split, .faces = 700, .merges = true});
  EXPECT_LE(after->mesh().n_faces(), 700U);
  EXPECT_LT(difference(as_it_is(fanned(dressed_ball(14))), after), kFewerFaces);
}

TEST_F(Looks, AreMissedWhenTextureCoordinatesAreLost) {
  const PolygonSoup whole = fanned(dressed_ball(6));
  PolygonSoup lost = whole;
  lost.corner_uv.clear();
  EXPECT_GT(difference(as_it_is(whole), as_it_is(lost)), kLost);
  PolygonSoup turned = whole;
  for (std::size_t c = 0; c + 2 < turned.corner_uv.size(); c += 3)
    std::rotate(turned.corner_uv.begin() + static_cast<std::ptrdiff_t>(c),
                turned.corner_uv.begin() + static_cast<std::ptrdiff_t>(c + 1),
                turned.corner_uv.begin() + static_cast<std::ptrdiff_t>(c + 3));
  EXPECT_GT(difference(as_it_is(whole), as_it_is(turned)), 4 * kOtherTriangles)
      << "even within a triangle, mixed up corners are seen";
}

TEST_F(Looks, AreMissedWhenMaterialsAreMixedUp) {
  const PolygonSoup whole = fanned(dressed_ball(6));
  PolygonSoup mixed = whole;
  for (int& material : mixed.face_material) material = (material + 1) % 4;
  EXPECT_GT(difference(as_it_is(whole), as_it_is(mixed)), kLost);
}

TEST_F(Looks, AreHiddenWhenTexturesAreOff) {
  const auto dressed = as_it_is(fanned(dressed_ball(6)));
  PolygonSoup bare = fanned(dressed_ball(6));
  bare.materials.clear();
  bare.face_material.clear();
  bare.corner_uv.clear();
  EXPECT_GT(difference(dressed, dressed, false), kLost);
  const auto plain = as_it_is(bare);
  EXPECT_LT(difference(plain, dressed, false), kSamePicture);
}

TEST_F(Looks, SurvivePicturesTooLargeForTheGraphicsCard) {
  PolygonSoup soup = fanned(dressed_cube(2));
  Image wide{40000, 8, {}};
  for (int k = 0; k < wide.width * wide.height; ++k) wide.rgba.insert(wide.rgba.end(), {20, 180, 40, 255});
  Image flat{64, 64, {}};
  for (int k = 0; k < 64 * 64; ++k) flat.rgba.insert(flat.rgba.end(), {20, 180, 40, 255});
  PolygonSoup small = soup;
  for (const std::size_t m : {0U, 1U}) {
    soup.materials[m].texture = std::make_shared<const Image>(wide);
    small.materials[m].texture = std::make_shared<const Image>(flat);
  }
  EXPECT_LT(difference(as_it_is(small), as_it_is(soup)), kSamePicture);
}

}  // namespace
}  // namespace netwright
