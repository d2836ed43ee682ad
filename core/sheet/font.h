// The typeface of the printed sheets, bundled with the program: how wide words are, and their outlines.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <memory>
#include <string_view>
#include <vector>

#include "core/sheet/sheet.h"

namespace netwright {

class Font {
 public:
  explicit Font(FontWeight weight);
  ~Font();
  Font(Font&&) noexcept;
  Font& operator=(Font&&) noexcept;

  /// Advance width of UTF-8 words (unreadable bytes count as the replacement character). Not thread-safe,
  /// like everything here: one Font per user.
  [[nodiscard]] double width(std::string_view words, double size_mm) const;

  /// One step of a path: M and L use one point, C three (two controls, then the end), Z none.
  struct Step {
    char kind = 'M';
    std::array<glm::dvec2, 3> points{};
  };
  /// The filled outline of the words, from the baseline start `at`, y down, in mm.
  [[nodiscard]] std::vector<Step> outline(std::string_view words, double size_mm, glm::dvec2 at) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Code points of UTF-8 text; every unreadable byte becomes U+FFFD.
std::vector<char32_t> code_points(std::string_view utf8);

/// The same text, readable: unreadable bytes and control characters replaced.
std::string clean_utf8(std::string_view text);

}  // namespace netwright
