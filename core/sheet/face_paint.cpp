// Textures are halved by averaging four pixels at a time; a face takes the level whose pixels are about as
// large as the printed ones, so that fine patterns do not flicker.
#include "core/sheet/face_paint.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace netwright {

namespace {

std::uint8_t srgb_byte(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  const double s = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(s * 255));
}

Image halved(const Image& image) {
  Image half{std::max(1, image.width / 2), std::max(1, image.height / 2), {}};
  half.rgba.resize(4 * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  std::size_t out = 0;
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (std::size_t c = 0; c < 4; ++c) {
        unsigned sum = 2;
        for (const int dy : {0, 1})
          for (const int dx : {0, 1}) {
            const auto row = static_cast<std::size_t>(std::min(2 * y + dy, image.height - 1));
            const auto column = static_cast<std::size_t>(std::min(2 * x + dx, image.width - 1));
            sum += image.rgba[4 * (row * static_cast<std::size_t>(image.width) + column) + c];
          }
        half.rgba[out++] = static_cast<std::uint8_t>(sum / 4);
      }
  return half;
}

std::size_t wrapped(long i, int count) {
  const long rest = i % count;
  return static_cast<std::size_t>(rest < 0 ? rest + count : rest);
}

}  // namespace

FacePaint::FacePaint(const Mesh& mesh) : mesh_(mesh) {
  constexpr int kSmallest = 4;
  const std::vector<Material>& materials = mesh.materials();
  textures_.resize(materials.size());
  colours_.resize(materials.size());
  std::set<Pixel> used;
  for (const FaceId f : mesh.faces()) {
    if (mesh.material(f) < 0) {
      used.insert({255, 255, 255, 255});
      continue;
    }
    const auto m = static_cast<std::size_t>(mesh.material(f));
    const glm::dvec3& c = materials[m].colour;
    colours_[m] = {srgb_byte(c.r), srgb_byte(c.g), srgb_byte(c.b), 255};
    const Image* const texture = materials[m].texture.get();
    if (texture != nullptr && !texture->is_empty() && mesh.has_uv()) {
      textures_[m].full = texture;
      is_plain_ = false;
    } else {
      used.insert(colours_[m]);
    }
  }
  const auto is_grey = [](const Pixel& p) { return p[0] == p[1] && p[1] == p[2]; };
  if (used.size() > 1 || !std::ranges::all_of(used, is_grey)) is_plain_ = false;
  for (Levels& levels : textures_) {
    if (levels.full == nullptr) continue;
    const Image* last = levels.full;
    while (std::min(last->width, last->height) > kSmallest) {
      levels.smaller.push_back(halved(*last));
      last = &levels.smaller.back();
    }
  }
}

FacePaint::Coat FacePaint::coat(FaceId f, double texels_per_pixel) const {
  if (mesh_.material(f) < 0) return {};
  const auto m = static_cast<std::size_t>(mesh_.material(f));
  const Levels& levels = textures_[m];
  if (levels.full == nullptr) return {nullptr, colours_[m]};
  const auto most = static_cast<double>(levels.smaller.size());
  const double level = std::clamp(std::round(std::log2(std::max(texels_per_pixel, 1.0)) - 0.2), 0.0, most);
  const auto k = static_cast<std::size_t>(level);
  return {k == 0 ? levels.full : &levels.smaller[k - 1], {}};
}

ImageSize FacePaint::texture_size(FaceId f) const {
  if (mesh_.material(f) < 0) return {};
  const Image* const full = textures_[static_cast<std::size_t>(mesh_.material(f))].full;
  return full == nullptr ? ImageSize{} : ImageSize{full->width, full->height};
}

Pixel texture_at(const Image& texture, glm::dvec2 uv) {
  constexpr double kFarthest = 1e9;
  // Also true for what is no number, as files have it and slivers make it.
  if (!(std::abs(uv.x) < kFarthest && std::abs(uv.y) < kFarthest)) uv = {0, 0};
  const double x = (uv.x - std::floor(uv.x)) * texture.width - 0.5;
  const double y = (1 - (uv.y - std::floor(uv.y))) * texture.height - 0.5;
  const double left = std::floor(x);
  const double top = std::floor(y);
  const auto tx = static_cast<unsigned>((x - left) * 256);
  const auto ty = static_cast<unsigned>((y - top) * 256);
  const std::array<std::size_t, 2> columns = {wrapped(static_cast<long>(left), texture.width),
                                              wrapped(static_cast<long>(left) + 1, texture.width)};
  const std::array<std::size_t, 2> rows = {wrapped(static_cast<long>(top), texture.height),
                                           wrapped(static_cast<long>(top) + 1, texture.height)};
  const auto stride = static_cast<std::size_t>(texture.width);
  std::array<const std::uint8_t*, 4> at{};
  for (std::size_t k = 0; k < 4; ++k) at[k] = &texture.rgba[4 * (rows[k / 2] * stride + columns[k % 2])];
  const std::array<unsigned, 4> weight = {(256 - tx) * (256 - ty), tx * (256 - ty), (256 - tx) * ty, tx * ty};
  std::array<unsigned, 4> mean{};
  for (std::size_t c = 0; c < 4; ++c) {
    unsigned sum = 1U << 15U;
    for (std::size_t k = 0; k < 4; ++k) sum += weight[k] * at[k][c];
    mean[c] = sum >> 16U;
  }
  Pixel pixel{0, 0, 0, 255};
  for (std::size_t c = 0; c < 3; ++c)
    pixel[c] = static_cast<std::uint8_t>((mean[c] * mean[3] + 255 * (255 - mean[3]) + 127) / 255);
  return pixel;
}

}  // namespace netwright
