// Triangles with a depth buffer, twice as large as the picture and halved for smooth edges. Light falls from
// the viewer's left shoulder.
#include "core/project/thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <span>

namespace netwright {

namespace {

constexpr int kFiner = 2;
constexpr double kMargin = 0.04;

/// The viewer's axes: right, up and towards the viewer, for a model whose up is this axis.
struct View {
  explicit View(UpAxis up) {
    const glm::dvec3 above = up == UpAxis::Y ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 front = up == UpAxis::Y ? glm::dvec3(0.55, 0.45, 0.8) : glm::dvec3(0.55, -0.8, 0.45);
    towards_viewer = glm::normalize(front);
    right = glm::normalize(glm::cross(above, towards_viewer));
    upward = glm::cross(towards_viewer, right);
  }
  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& p) const {
    return {glm::dot(p, right), glm::dot(p, upward), glm::dot(p, towards_viewer)};
  }
  glm::dvec3 right, upward, towards_viewer;
};

double to_srgb(double linear) { return std::pow(std::clamp(linear, 0.0, 1.0), 1 / 2.2); }

/// The picture's colour there, 0 … 1 as stored.
glm::dvec3 texel(const Image& image, glm::dvec2 uv) {
  const auto wrapped = [](double t, int n) {
    const double cell = (t - std::floor(t)) * n;
    return std::clamp(static_cast<int>(cell), 0, n - 1);
  };
  const int x = wrapped(uv.x, image.width);
  const int y = image.height - 1 - wrapped(uv.y, image.height);
  const std::size_t i =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return glm::dvec3(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]) / 255.0;
}

struct Corner {
  glm::dvec3 at;  ///< in pixels, z towards the viewer
  glm::dvec2 uv;
};

/// How a face looks: one colour, or a texture under that light.
struct Look {
  glm::dvec3 colour;
  double light = 1;
  const Image* texture = nullptr;
};

class Canvas {
 public:
  explicit Canvas(int side)
      : side_(side),
        colour_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), glm::dvec4(0)),
        depth_(colour_.size(), -std::numeric_limits<double>::infinity()) {}

  void triangle(const std::array<Corner, 3>& corners, const Look& look) {
    const glm::dvec2 a(corners[0].at);
    const glm::dvec2 b(corners[1].at);
    const glm::dvec2 c(corners[2].at);
    const double area = cross(b - a, c - a);
    if (!(std::abs(area) > 0)) return;
    const auto low = [&](double x, double y, double z) { return clamp(std::min({x, y, z}) - 0.5); };
    const auto high = [&](double x, double y, double z) { return clamp(std::max({x, y, z}) + 0.5); };
    for (int y = low(a.y, b.y, c.y); y <= high(a.y, b.y, c.y); ++y) {
      for (int x = low(a.x, b.x, c.x); x <= high(a.x, b.x, c.x); ++x) {
        const glm::dvec2 p(x + 0.5, y + 0.5);
        const glm::dvec3 share =
            glm::dvec3(cross(b - p, c - p), cross(c - p, a - p), cross(a - p, b - p)) / area;
        if (share.x >= 0 && share.y >= 0 && share.z >= 0) put(x, y, corners, share, look);
      }
    }
  }

  /// Halved, straight alpha.
  [[nodiscard]] Image picture() const {
    const int side = side_ / kFiner;
    Image image{.width = side, .height = side, .rgba = {}};
    image.rgba.reserve(4 * static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        glm::dvec4 sum(0);
        for (int k = 0; k < kFiner * kFiner; ++k)
          sum += colour_[index(x * kFiner + k % kFiner, y * kFiner + k / kFiner)];
        for (int i = 0; i < 3; ++i) image.rgba.push_back(byte(sum.w > 0 ? sum[i] / sum.w : 0));
        image.rgba.push_back(byte(sum.w / (kFiner * kFiner)));
      }
    }
    return image;
  }

 private:
  static double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }
  static std::uint8_t byte(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
  }
  [[nodiscard]] int clamp(double value) const {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(side_ - 1)));
  }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
  }
  void put(int x, int y, const std::array<Corner, 3>& corners, const glm::dvec3& share, const Look& look) {
    const double depth = share.x * corners[0].at.z + share.y * corners[1].at.z + share.z * corners[2].at.z;
    const std::size_t i = index(x, y);
    if (!(depth > depth_[i])) return;
    depth_[i] = depth;
    glm::dvec3 colour = look.colour;
    if (look.texture != nullptr) {
      const glm::dvec2 uv = share.x * corners[0].uv + share.y * corners[1].uv + share.z * corners[2].uv;
      colour = texel(*look.texture, uv) * look.light;
    }
    colour_[i] = glm::dvec4(colour, 1);
  }

  int side_;
  std::vector<glm::dvec4> colour_;
  std::vector<double> depth_;
};

Look look_of(const Mesh& mesh, FaceId f, const View& view) {
  const glm::dvec3 to_light = glm::normalize(view.towards_viewer + 0.6 * view.upward - 0.5 * view.right);
  // The inner side of an open model is seen from behind: it is lit as much.
  const double faced = std::abs(glm::dot(mesh.normal(f), to_light));
  Look look;
  look.light = 0.45 + 0.55 * faced;
  glm::dvec3 colour(0.8);
  if (const int m = mesh.material(f); m >= 0) {
    const Material& material = mesh.materials()[static_cast<std::size_t>(m)];
    colour = material.colour;
    if (material.texture && !material.texture->is_empty() && mesh.has_uv())
      look.texture = material.texture.get();
  }
  look.colour = glm::dvec3(to_srgb(colour.x), to_srgb(colour.y), to_srgb(colour.z)) * look.light;
  return look;
}

/// Moves and scales what is seen into the canvas.
struct Fit {
  Fit(const Mesh& mesh, const View& view, int side) {
    Box3 box;
    for (const VertexId v : mesh.vertices()) box.add(view(mesh.position(v)));
    const double extent = std::max({box.size().x, box.size().y, std::numeric_limits<double>::min()});
    scale = side * (1 - 2 * kMargin) / extent;
    middle = (box.min + box.max) * 0.5;
    centre = side / 2.0;
  }
  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& p) const {
    const glm::dvec3 moved = (p - middle) * scale;
    return {centre + moved.x, centre - moved.y, moved.z};
  }
  double scale = 1;
  double centre = 0;
  glm::dvec3 middle{0};
};

}  // namespace

Image draw_thumbnail(const DualGraph& dual, int side) {
  const Mesh& mesh = dual.mesh();
  const View view(mesh.up_axis());
  const Fit fit(mesh, view, side * kFiner);
  Canvas canvas(side * kFiner);
  for (const FaceId f : mesh.faces()) {
    const Look look = look_of(mesh, f, view);
    const auto corner = [&](int i) {
      const HalfedgeId h(mesh.first(f).value + i);
      return Corner{fit(view(mesh.position(h))), mesh.has_uv() ? mesh.uv(h) : glm::dvec2(0)};
    };
    for (int k = 0; k < dual.n_parts(f); ++k) {
      const std::span<const int> part = dual.part(f, k);
      for (std::size_t i = 2; i < part.size(); ++i)
        canvas.triangle({corner(part[0]), corner(part[i - 1]), corner(part[i])}, look);
    }
  }
  return canvas.picture();
}

}  // namespace netwright
