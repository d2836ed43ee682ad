// Without tabs everything grows with the scale, and one set of shapes serves for all of them. Tabs are made
// in millimetres, so with them the scale is found by a few rounds of placing tabs and shrinking.
#include "core/sheet/fit_pages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/best_angle.h"
#include "core/base/error.h"
#include "core/sheet/arranger.h"

namespace netwright {

namespace {

/// The same pieces, tabs and all, at another scale.
PieceShapes zoomed(PieceShapes shapes, double zoom) {
  shapes.scale *= zoom;
  shapes.model_height_mm *= zoom;
  shapes.area_mm2 *= zoom * zoom;
  for (PieceShape& piece : shapes.pieces) {
    piece.area_mm2 *= zoom * zoom;
    for (glm::dvec2& p : piece.hull) p *= zoom;
    for (std::vector<glm::dvec2>& outline : piece.outlines)
      for (glm::dvec2& p : outline) p *= zoom;
    for (NetMark& mark : piece.marks)
      for (glm::dvec2& p : mark.points) p *= zoom;
  }
  return shapes;
}

/// The zoom at which the largest piece just fits a page by itself: none beyond it can do.
double zoom_of_largest(const PieceShapes& shapes, const PageFrame& frame) {
  double zoom = std::numeric_limits<double>::infinity();
  for (const PieceShape& piece : shapes.pieces) {
    const auto cost = [&](glm::dvec2 size) { return fill_factor(size, frame.net.size()); };
    zoom = std::min(zoom, 1 / cost(turned_box(piece.hull, best_angle(piece.hull, cost)).size()));
  }
  return zoom;
}

/// Tries zooms and remembers the largest one that needs no more pages than allowed.
class Trials {
 public:
  Trials(const PieceShapes& shapes, const PageFrame& frame, int n_pages)
      : shapes_(shapes), frame_(frame), n_pages_(static_cast<std::size_t>(n_pages)) {}

  bool fits(double zoom) {
    std::optional<PageLayout> layout = arrange_on(zoomed(shapes_, zoom), frame_, Seams::Quick);
    const bool is_good = layout && layout->pages.size() <= n_pages_;
    if (is_good) best_ = std::max(best_, zoom);
    return is_good;
  }

  void halve(double low, double high, int rounds) {
    for (int i = 0; i < rounds; ++i) {
      const double middle = (low + high) / 2;
      (fits(middle) ? low : high) = middle;
    }
  }

  [[nodiscard]] PageLayout best() const { return *arrange_on(zoomed(shapes_, best_), frame_, Seams::Best); }

 private:
  const PieceShapes& shapes_;
  const PageFrame& frame_;
  std::size_t n_pages_;
  double best_ = 0;
};

PageLayout fit_one(const PieceShapes& shapes, const PageFrame& frame) {
  const double most = zoom_of_largest(shapes, frame) * (1 - 1e-9);
  Trials trials(shapes, frame, 1);
  double low = most;
  while (!trials.fits(low)) {
    low *= 0.5;
    if (low < most * 1e-6)
      throw Error(ErrorKind::Usage,
                  "The model has too many parts for one page; give a height in mm instead.");
  }
  if (low < most) trials.halve(low, low * 2, 12);
  return trials.best();
}

/// A smaller zoom can need more pages, too, so the search goes down from the one at which the paper itself
/// would be used up.
PageLayout fit_several(const PieceShapes& shapes, const PageFrame& frame, int n_pages) {
  PageLayout on_one = fit_one(shapes, frame);
  const double least = on_one.scale / shapes.scale;
  const glm::dvec2 room = frame.net.size();
  const double most = std::max(least, std::sqrt(n_pages * room.x * room.y / shapes.area_mm2));
  constexpr double kStep = 0.95;
  Trials trials(shapes, frame, n_pages);
  double zoom = most;
  while (!trials.fits(zoom)) {
    if (zoom <= least) return on_one;
    zoom = std::max(zoom * kStep, least);
  }
  trials.halve(zoom, std::min(zoom / kStep, most), 6);
  return trials.best();
}

PageLayout fit_zoom(const PieceShapes& shapes, const PageFrame& frame, int n_pages) {
  return n_pages == 1 ? fit_one(shapes, frame) : fit_several(shapes, frame, n_pages);
}

/// Shrinks what fits without tabs until it fits with those that this size has.
PageLayout fit_with_tabs(const Net& net, const PageFrame& frame, int n_pages, const TabSettings& tabs,
                         double bare_scale) {
  constexpr int kRounds = 12;
  // Smaller faces under tabs of the same width: from the second round on the error is of second order.
  constexpr double kSlack = 0.9995;
  double scale = bare_scale;
  for (int round = 0; round < kRounds; ++round) {
    const PieceShapes shapes = piece_shapes(net, scale, tabs);
    std::optional<PageLayout> layout = arrange_on(shapes, frame, Seams::Best);
    if (layout && layout->pages.size() <= static_cast<std::size_t>(n_pages)) {
      layout->tabs = shapes.tabs;
      return *layout;
    }
    scale = std::min(fit_zoom(shapes, frame, n_pages).scale, scale) * (round == 0 ? 1 : kSlack);
  }
  throw Error(ErrorKind::Usage,
              "There is no room for the glue tabs on so little paper; make them narrower or leave them out.");
}

}  // namespace

PageLayout fit_pages(const Net& net, const std::vector<PageFrame>& frames, int n_pages,
                     const TabSettings& tabs) {
  const PieceShapes shapes = piece_shapes(net, 1, no_tabs());
  std::optional<PageLayout> best;
  for (const PageFrame& frame : frames) {
    PageLayout layout = fit_zoom(shapes, frame, n_pages);
    if (tabs.is_on) layout = fit_with_tabs(net, frame, n_pages, tabs, layout.scale);
    if (!best || layout.scale > best->scale * 1.001) best = std::move(layout);
  }
  return *best;
}

}  // namespace netwright
