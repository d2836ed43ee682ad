// Puts the sheets together: per page the net's lines, the marks of a tile, the title block, legend and ruler,
// and on the first page a test square where there is room.
#include "core/sheet/sheet.h"

#include <algorithm>
#include <cmath>

#include "core/sheet/draw.h"
#include "core/sheet/outline.h"
#include "core/sheet/piece_pictures.h"
#include "core/sheet/print_style.h"

namespace netwright {

namespace {

using namespace print_style;

/// Outlines of a canvas as segments on the page.
std::vector<Segment> outline_on_page(const NetLines& lines, const PageView& view) {
  std::vector<Segment> segments;
  for (const NetLines::Outline& outline : lines.outlines) {
    if (outline.canvas != view.page.canvas) continue;
    for (std::size_t i = 0; i < outline.points.size(); ++i)
      segments.emplace_back(view.at(outline.points[i]),
                            view.at(outline.points[(i + 1) % outline.points.size()]));
  }
  return segments;
}

/// Corners first, then along the sides: out of the way of the net, and of one that is cut out.
std::vector<glm::dvec2> square_corners(const Box2& frame) {
  const glm::dvec2 room = frame.size() - kSquare;
  std::vector<glm::dvec2> corners;
  for (int k = 0; k <= 12; ++k) {
    const double share = k / 12.0;
    for (const glm::dvec2 at : {glm::dvec2(1, 1 - share), glm::dvec2(0, 1 - share), glm::dvec2(1 - share, 1),
                                glm::dvec2(1 - share, 0)})
      corners.push_back(frame.min + room * at);
  }
  return corners;
}

bool is_free(const Box2& box, const std::vector<Segment>& outline) {
  if (std::any_of(outline.begin(), outline.end(),
                  [&](const Segment& s) { return clip_segment(box, s.first, s.second).has_value(); }))
    return false;
  return winding_number(outline, box.centre()) == 0;
}

}  // namespace

void draw_test_square(Sheet& sheet, const NetLines& lines, const PageView& view) {
  constexpr double kDistance = 4;
  const Box2 frame = view.frame;
  if (frame.size().x < kSquare || frame.size().y < kSquare) return;
  const std::vector<Segment> outline = outline_on_page(lines, view);
  for (const glm::dvec2 low : square_corners(frame)) {
    const glm::dvec2 high = low + kSquare;
    if (!is_free({low - kDistance, high + kDistance}, outline)) continue;
    sheet.strokes.push_back({Layer::Print,
                             {low, {high.x, low.y}, high, {low.x, high.y}},
                             true,
                             kHairlineWidth,
                             kQuietInk,
                             {},
                             0});
    sheet.texts.push_back({Layer::Print,
                           {low.x + 2, high.y - 2},
                           "50 mm × 50 mm, to check the print",
                           2.3,
                           FontWeight::Regular,
                           kQuietInk});
    return;
  }
}

std::vector<Sheet> draw_sheets(const Net& net, const PageLayout& layout, const SheetInfo& info,
                               const SheetSettings& settings) {
  const NetLines lines = net_lines(net, layout, settings);
  const PictureArtist pictures(net, layout, settings);
  const PlacedLabels labels = place_labels(net, layout, settings);
  const MarginArtist margin(layout, title_words(net, layout, info, labels.left_out.size()), settings.lines);
  std::vector<Sheet> sheets;
  for (const PageLayout::Page& page : layout.pages) {
    Sheet sheet;
    sheet.width_mm = layout.frame.width_mm;
    sheet.height_mm = layout.frame.height_mm;
    sheet.number = static_cast<int>(sheets.size()) + 1;
    sheet.count = static_cast<int>(layout.pages.size());
    sheet.tag = page.tag;
    const bool is_tile = layout.canvases[static_cast<std::size_t>(page.canvas)].is_tiled();
    const PageView view{layout, page, false, layout.frame.net};
    if (sheets.empty() && !is_tile) draw_test_square(sheet, lines, view);
    if (is_tile) draw_tile_marks(sheet, view, margin.font());
    pictures.draw(sheet, view);
    draw_net(sheet, lines, view, settings.lines);
    draw_labels(sheet, labels, view);
    margin.draw(sheet, view, "The printed side is the outside.");
    sheets.push_back(std::move(sheet));
  }
  return sheets;
}

}  // namespace netwright
