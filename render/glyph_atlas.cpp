// Distances are measured to the flattened outline. A sheet has some dozens of different letters, so simply
// every texel looks at every piece of the outline.
#include "render/glyph_atlas.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render/gl.h"

namespace netwright {
namespace {

constexpr int kSide = 1024;        // of the texture
constexpr double kTexels_em = 48;  // per em
constexpr int kCurveSteps = 8;

struct Piece {
  glm::dvec2 from;
  glm::dvec2 to;
};

std::vector<Piece> flattened(const std::vector<Font::Step>& steps) {
  std::vector<Piece> pieces;
  glm::dvec2 start{0};
  glm::dvec2 here{0};
  const auto go = [&](glm::dvec2 to) {
    pieces.push_back({here, to});
    here = to;
  };
  for (const Font::Step& step : steps) {
    const auto& p = step.points;
    if (step.kind == 'M') start = here = p[0];
    if (step.kind == 'L') go(p[0]);
    if (step.kind == 'Z') go(start);
    if (step.kind != 'C') continue;
    const glm::dvec2 from = here;
    for (int k = 1; k <= kCurveSteps; ++k) {
      const double t = static_cast<double>(k) / kCurveSteps;
      const double s = 1 - t;
      go(s * s * s * from + 3 * s * s * t * p[0] + 3 * s * t * t * p[1] + t * t * t * p[2]);
    }
  }
  return pieces;
}

/// Positive inside (where the outline winds around the point).
double signed_distance(const std::vector<Piece>& pieces, glm::dvec2 at) {
  double least = std::numeric_limits<double>::infinity();
  int winding = 0;
  for (const auto& [a, b] : pieces) {
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? std::clamp(glm::dot(at - a, along) / length2, 0.0, 1.0) : 0;
    least = std::min(least, glm::distance(at, a + t * along));
    const double side = along.x * (at.y - a.y) - along.y * (at.x - a.x);
    if (a.y <= at.y && b.y > at.y && side > 0) ++winding;
    if (b.y <= at.y && a.y > at.y && side < 0) --winding;
  }
  return winding != 0 ? least : -least;
}

}  // namespace

std::vector<std::string_view> letters_of(std::string_view words) {
  std::vector<std::string_view> letters;
  for (std::size_t i = 0; i < words.size();) {
    std::size_t n = 1;
    while (i + n < words.size() && (static_cast<unsigned char>(words[i + n]) & 0xC0U) == 0x80U) ++n;
    letters.push_back(words.substr(i, n));
    i += n;
  }
  return letters;
}

bool GlyphAtlas::find_room(glm::ivec2 size, glm::ivec2& at) {
  if (pen_.x + size.x > kSide) pen_ = {0, pen_.y + std::exchange(row_height_, 0)};
  if (pen_.y + size.y > kSide) return false;
  at = pen_;
  pen_.x += size.x;
  row_height_ = std::max(row_height_, size.y);
  return true;
}

const GlyphAtlas::Glyph& GlyphAtlas::glyph(FontWeight weight, std::string_view letter) {
  const auto key = std::pair(weight, std::string(letter));
  if (const auto known = glyphs_.find(key); known != glyphs_.end()) return known->second;
  const Font& font = fonts_[static_cast<std::size_t>(weight)];
  Glyph& made = glyphs_[key];
  made.advance_em = font.width(letter, 1);
  const std::vector<Piece> pieces = flattened(font.outline(letter, 1, {0, 0}));
  if (pieces.empty()) return made;
  glm::dvec2 low = pieces.front().from;
  glm::dvec2 high = low;
  for (const Piece& piece : pieces) {
    low = glm::min(low, piece.to);
    high = glm::max(high, piece.to);
  }
  low -= kReach_em;
  const glm::ivec2 size(glm::ceil((high + kReach_em - low) * kTexels_em));
  glm::ivec2 at;
  if (!find_room(size, at)) return made;
  pixels_.resize(static_cast<std::size_t>(kSide) * kSide, 0);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const double d = signed_distance(pieces, low + (glm::dvec2(x, y) + 0.5) / kTexels_em);
      const double stored = std::clamp(0.5 + d / (2 * kReach_em), 0.0, 1.0);
      pixels_[static_cast<std::size_t>(at.y + y) * kSide + static_cast<std::size_t>(at.x + x)] =
          static_cast<std::uint8_t>(std::lround(255 * stored));
    }
  }
  made.low = low;
  made.high = low + glm::dvec2(size) / kTexels_em;
  made.uv_low = glm::vec2(at) / static_cast<float>(kSide);
  made.uv_high = glm::vec2(at + size) / static_cast<float>(kSide);
  is_stale_ = true;
  return made;
}

void GlyphAtlas::upload() {
  if (!std::exchange(is_stale_, false)) return;
  pixels_.resize(static_cast<std::size_t>(kSide) * kSide, 0);
  texture_.upload_grey(pixels_, kSide);
}

}  // namespace netwright
