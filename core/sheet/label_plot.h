// The ground labels are placed on: a face or a tab with what already lies on it, and how much room words
// take. Used by place_labels only.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/sheet/font.h"
#include "core/sheet/labels.h"

namespace netwright {

/// Widths of the characters that labels are made of, each asked of the font once.
class WordMeasure {
 public:
  explicit WordMeasure(FontWeight weight) : font_(weight) {}
  [[nodiscard]] double width_em(const std::string& words);

 private:
  Font font_;
  std::map<char32_t, double> known_;
};

/// Words and how wide they are.
struct LabelWords {
  LabelWords(WordMeasure& measure, std::string text) : words(std::move(text)) {
    width_em = measure.width_em(words);
  }
  [[nodiscard]] glm::dvec2 box(double size_mm) const { return {width_em * size_mm, kCapHeight * size_mm}; }

  static constexpr double kCapHeight = 0.74;  ///< of digits and capitals, in em

  std::string words;
  double width_em = 0;
};

/// A simple polygon on the canvas and the labels that lie in it.
struct LabelPlot {
  std::vector<glm::dvec2> polygon;
  std::vector<Label> taken;

  /// True when the label with a little air around it lies inside and meets nothing.
  [[nodiscard]] bool has_room_for(const Label& label) const;
  /// Points inside or near, those in the middle first.
  [[nodiscard]] std::vector<glm::dvec2> places() const;
};

/// The same direction of a line, never upside down: within (-90, 90] degrees.
double upright(double angle_rad);

}  // namespace netwright
