// A piece's motion is that of the face its place belongs to: from there it follows how the whole piece lies.
#include "core/sheet/placing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/base/counted.h"
#include "core/base/polygon2.h"
#include "core/sheet/arranger.h"
#include "core/sheet/piece_shapes.h"
#include "core/sheet/print_style.h"
#include "core/unfold/overlap.h"

namespace netwright {

namespace {

/// Pieces may touch, and reach this far over an edge or into each other: below what a printer shows.
constexpr double kTouch_mm = 0.02;

/// The placement with its shift in millimetres.
Rigid2 in_mm(Rigid2 placement, double scale) {
  placement.x *= scale;
  placement.y *= scale;
  return placement;
}

std::optional<PageFrame> frame_of(const PaperSetup& paper, bool is_landscape) {
  for (const PageFrame& frame : possible_frames(paper))
    if (frame.is_landscape() == is_landscape) return frame;
  return std::nullopt;
}

/// How the pieces lie; nothing unless every piece has exactly one place.
std::optional<std::vector<PageLayout::Placement>> placements(const Net& net, const HandLayout& placed) {
  std::vector<PageLayout::Placement> pieces(static_cast<std::size_t>(net.n_pieces), {-1, {}});
  if (placed.places.size() != pieces.size()) return std::nullopt;
  for (const HandLayout::Place& place : placed.places) {
    const bool is_known = place.face.is_valid() && place.face.index() < net.placement.size() &&
                          place.canvas >= 0 && place.canvas < static_cast<int>(placed.canvases.size());
    if (!is_known) return std::nullopt;
    PageLayout::Placement& piece = pieces[static_cast<std::size_t>(net.piece[place.face])];
    if (piece.canvas >= 0) return std::nullopt;
    piece = {place.canvas, place.turn * in_mm(net.placement[place.face], placed.scale).inverse()};
  }
  return pieces;
}

/// Canvases and pages; a canvas without pieces gives no page.
void add_canvases(PageLayout& layout, const HandLayout& placed, const PieceShapes& shapes) {
  const glm::dvec2 room = layout.frame.net.size();
  std::vector<TiledArea> areas(placed.canvases.size());
  for (std::size_t piece = 0; piece < shapes.pieces.size(); ++piece)
    add_to_area(areas[static_cast<std::size_t>(layout.pieces[piece].canvas)], shapes.pieces[piece],
                layout.pieces[piece].turn);
  int n_lettered_rows = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const HandLayout::Canvas& canvas = placed.canvases[i];
    if (canvas.columns * canvas.rows > 1) {
      const Tiling tiling = tile_area(areas[i], room, layout.overlap_mm);
      add_tiled_canvas(layout, tiling, canvas.columns, canvas.rows, n_lettered_rows);
      n_lettered_rows += tiling.n_rows;
    } else {
      if (!areas[i].box.is_empty()) layout.pages.push_back({static_cast<int>(i), 0, 0, {0, 0}, ""});
      layout.canvases.push_back({room.x, room.y, 1, 1, 0});
    }
  }
}

/// The net as it lies on its canvases, in mm, with canvases in the place of pieces.
Net on_canvases(Net net, const PageLayout& layout) {
  for (const FaceId f : net.mesh().faces()) {
    const PageLayout::Placement& piece = layout.pieces[static_cast<std::size_t>(net.piece[f])];
    Rigid2 placement = piece.turn * in_mm(net.placement[f], layout.scale);
    placement.x /= layout.scale;
    placement.y /= layout.scale;
    net.placement[f] = placement;
    net.piece[f] = piece.canvas;
  }
  net.n_pieces = static_cast<int>(layout.canvases.size());
  return net;
}

bool reaches_over(const PageLayout& layout, int piece, std::span<const glm::dvec2> corners_mm) {
  const auto& canvas =
      layout.canvases[static_cast<std::size_t>(layout.pieces[static_cast<std::size_t>(piece)].canvas)];
  return std::any_of(corners_mm.begin(), corners_mm.end(), [&](glm::dvec2 corner) {
    const glm::dvec2 p = layout.on_canvas_mm(piece, corner);
    return p.x < -kTouch_mm || p.y < -kTouch_mm || p.x > canvas.width_mm + kTouch_mm ||
           p.y > canvas.height_mm + kTouch_mm;
  });
}

std::vector<glm::dvec2> corners_mm(const Net& net, const PageLayout& layout, FaceId f) {
  std::vector<glm::dvec2> corners;
  for (const HalfedgeId h : net.mesh().halfedges(f)) corners.push_back(net.corner(h) * layout.scale);
  return corners;
}

void find_over_edge(const Net& net, const PageLayout& layout, Misplaced& misplaced) {
  const auto look = [&](FaceId f, std::span<const glm::dvec2> corners) {
    if (!reaches_over(layout, net.piece[f], corners)) return;
    misplaced.over_edge.push_back(net.piece[f]);
    misplaced.faces.push_back(f);
  };
  for (const FaceId f : net.mesh().faces()) look(f, corners_mm(net, layout, f));
  for (const GlueTab& tab : layout.tabs.tabs) look(net.mesh().face(tab.side), tab.points);
}

/// A convex part of a face, or a tab, on its canvas.
struct Patch {
  FaceId face;
  int piece = 0;
  int canvas = 0;
  std::vector<glm::dvec2> points;
  Box2 box;
};

Patch patch_of(const Net& net, const PageLayout& layout, FaceId f, std::span<const glm::dvec2> points_mm) {
  const int piece = net.piece[f];
  Patch patch{f, piece, layout.pieces[static_cast<std::size_t>(piece)].canvas, {}, {}};
  for (const glm::dvec2 p : points_mm) {
    patch.points.push_back(layout.on_canvas_mm(piece, p));
    patch.box.add(patch.points.back());
  }
  return patch;
}

/// How far the two would have to be moved apart along the best of the first one's sides.
double depth_by_sides(const Patch& of, const Patch& other) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < of.points.size(); ++i) {
    const glm::dvec2 a = of.points[i];
    const glm::dvec2 along = of.points[(i + 1) % of.points.size()] - a;
    const double length = glm::length(along);
    if (!(length > 0)) continue;
    // On paper y points down, so a counter-clockwise outline has its inside on the right.
    double deepest = -std::numeric_limits<double>::infinity();
    for (const glm::dvec2 p : other.points) deepest = std::max(deepest, -cross(along, p - a) / length);
    least = std::min(least, deepest);
  }
  return least;
}

bool cover_each_other(const Patch& a, const Patch& b) {
  const bool may_meet = a.canvas == b.canvas && a.piece != b.piece && a.box.min.x < b.box.max.x &&
                        b.box.min.x < a.box.max.x && a.box.min.y < b.box.max.y && b.box.min.y < a.box.max.y;
  return may_meet && depth_by_sides(a, b) > kTouch_mm && depth_by_sides(b, a) > kTouch_mm;
}

/// Tabs that cover another piece, its faces or its tabs.
void find_covering_tabs(const Net& net, const PageLayout& layout, Misplaced& misplaced) {
  std::vector<Patch> tabs;
  for (const GlueTab& tab : layout.tabs.tabs)
    tabs.push_back(patch_of(net, layout, net.mesh().face(tab.side), tab.points));
  std::vector<Patch> all = tabs;
  for (const FaceId f : net.mesh().faces()) {
    const std::vector<glm::dvec2> corners = corners_mm(net, layout, f);
    for (const std::vector<int>& part : convex_parts(corners)) {
      std::vector<glm::dvec2> points;
      for (const int i : part) points.push_back(corners[static_cast<std::size_t>(i)]);
      all.push_back(patch_of(net, layout, f, points));
    }
  }
  for (const Patch& tab : tabs)
    for (const Patch& other : all) {
      if (!cover_each_other(tab, other)) continue;
      misplaced.overlapping.emplace_back(std::min(tab.piece, other.piece), std::max(tab.piece, other.piece));
      misplaced.faces.insert(misplaced.faces.end(), {tab.face, other.face});
    }
}

template <class Value>
void make_unique(std::vector<Value>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

HandLayout as_placed(const Net& net, const PageLayout& layout) {
  HandLayout placed;
  placed.is_landscape = layout.frame.is_landscape();
  placed.scale = layout.scale;
  for (const PageLayout::Canvas& canvas : layout.canvases)
    placed.canvases.push_back({canvas.columns, canvas.rows});
  for (const FaceId root : net.tree.roots()) {
    const PageLayout::Placement& piece = layout.pieces[static_cast<std::size_t>(net.piece[root])];
    placed.places.push_back({root, piece.canvas, piece.turn * in_mm(net.placement[root], layout.scale)});
  }
  return placed;
}

std::optional<PageLayout> lay_out(const Net& net, const PaperSetup& paper, const HandLayout& placed,
                                  const TabSettings& tabs) {
  return lay_out(net, paper, placed, tabs.is_on ? place_tabs(net, placed.scale, tabs) : GlueTabs());
}

std::optional<PageLayout> lay_out(const Net& net, const PaperSetup& paper, const HandLayout& placed,
                                  GlueTabs tabs) {
  const std::optional<PageFrame> frame = frame_of(paper, placed.is_landscape);
  auto pieces = placements(net, placed);
  if (!frame || !pieces) return std::nullopt;
  PageLayout layout;
  layout.scale = placed.scale;
  layout.model_height_mm = placed.scale * net.mesh().height();
  layout.frame = *frame;
  layout.overlap_mm = print_style::kTileOverlap;
  layout.pieces = std::move(*pieces);
  PieceShapes shapes = piece_shapes(net, layout.scale, std::move(tabs));
  add_canvases(layout, placed, shapes);
  layout.tabs = std::move(shapes.tabs);
  return layout;
}

HandLayout carry_places(const HandLayout& placed, const Net& before, const Net& after,
                        const std::vector<FaceId>& moved) {
  const auto pieces = placements(before, placed);
  if (!pieces) return {};
  std::vector<char> is_moved(after.placement.size(), 0);
  for (const FaceId f : moved) is_moved[f.index()] = 1;
  // What a place belongs to speaks for its piece; else any face that stays; else any face at all.
  std::vector<FaceId> speaker(static_cast<std::size_t>(after.n_pieces));
  const auto propose = [&](FaceId f) {
    FaceId& chosen = speaker[static_cast<std::size_t>(after.piece[f])];
    const bool is_better = !chosen.is_valid() || (is_moved[chosen.index()] != 0 && is_moved[f.index()] == 0);
    if (is_better) chosen = f;
  };
  for (const HandLayout::Place& place : placed.places) propose(place.face);
  for (const FaceId f : after.mesh().faces()) propose(f);
  HandLayout carried = placed;
  carried.places.clear();
  for (const FaceId f : speaker) {
    const PageLayout::Placement& piece = (*pieces)[static_cast<std::size_t>(before.piece[f])];
    carried.places.push_back({f, piece.canvas, piece.turn * in_mm(before.placement[f], placed.scale)});
  }
  return carried;
}

Misplaced find_misplaced(const Net& net, const PageLayout& layout) {
  Misplaced misplaced;
  find_over_edge(net, layout, misplaced);
  if (net.n_pieces > 1) {
    const double depth = kTouch_mm / (layout.scale * net.mesh().mean_edge());
    for (const Overlap& overlap : find_overlaps(on_canvases(net, layout), depth)) {
      const auto [low, high] = std::minmax(net.piece[overlap.first], net.piece[overlap.second]);
      if (low == high) continue;
      misplaced.overlapping.emplace_back(low, high);
      misplaced.faces.insert(misplaced.faces.end(), {overlap.first, overlap.second});
    }
    find_covering_tabs(net, layout, misplaced);
  }
  make_unique(misplaced.over_edge);
  make_unique(misplaced.overlapping);
  make_unique(misplaced.faces);
  return misplaced;
}

std::string misplaced_sentence(const Misplaced& misplaced) {
  if (misplaced.is_nothing()) return {};
  const auto over = static_cast<std::int64_t>(misplaced.over_edge.size());
  const auto pairs = static_cast<std::int64_t>(misplaced.overlapping.size());
  std::string text;
  if (pairs > 0) text = pairs == 1 ? "Two pieces overlap" : "Pieces overlap in " + grouped(pairs) + " places";
  if (over > 0) {
    text += text.empty() ? (over == 1 ? "A piece reaches" : grouped(over) + " pieces reach")
                         : (over == 1 ? " and one reaches" : " and " + grouped(over) + " reach");
    text += " over the edge of the page";
  }
  return text + ": move what is marked red (A), or re-arrange all (Shift+A).";
}

}  // namespace netwright
