// The finished drawing of a page: lists of paths, fills and texts in millimetres, origin at the top left, y down.
// `draw_sheets` is pure; the writers (PDF, PNG, SVG) and the screen only repeat what stands here.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/base/paper.h"
#include "core/unfold/fold.h"

namespace netwright {

/// Where a stroke belongs: an SVG layer, a colour for a cutter, a line of the legend.
enum class Layer { Print, Cut, Mountain, Valley, Regmarks };

struct Stroke {
  Layer layer = Layer::Cut;
  std::vector<glm::dvec2> points;
  bool is_closed = false;
  double width_mm = 0.25;
  glm::dvec3 colour{0, 0, 0};
  std::vector<double> dash_mm;   ///< ink, gap, ink, gap …; empty = solid
};

struct Fill {
  Layer layer = Layer::Print;
  std::vector<glm::dvec2> points;
  glm::dvec3 colour{1, 1, 1};
};

struct Text {
  Layer layer = Layer::Print;
  glm::dvec2 at{0, 0};           ///< start of the baseline
  std::string words;
  double size_mm = 2.5;          ///< em size
  glm::dvec3 colour{0.2, 0.2, 0.2};
};

struct Sheet {
  double width_mm = 210;
  double height_mm = 297;
  int number = 1;                ///< page n of m
  int count = 1;
  std::vector<Fill> fills;
  std::vector<Stroke> strokes;
  std::vector<Text> texts;
};

}  // namespace netwright
