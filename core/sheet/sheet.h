// The finished drawing of a page: lists of paths, fills and texts in millimetres, origin at the top left, y
// down. `draw_sheets` is pure; the writers (PDF, PNG, SVG) and the screen only repeat what stands here.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/image.h"
#include "core/sheet/pages.h"
#include "core/sheet/sheet_settings.h"
#include "core/unfold/fold.h"

namespace netwright {

/// Where a mark belongs: an SVG or DXF layer, a colour for a cutter, a line of the legend. Labels are numbers
/// and words on the net; Print is all that a cutter passes over.
enum class Layer { Print, Regmarks, Mountain, Valley, TabFold, Labels, Cut };

struct Stroke {
  Layer layer = Layer::Cut;
  std::vector<glm::dvec2> points;
  bool is_closed = false;
  double width_mm = 0.25;
  glm::dvec3 colour{0, 0, 0};   ///< sRGB 0…1
  std::vector<double> dash_mm;  ///< ink, gap, ink, gap …; empty = solid; ends are butt, corners round
  double dash_phase_mm = 0;     ///< how far into the pattern the first point is
};

struct Fill {
  Layer layer = Layer::Print;
  std::vector<glm::dvec2> points;
  glm::dvec3 colour{1, 1, 1};
};

enum class FontWeight { Regular, SemiBold };

struct Text {
  Layer layer = Layer::Print;
  glm::dvec2 at{0, 0};   ///< start of the baseline
  std::string words;     ///< UTF-8
  double size_mm = 2.5;  ///< em size
  FontWeight weight = FontWeight::Regular;
  glm::dvec3 colour{0.2, 0.2, 0.2};
  double angle_rad = 0;  ///< clockwise on the page, about `at`
};

/// Pixels on the page: the picture's upper left corner at `at`, rows downwards. Transparent where it has no
/// ink.
struct Picture {
  Layer layer = Layer::Print;
  glm::dvec2 at{0, 0};
  glm::dvec2 size_mm{0, 0};
  std::shared_ptr<const Image> image;  ///< null where only `later` makes it
  /// Makes the image anew; for sheets whose pictures together would fill the memory.
  std::function<std::shared_ptr<const Image>()> later{};

  [[nodiscard]] std::shared_ptr<const Image> pixels() const { return image || !later ? image : later(); }
};

/// Drawn in this order: fills, pictures, strokes, texts.
struct Sheet {
  double width_mm = 210;
  double height_mm = 297;
  int number = 1;  ///< page n of m
  int count = 1;
  std::string tag;       ///< "A1" of a tiled net, else empty
  bool is_back = false;  ///< the reverse of the sheet before it, mirrored left to right
  std::vector<Fill> fills;
  std::vector<Picture> pictures;
  std::vector<Stroke> strokes;
  std::vector<Text> texts;
};

/// What the title block says beside the figures of net and layout.
struct SheetInfo {
  std::string title;       ///< empty: the model's name
  bool is_proved = false;  ///< prints the mark "one piece, proved: no overlaps"
  std::optional<std::uint64_t> seed;
};

/// One sheet per page of the layout. Outlines are closed polylines in order (open where a tile cuts them),
/// folds one stroke each with dashes fitted so that both ends carry ink, on tiles in phase with the
/// neighbouring page.
/// Past the first 60 million pixels the pictures are made when they are asked for, see Picture::pixels().
std::vector<Sheet> draw_sheets(const Net& net, const PageLayout& layout, const SheetInfo& info,
                               const SheetSettings& settings = {});

}  // namespace netwright
