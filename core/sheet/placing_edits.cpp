// Motions are of canvases, where y points up like in the net; boxes are as printed, y down.
#include "core/sheet/placing_edits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/sheet/outline.h"

namespace netwright {

namespace {

constexpr double kQuarter_rad = std::numbers::pi / 2;
constexpr double kStep_rad = std::numbers::pi / 12;
constexpr std::size_t kMostLevelEdges = 12;  ///< with more of them every angle would be one of theirs

Rigid2 shift(double x, double y) { return {1, 0, x, y}; }

bool holds(const std::vector<int>& pieces, int piece) {
  return std::find(pieces.begin(), pieces.end(), piece) != pieces.end();
}

/// Canvases that nothing lies on go; the others close up.
void drop_empty_canvases(HandLayout& placed) {
  std::vector<int> number(placed.canvases.size(), -1);
  for (const HandLayout::Place& place : placed.places) number[static_cast<std::size_t>(place.canvas)] = 0;
  std::vector<HandLayout::Canvas> kept;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(kept.size());
    kept.push_back(placed.canvases[i]);
  }
  for (HandLayout::Place& place : placed.places)
    place.canvas = number[static_cast<std::size_t>(place.canvas)];
  placed.canvases = std::move(kept);
}

/// How far a box goes to be aligned with another one, in mm, y down.
glm::dvec2 way_to(const Box2& box, const Box2& goal, Align where) {
  switch (where) {
    case Align::Left:
      return {goal.min.x - box.min.x, 0};
    case Align::Right:
      return {goal.max.x - box.max.x, 0};
    case Align::Top:
      return {0, goal.min.y - box.min.y};
    case Align::Bottom:
      return {0, goal.max.y - box.max.y};
    case Align::CentreAcross:
      return {goal.centre().x - box.centre().x, 0};
    case Align::CentreUpright:
      return {0, goal.centre().y - box.centre().y};
  }
  return {0, 0};
}

double wrapped(double angle_rad, double period_rad) {
  const double rest = std::fmod(angle_rad, period_rad);
  return rest < 0 ? rest + period_rad : rest;
}

}  // namespace

HandLayout move_pieces(const Net& net, const PageLayout& layout, const std::vector<PieceMotion>& motions) {
  HandLayout placed = as_placed(net, layout);
  for (HandLayout::Place& place : placed.places) {
    const auto wanted = std::find_if(motions.begin(), motions.end(), [&](const PieceMotion& motion) {
      return motion.piece == net.piece[place.face];
    });
    if (wanted == motions.end()) continue;
    place.turn = wanted->motion * place.turn;
    place.canvas = wanted->canvas;
    if (place.canvas >= static_cast<int>(placed.canvases.size()))
      placed.canvases.resize(static_cast<std::size_t>(place.canvas) + 1);
  }
  drop_empty_canvases(placed);
  return placed;
}

HandLayout resize_pieces(const Net& net, const PaperSetup& paper, const PageLayout& layout, double scale,
                         const TabSettings& tabs) {
  const bool has_tiles = std::any_of(layout.canvases.begin(), layout.canvases.end(),
                                     [](const PageLayout::Canvas& canvas) { return canvas.is_tiled(); });
  if (has_tiles) return {};
  HandLayout placed = as_placed(net, layout);
  for (HandLayout::Place& place : placed.places) {
    const glm::dvec2 middle = box_on_canvas(net, layout, net.piece[place.face]).centre();
    const glm::dvec2 centre(middle.x, -middle.y);
    const glm::dvec2 in_face = place.turn.inverse()(centre) * (scale / layout.scale);
    const glm::dvec2 offset = centre - place.turn.rotate(in_face);
    place.turn.x = offset.x;
    place.turn.y = offset.y;
  }
  placed.scale = scale;
  const std::optional<PageLayout> resized = lay_out(net, paper, placed, tabs);
  return resized && find_misplaced(net, *resized).is_nothing() ? placed : HandLayout();
}

Box2 box_on_canvas(const Net& net, const PageLayout& layout, int piece) {
  Box2 box;
  for (const FaceId f : net.mesh().faces()) {
    if (net.piece[f] != piece) continue;
    for (const HalfedgeId h : net.mesh().halfedges(f)) box.add(layout.on_canvas(piece, net.corner(h)));
  }
  for (const GlueTab& tab : layout.tabs.tabs) {
    if (net.piece[net.mesh().face(tab.side)] != piece) continue;
    for (const glm::dvec2 p : tab.points) box.add(layout.on_canvas_mm(piece, p));
  }
  return box;
}

HandLayout align_pieces(const Net& net, const PageLayout& layout, const std::vector<int>& pieces,
                        Align where) {
  std::vector<Box2> boxes;
  Box2 goal;
  for (const int piece : pieces) {
    boxes.push_back(box_on_canvas(net, layout, piece));
    goal.add(boxes.back());
  }
  std::vector<PieceMotion> motions;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const int canvas = layout.pieces[static_cast<std::size_t>(pieces[i])].canvas;
    const PageLayout::Canvas& sheet = layout.canvases[static_cast<std::size_t>(canvas)];
    if (pieces.size() == 1) goal = {{0, 0}, {sheet.width_mm, sheet.height_mm}};
    const glm::dvec2 way = way_to(boxes[i], goal, where);
    motions.push_back({pieces[i], canvas, shift(way.x, -way.y)});
  }
  return move_pieces(net, layout, motions);
}

std::vector<double> level_turns(const Net& net, const PageLayout& layout, const std::vector<int>& pieces) {
  std::vector<std::pair<double, double>> edges;  // length and turn
  for (const OutlineLoop& loop : outline_loops(net)) {
    if (!holds(pieces, loop.piece)) continue;
    const Rigid2& turn = layout.pieces[static_cast<std::size_t>(loop.piece)].turn;
    for (std::size_t i = 0; i < loop.sides.size(); ++i) {
      const glm::dvec2 along =
          turn.rotate(net.corner(loop.sides[(i + 1) % loop.sides.size()]) - net.corner(loop.sides[i]));
      edges.emplace_back(glm::length(along), wrapped(-std::atan2(along.y, along.x), kQuarter_rad));
    }
  }
  std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<double> turns;
  for (const auto& [length, turn] : edges) {
    constexpr double kSame_rad = 1e-6;
    const bool is_new = std::none_of(turns.begin(), turns.end(),
                                     [&](double known) { return std::abs(known - turn) < kSame_rad; });
    if (is_new) turns.push_back(turn);
    if (turns.size() == kMostLevelEdges) break;
  }
  std::sort(turns.begin(), turns.end());
  return turns;
}

double snapped_turn(double angle_rad, const std::vector<double>& level_turns) {
  double best = std::round(angle_rad / kStep_rad) * kStep_rad;
  for (const double turn : level_turns) {
    const double level = turn + std::round((angle_rad - turn) / kQuarter_rad) * kQuarter_rad;
    if (std::abs(level - angle_rad) < std::abs(best - angle_rad)) best = level;
  }
  return best;
}

}  // namespace netwright
