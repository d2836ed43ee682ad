// Outlines are walked side by side; where a tab grows from a side, the outline goes round its rim.
#include "core/sheet/piece_shapes.h"

#include <utility>

#include "core/base/best_angle.h"
#include "core/base/geometry.h"
#include "core/sheet/outline.h"
#include "core/unfold/fold.h"

namespace netwright {

namespace {

constexpr double kLabelRadius_mm = 1.5;

void add_rim(const GlueTab& tab, std::vector<glm::dvec2>& outline) {
  // A tab lists the side's two ends first; its rim leads on from where the side begins.
  for (std::size_t i = 2; i < tab.points.size(); ++i) outline.push_back(tab.points[i]);
}

NetMark tab_mark(const GlueTab& tab) {
  NetMark mark;
  for (const glm::dvec2 p : tab.points)
    if (mark.n_points < 4) mark.points[static_cast<std::size_t>(mark.n_points++)] = p;
  return mark;
}

std::size_t piece_of(const Net& net, HalfedgeId h) {
  return static_cast<std::size_t>(net.piece[net.mesh().face(h)]);
}

/// Folds that are seen, tabs, and a number in the middle of every side that is glued.
void add_marks(const Net& net, PieceShapes& shapes) {
  const Mesh& mesh = net.mesh();
  const IdVector<EdgeId, EdgeKind> kinds = edge_kinds(net);
  for (const HalfedgeId h : mesh.halfedges()) {
    const EdgeKind kind = kinds[mesh.edge(h)];
    const glm::dvec2 from = net.corner(h) * shapes.scale;
    const glm::dvec2 to = net.corner(mesh.next(h)) * shapes.scale;
    std::vector<NetMark>& marks = shapes.pieces[piece_of(net, h)].marks;
    const bool is_fold = kind == EdgeKind::Mountain || kind == EdgeKind::Valley;
    if (is_fold && h == mesh.halfedge(mesh.edge(h))) marks.push_back({{from, to}, 2, 0});
    if (kind == EdgeKind::Cut) marks.push_back({{(from + to) * 0.5}, 1, kLabelRadius_mm});
  }
  for (const GlueTab& tab : shapes.tabs.tabs)
    shapes.pieces[piece_of(net, tab.side)].marks.push_back(tab_mark(tab));
}

double area_of(const std::vector<glm::dvec2>& outline) {
  double area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    area += cross(outline[i], outline[(i + 1) % outline.size()]) / 2;
  return area;
}

}  // namespace

PieceShapes piece_shapes(const Net& net, double scale, const TabSettings& tabs) {
  return piece_shapes(net, scale, tabs.is_on ? place_tabs(net, scale, tabs) : GlueTabs());
}

PieceShapes piece_shapes(const Net& net, double scale, GlueTabs tabs) {
  PieceShapes shapes;
  shapes.scale = scale;
  shapes.model_height_mm = scale * net.mesh().height();
  shapes.tabs = std::move(tabs);
  shapes.pieces.resize(static_cast<std::size_t>(net.n_pieces));
  const IdVector<HalfedgeId, const GlueTab*> grown = tabs_by_side(net.mesh(), shapes.tabs);
  for (const OutlineLoop& loop : outline_loops(net)) {
    std::vector<glm::dvec2> outline;
    for (const HalfedgeId h : loop.sides) {
      outline.push_back(net.corner(h) * scale);
      if (grown[h] != nullptr) add_rim(*grown[h], outline);
    }
    PieceShape& piece = shapes.pieces[static_cast<std::size_t>(loop.piece)];
    piece.area_mm2 += area_of(outline);
    shapes.area_mm2 += area_of(outline);
    piece.hull.insert(piece.hull.end(), outline.begin(), outline.end());
    piece.outlines.push_back(std::move(outline));
  }
  for (PieceShape& piece : shapes.pieces) piece.hull = convex_hull(std::move(piece.hull));
  add_marks(net, shapes);
  return shapes;
}

std::vector<Segment> sides_of(const std::vector<std::vector<glm::dvec2>>& outlines) {
  std::vector<Segment> sides;
  for (const std::vector<glm::dvec2>& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i)
      sides.emplace_back(outline[i], outline[(i + 1) % outline.size()]);
  return sides;
}

}  // namespace netwright
