// Colours are counted in steps of a 256th; the steps grow until few enough different ones are left.
#include "core/mesh/face_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace netwright::readers {
namespace {

using Shade = std::array<int, 3>;  // 0…255

constexpr std::size_t kMostShades = 1000;

double cleaned(double share) { return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.8; }

double linear(double srgb) {
  const double x = cleaned(srgb);
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

Shade shade_of(const glm::dvec3& srgb, int step) {
  Shade shade{};
  for (int i = 0; i < 3; ++i) {
    const double steps = std::round(cleaned(srgb[i]) * 255 / step);
    shade[static_cast<std::size_t>(i)] = std::min(static_cast<int>(steps) * step, 255);
  }
  return shade;
}

std::string name_of(const Shade& shade) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02X%02X%02X", shade[0] & 0xFF, shade[1] & 0xFF, shade[2] & 0xFF);
  return text.data();
}

}  // namespace

glm::dvec3 linear_colour(const glm::dvec3& srgb) { return {linear(srgb.r), linear(srgb.g), linear(srgb.b)}; }

void colour_faces(PolygonSoup& soup, const std::vector<std::optional<glm::dvec3>>& srgb) {
  std::map<Shade, int> material_of;
  int step = 1;
  for (const int wider : {1, 4, 8, 16, 32, 64}) {
    step = wider;
    material_of.clear();
    for (const auto& colour : srgb)
      if (colour) material_of.emplace(shade_of(*colour, step), -1);
    if (material_of.size() <= kMostShades) break;
  }
  if (material_of.empty()) return;
  if (soup.face_material.empty()) soup.face_material.assign(static_cast<std::size_t>(soup.n_faces()), -1);
  for (auto& [shade, material] : material_of) {
    material = static_cast<int>(soup.materials.size());
    const glm::dvec3 colour = linear_colour(glm::dvec3(shade[0], shade[1], shade[2]) / 255.0);
    soup.materials.push_back({.name = name_of(shade), .colour = colour, .texture = nullptr});
  }
  for (std::size_t f = 0; f < srgb.size(); ++f)
    if (srgb[f]) soup.face_material[f] = material_of[shade_of(*srgb[f], step)];
}

}  // namespace netwright::readers
