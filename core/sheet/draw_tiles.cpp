// What joins the sheets of a tiled net: crosses that lie on both neighbours, the line to cut along, the grey
// band that is glued under the next sheets, and the neighbours' names.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/sheet/cut_strip.h"
#include "core/sheet/draw.h"
#include "core/sheet/print_style.h"

namespace netwright {

namespace {

using namespace print_style;

constexpr double kArm = 3;
constexpr double kWordSize = 2.4;
constexpr double kSame_mm = 1e-6;

bool is_same(double a, double b) { return std::abs(a - b) < kSame_mm; }

/// On paper only: a corner where the net ends may lie at the very border of what can be printed.
void draw_cross(Sheet& sheet, const PageView& view, glm::dvec2 at) {
  const Box2 shown = view.window();
  for (const glm::dvec2 arm : {glm::dvec2(kArm, 0), glm::dvec2(0, kArm)})
    sheet.strokes.push_back({Layer::Regmarks,
                             {view.at(glm::max(at - arm, shown.min)), view.at(glm::min(at + arm, shown.max))},
                             false,
                             kHairlineWidth,
                             kQuietInk,
                             {},
                             0});
}

/// The corners of all shares that lie on the border of this page's: every sheet that has a place shows it, so
/// that any two neighbours have two crosses in common.
std::vector<glm::dvec2> crosses_on(const PageView& view) {
  const Box2& own = view.page.share;
  std::vector<glm::dvec2> crosses;
  for (const PageLayout::Page& page : view.layout.pages) {
    if (page.canvas != view.page.canvas) continue;
    for (const double x : {page.share.min.x, page.share.max.x})
      for (const double y : {page.share.min.y, page.share.max.y}) {
        const bool is_inside = x > own.min.x - kSame_mm && x < own.max.x + kSame_mm &&
                               y > own.min.y - kSame_mm && y < own.max.y + kSame_mm;
        const bool is_known = std::any_of(crosses.begin(), crosses.end(), [&](glm::dvec2 other) {
          return is_same(other.x, x) && is_same(other.y, y);
        });
        if (is_inside && !is_known) crosses.emplace_back(x, y);
      }
  }
  return crosses;
}

/// One side of a sheet.
struct Side {
  int axis = 0;                ///< that the side's seam crosses: 0 where neighbours are left or right
  bool is_glued_over = false;  ///< the high side: its strip stays and the neighbours are glued on it; else it
                               ///< is cut off
};

/// The neighbour's part of this side; nothing (low >= high) where it is none.
Span joint_with(const PageView& view, const Side& side, const PageLayout::Page& other) {
  const Box2& own = view.page.share;
  const int along = 1 - side.axis;
  const bool touches = other.canvas == view.page.canvas &&
                       (side.is_glued_over ? is_same(other.share.min[side.axis], own.max[side.axis])
                                           : is_same(other.share.max[side.axis], own.min[side.axis]));
  if (!touches) return {};
  return {std::max(own.min[along], other.share.min[along]), std::min(own.max[along], other.share.max[along])};
}

/// A neighbour's name and the strip of paper that it is joined by, which ends where this sheet does.
struct Joint {
  Box2 strip;
  std::string tag;
};

std::vector<Joint> joints_at(const PageView& view, const Side& side) {
  const Box2 shown = view.window();
  const Box2& own = view.page.share;
  const int along = 1 - side.axis;
  std::vector<Joint> joints;
  for (const PageLayout::Page& other : view.layout.pages) {
    const Span common = joint_with(view, side, other);
    if (common.high - common.low < kSame_mm) continue;
    Joint joint{shown, other.tag};
    (side.is_glued_over ? joint.strip.min : joint.strip.max)[side.axis] =
        side.is_glued_over ? own.max[side.axis] : own.min[side.axis];
    if (!is_same(common.low, own.min[along])) joint.strip.min[along] = common.low;
    if (!is_same(common.high, own.max[along])) joint.strip.max[along] = common.high;
    joints.push_back(std::move(joint));
  }
  return joints;
}

/// Words stand beside the crosses, where the middle of a side would more often meet the net.
void draw_words(Sheet& sheet, const PageView& view, const Side& side, const Joint& joint, const Font& font) {
  const std::string words =
      side.is_glued_over ? "glue " + joint.tag + " here" : "cut off, glue on " + joint.tag;
  const glm::dvec2 middle = view.at(joint.strip.centre());
  const glm::dvec2 one = view.at(joint.strip.min);
  const glm::dvec2 other = view.at(joint.strip.max);
  const glm::dvec2 low = glm::min(one, other);
  const double beside = view.layout.overlap_mm * 1.15;
  const bool is_upright = side.axis == 0;
  const double drop = kWordSize * 0.36;
  const glm::dvec2 at =
      is_upright ? glm::dvec2(middle.x - drop, low.y + beside) : glm::dvec2(low.x + beside, middle.y + drop);
  const double room = (is_upright ? glm::abs(other.y - one.y) : glm::abs(other.x - one.x)) - 2 * beside;
  if (font.width(words, kWordSize) > room) return;
  sheet.texts.push_back({Layer::Print, at, words, kWordSize, FontWeight::Regular, kQuietInk,
                         is_upright ? std::numbers::pi / 2 : 0});
}

void draw_side(Sheet& sheet, const PageView& view, const Side& side, const Font& font) {
  const std::vector<Joint> joints = joints_at(view, side);
  if (joints.empty()) return;
  if (side.is_glued_over)
    for (const Joint& joint : joints)
      sheet.fills.push_back({Layer::Print,
                             {view.at(joint.strip.min), view.at({joint.strip.max.x, joint.strip.min.y}),
                              view.at(joint.strip.max), view.at({joint.strip.min.x, joint.strip.max.y})},
                             kGlueBand});
  // One line for all neighbours: a sheet is cut off along all of its side.
  const Box2 shown = view.window();
  glm::dvec2 from = shown.min;
  glm::dvec2 to = shown.max;
  from[side.axis] = to[side.axis] =
      side.is_glued_over ? view.page.share.max[side.axis] : view.page.share.min[side.axis];
  sheet.strokes.push_back({Layer::Print,
                           {view.at(from), view.at(to)},
                           false,
                           kHairlineWidth,
                           side.is_glued_over ? kHairline : kQuietInk,
                           side.is_glued_over ? std::vector<double>{} : std::vector<double>{4, 2},
                           0});
  for (const Joint& joint : joints) draw_words(sheet, view, side, joint, font);
}

}  // namespace

void draw_tile_marks(Sheet& sheet, const PageView& view, const Font& font) {
  for (const glm::dvec2 cross : crosses_on(view)) draw_cross(sheet, view, cross);
  for (const Side side : {Side{0, false}, Side{0, true}, Side{1, false}, Side{1, true}})
    draw_side(sheet, view, side, font);
}

}  // namespace netwright
