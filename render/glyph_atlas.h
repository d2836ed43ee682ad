// The letters of the printed sheets as a texture of distances to their outlines: sharp at every size and
// angle, and soft at the rim without multisampling.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/sheet/font.h"
#include "render/gl_objects.h"

namespace netwright {

class GlyphAtlas {
 public:
  /// Where a letter lies in the texture (0…1) and around the start of its baseline (em, y down).
  struct Glyph {
    glm::dvec2 low{0};
    glm::dvec2 high{0};
    glm::vec2 uv_low{0};
    glm::vec2 uv_high{0};
    double advance_em = 0;
    [[nodiscard]] bool has_ink() const { return high.x > low.x; }
  };

  /// `letter`: one character in UTF-8. Made when it is asked for first; without ink where the texture is
  /// full.
  const Glyph& glyph(FontWeight weight, std::string_view letter);
  /// Sends new letters to the graphics card.
  void upload();
  [[nodiscard]] unsigned int texture() const { return texture_.name(); }
  /// Distances are stored as 0.5 + distance / (2 reach); what the reach is in em.
  static constexpr double kReach_em = 0.15;

 private:
  bool find_room(glm::ivec2 size, glm::ivec2& at);

  std::array<Font, 2> fonts_{Font(FontWeight::Regular), Font(FontWeight::SemiBold)};
  std::map<std::pair<FontWeight, std::string>, Glyph> glyphs_;
  std::vector<std::uint8_t> pixels_;
  glm::ivec2 pen_{0};  ///< where the next letter goes
  int row_height_ = 0;
  bool is_stale_ = true;
  Texture texture_;
};

/// The characters of a text, each in UTF-8.
std::vector<std::string_view> letters_of(std::string_view words);

}  // namespace netwright
