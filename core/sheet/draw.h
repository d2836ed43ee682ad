// The parts a sheet is drawn from: the net's lines, and what stands around them. Used by draw_sheets only.
#pragma once

#include <string>
#include <vector>

#include "core/sheet/font.h"
#include "core/sheet/labels.h"
#include "core/sheet/sheet.h"

namespace netwright {

/// The net's lines on their canvases, in mm.
struct NetLines {
  struct Outline {
    int canvas = 0;
    std::vector<glm::dvec2> points;  ///< closed, round faces and tabs
  };
  struct Fold {
    int canvas = 0;
    glm::dvec2 from{0, 0};
    glm::dvec2 to{0, 0};
    Layer layer = Layer::Mountain;  ///< or Valley, or TabFold
  };
  std::vector<Outline> outlines;
  std::vector<Fold> folds;  ///< those that are drawn
};
NetLines net_lines(const Net& net, const PageLayout& layout, const SheetSettings& settings);

/// What each edge is on paper: flat folds and those hidden by hand are Flat, those shown by hand are not.
IdVector<EdgeId, EdgeKind> drawn_kinds(const Net& net, const SheetSettings& settings);

/// One side of a page: where it shows its window of the canvas, mirrored left to right or not.
struct PageView {
  const PageLayout& layout;
  const PageLayout::Page& page;
  bool is_mirrored = false;
  Box2 frame;  ///< on the page

  /// What of the canvas is drawn.
  [[nodiscard]] Box2 window() const {
    const Box2 all{page.origin, page.origin + layout.frame.net.size()};
    return page.shown.is_empty() ? all : page.shown;
  }
  [[nodiscard]] glm::dvec2 at(glm::dvec2 on_canvas) const {
    const glm::dvec2 p = on_canvas - page.origin;
    return {is_mirrored ? frame.max.x - p.x : frame.min.x + p.x, frame.min.y + p.y};
  }
};

/// What of the net lies on a page, clipped to its frame. Mirrored pages show the other side of the paper, on
/// which mountains are valleys.
void draw_folds(Sheet& sheet, const NetLines& lines, const PageView& view, const LineStyles& styles);
void draw_cuts(Sheet& sheet, const NetLines& lines, const PageView& view, const LineStyles& styles);

/// The labels that lie wholly on the page.
void draw_labels(Sheet& sheet, const PlacedLabels& placed, const PageView& view);

/// How bright the sheet's pictures are at a point, 0…1; white paper where there is none.
double brightness(const Sheet& sheet, glm::dvec2 at);
/// Below this, what stands on a picture is drawn light.
inline constexpr double kDarkGround = 0.42;

/// A stroke in the style of its layer (the net's own, not Print), dashes fitted to its length.
Stroke net_stroke(const LineStyles& styles, Layer layer, glm::dvec2 from, glm::dvec2 to);

/// Crosses on the seams, the lines to cut along, the bands to glue and the neighbours' names.
void draw_tile_marks(Sheet& sheet, const PageView& view, const Font& font);

/// The words of the title block that are the same on every page.
struct TitleWords {
  std::string title;
  std::string author;   ///< "by …", or nothing
  std::string scale;    ///< scale and height
  std::string figures;  ///< the same, then faces and seed
  std::string proof;
  bool is_proved = false;
};
TitleWords title_words(const Net& net, const PageLayout& layout, const SheetInfo& info,
                       const SheetWords& own = {}, std::size_t n_unnumbered = 0);

/// What the title block says about one page.
struct MarginNotes {
  std::string side;        ///< a sentence: which side of the paper this is
  bool is_usual = true;    ///< it may be left out where room is short
  bool is_back = false;    ///< then an upright ruler would lie on the net
  bool has_legend = true;  ///< for pages with folds
  std::string words;       ///< the user's note, where it found no better place
};

/// Title block, legend and ruler.
class MarginArtist {
 public:
  MarginArtist(const PageLayout& layout, TitleWords words, const LineStyles& styles)
      : layout_(layout), words_(std::move(words)), styles_(styles) {}
  void draw(Sheet& sheet, const PageView& view, const MarginNotes& notes) const;
  [[nodiscard]] const Font& font() const { return regular_; }

 private:
  void draw_header(Sheet& sheet, const PageView& view, const MarginNotes& notes) const;
  void draw_title(Sheet& sheet, double right, double baseline) const;
  [[nodiscard]] double draw_map(Sheet& sheet, const PageView& view, double right) const;
  void draw_proof(Sheet& sheet, double right, double baseline) const;
  void draw_footer(Sheet& sheet, const MarginNotes& notes) const;
  void draw_legend(Sheet& sheet, bool is_stacked, const MarginNotes& notes) const;
  [[nodiscard]] double draw_samples(Sheet& sheet, bool is_stacked) const;
  [[nodiscard]] bool has_one_row() const;
  [[nodiscard]] double word_width(const Text& text) const;
  void add_text(Sheet& sheet, Text text, double align) const;

  const PageLayout& layout_;
  TitleWords words_;
  const LineStyles& styles_;
  Font regular_{FontWeight::Regular};
  Font semi_bold_{FontWeight::SemiBold};
};

/// A 100 mm ruler (50 mm where less room is left) with labels, from its zero mark, to the right or upwards.
void draw_ruler(Sheet& sheet, glm::dvec2 zero, bool is_upright, double length_mm, const Font& font);

/// Everything but pictures in shades of grey.
void make_grey(Sheet& sheet);

}  // namespace netwright
