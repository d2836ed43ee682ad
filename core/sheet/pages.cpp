// The layout of pages: for each orientation the paper allows, every piece is turned, packed or tiled; the
// orientation that prints larger (fit to page), or tiles fewer pieces and needs fewer pages (a given size),
// is kept.
#include "core/sheet/pages.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/sheet/arranger.h"
#include "core/sheet/fit_pages.h"

namespace netwright {

namespace {

/// A piece that is whole on one page beats one in tiles, whatever the pages; then fewer pages.
bool is_better(const PageLayout& a, const PageLayout& b) {
  const auto cost = [](const PageLayout& layout) {
    return std::pair(std::ranges::count_if(layout.canvases, &PageLayout::Canvas::is_tiled),
                     layout.pages.size());
  };
  return cost(a) < cost(b);
}

}  // namespace

PageLayout arrange(const Net& net, const PaperSetup& paper, const PrintSize& size, const TabSettings& tabs) {
  const std::vector<PageFrame> frames = possible_frames(paper);
  const std::optional<double> scale = scale_of(net.mesh(), size);
  if (!scale) {
    const bool is_several = size.kind == PrintSize::Kind::FitSheets;
    return fit_pages(net, frames, is_several ? size.sheets : 1, tabs);
  }
  PieceShapes shapes = piece_shapes(net, *scale, tabs);
  std::optional<PageLayout> best;
  for (const PageFrame& frame : frames) {
    std::optional<PageLayout> layout = arrange_on(shapes, frame, Seams::Best);
    if (layout && (!best || is_better(*layout, *best))) best = std::move(layout);
  }
  if (!best)
    throw Error(ErrorKind::Usage, "A model with " + size_words(size) + " would take more than " +
                                      std::to_string(kMostPages) + " pages of " + paper.format +
                                      "; print it smaller or on larger paper.");
  best->tabs = std::move(shapes.tabs);
  return *best;
}

Net spread_pieces(Net net) {
  if (net.n_pieces < 2) return net;
  std::vector<Box2> boxes(static_cast<std::size_t>(net.n_pieces));
  double area = 0;
  double widest = 0;
  for (const FaceId f : net.mesh().faces()) boxes[static_cast<std::size_t>(net.piece[f])].add(net.box(f));
  for (const Box2& box : boxes) {
    area += box.size().x * box.size().y;
    widest = std::max(widest, box.size().x);
  }
  // Rows from left to right, about as wide as all of it is high.
  const double row_width = std::max(widest, 1.2 * std::sqrt(area));
  const double gap = 0.02 * row_width;
  glm::dvec2 at(0, 0);
  double row_height = 0;
  std::vector<glm::dvec2> shifts;
  for (const Box2& box : boxes) {
    if (at.x > 0 && at.x + box.size().x > row_width) {
      at = {0, at.y + row_height + gap};
      row_height = 0;
    }
    shifts.push_back(at - box.min);
    at.x += box.size().x + gap;
    row_height = std::max(row_height, box.size().y);
  }
  for (const FaceId f : net.mesh().faces()) {
    net.placement[f].x += shifts[static_cast<std::size_t>(net.piece[f])].x;
    net.placement[f].y += shifts[static_cast<std::size_t>(net.piece[f])].y;
  }
  return net;
}

}  // namespace netwright
