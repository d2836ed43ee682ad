// What joins the sheets of a tiled net: crosses that lie on both neighbours, the line to cut along, the grey
// band that is glued under the next sheet, and the neighbours' names.
#include <array>
#include <numbers>
#include <string>
#include <utility>

#include "core/sheet/draw.h"
#include "core/sheet/print_style.h"

namespace netwright {

namespace {

using namespace print_style;

constexpr double kArm = 3;
constexpr double kWordSize = 2.4;

/// The tile so many steps away, if it is printed; else null.
const PageLayout::Page* neighbour(const PageView& view, int right, int down) {
  for (const PageLayout::Page& other : view.layout.pages)
    if (other.canvas == view.page.canvas && other.column == view.page.column + right &&
        other.row == view.page.row + down)
      return &other;
  return nullptr;
}

/// Where a page is joined with its neighbours, on the canvas; half an overlap inside of what it shows where
/// it has none.
Box2 joints_of(const PageView& view) {
  const double half = view.layout.overlap_mm / 2;
  return {view.window().min + half, view.window().max - half};
}

void draw_cross(Sheet& sheet, glm::dvec2 at) {
  for (const glm::dvec2 arm : {glm::dvec2(kArm, 0), glm::dvec2(0, kArm)})
    sheet.strokes.push_back({Layer::Regmarks, {at - arm, at + arm}, false, kHairlineWidth, kQuietInk, {}, 0});
}

/// One joint: its line, and the strip of paper beyond it.
struct Joint {
  Box2 strip;  ///< on the canvas
  glm::dvec2 from{0, 0};
  glm::dvec2 to{0, 0};
  bool is_glued_over = false;  ///< the strip stays and the neighbour is glued on it; else it is cut off
};

Joint joint_at(const PageView& view, int right, int down) {
  const Box2 shown = view.window();
  const Box2 lines = joints_of(view);
  Joint joint{shown, shown.min, shown.max, right + down > 0};
  const int axis = right != 0 ? 0 : 1;
  const double line = joint.is_glued_over ? lines.max[axis] : lines.min[axis];
  (joint.is_glued_over ? joint.strip.min : joint.strip.max)[axis] = line;
  joint.from[axis] = joint.to[axis] = line;
  return joint;
}

void draw_joint(Sheet& sheet, const PageView& view, const Joint& joint, const std::string& tag,
                const Font& font) {
  const Box2& strip = joint.strip;
  if (joint.is_glued_over)
    sheet.fills.push_back({Layer::Print,
                           {view.at(strip.min), view.at({strip.max.x, strip.min.y}), view.at(strip.max),
                            view.at({strip.min.x, strip.max.y})},
                           kGlueBand});
  sheet.strokes.push_back({Layer::Print,
                           {view.at(joint.from), view.at(joint.to)},
                           false,
                           kHairlineWidth,
                           joint.is_glued_over ? kHairline : kQuietInk,
                           joint.is_glued_over ? std::vector<double>{} : std::vector<double>{4, 2},
                           0});
  const std::string words = joint.is_glued_over ? "glue " + tag + " here" : "cut off, glue on " + tag;
  // Words stand beside the crosses, where the middle of a side would more often meet the net.
  const glm::dvec2 middle = view.at(strip.centre());
  const glm::dvec2 one = view.at(strip.min);
  const glm::dvec2 other = view.at(strip.max);
  const glm::dvec2 low = glm::min(one, other);
  const double beside = view.layout.overlap_mm * 1.15;
  const bool is_upright = joint.from.x == joint.to.x;
  const double drop = kWordSize * 0.36;
  const glm::dvec2 at =
      is_upright ? glm::dvec2(middle.x - drop, low.y + beside) : glm::dvec2(low.x + beside, middle.y + drop);
  const double room = (is_upright ? glm::abs(other.y - one.y) : glm::abs(other.x - one.x)) - 2 * beside;
  if (font.width(words, kWordSize) > room) return;
  sheet.texts.push_back({Layer::Print, at, words, kWordSize, FontWeight::Regular, kQuietInk,
                         is_upright ? std::numbers::pi / 2 : 0});
}

}  // namespace

void draw_tile_marks(Sheet& sheet, const PageView& view, const Font& font) {
  const Box2 lines = joints_of(view);
  for (const double x : {lines.min.x, lines.max.x})
    for (const double y : {lines.min.y, lines.max.y}) draw_cross(sheet, view.at({x, y}));
  constexpr std::array<std::pair<int, int>, 4> kSides = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  for (const auto& [right, down] : kSides)
    if (const PageLayout::Page* const other = neighbour(view, right, down))
      draw_joint(sheet, view, joint_at(view, right, down), other->tag, font);
}

}  // namespace netwright
