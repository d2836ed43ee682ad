// Each pass works on the faces of one stage and knows nothing of the stages before, so that merging a merged
// mesh finds nothing to do.
#include "core/mesh/merge_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <utility>

#include "core/base/polygon2.h"
#include "core/mesh/convex_cuts.h"
#include "core/mesh/flat_regions.h"
#include "core/mesh/straight_sides.h"

namespace netwright {

namespace {

/// How often the tolerance is halved before an uneven group is cut in two instead.
constexpr int kMostHalvings = 10;

using FaceList = std::vector<FaceId>;
using Sides = std::set<std::pair<VertexId, VertexId>>;

std::vector<glm::dvec3> corners_of(const Mesh& mesh, std::span<const HalfedgeId> loop) {
  std::vector<glm::dvec3> corners;
  for (const HalfedgeId h : loop) corners.push_back(mesh.position(h));
  return corners;
}

std::vector<HalfedgeId> loop_of(const Mesh& mesh, FaceId f) {
  std::vector<HalfedgeId> loop;
  for (const HalfedgeId h : mesh.halfedges(f)) loop.push_back(h);
  return loop;
}

/// The polygons that a mesh's faces become in one pass.
class Joiner {
 public:
  Joiner(const MergeStage& stage, JoinRule rule)
      : stage_(stage), mesh_(*stage.mesh), rule_(rule), regions_(mesh_), merger_(mesh_) {}

  void join(std::span<const FaceId> faces, double tolerance_rad, int halvings = 0) {
    for (const FaceList& region : regions_.grow(faces, tolerance_rad)) {
      std::vector<MergedPiece> parts = merger_.merge(region, JoinRule::Simple);
      if (parts.size() > 1) {
        if (halvings == 0) ++n_split_regions;
        if (join_openly(region, tolerance_rad, halvings)) continue;
      }
      settle(std::move(parts), tolerance_rad, halvings);
    }
  }

  void keep(FaceId f) { pieces.push_back(merger_.merge(std::span(&f, 1), JoinRule::Simple).front()); }

  std::vector<MergedPiece> pieces;
  int n_split_regions = 0;

 private:
  /// Nothing left that open_regions could cut?
  [[nodiscard]] bool is_done(const FaceList& region) const {
    return std::all_of(region.begin(), region.end(), [&](FaceId f) {
      return stage_.sources[f.index()].size() == 1 ||
             is_open(laid_flat(corners_of(mesh_, loop_of(mesh_, f))));
    });
  }

  /// Joins a region with holes by the convex rule. By the simple rule only where that changes nothing, since
  /// the region was opened before; false when it is to be joined simply.
  bool join_openly(const FaceList& region, double tolerance_rad, int halvings) {
    if (rule_ == JoinRule::Simple && !is_done(region)) return false;
    const std::size_t before = pieces.size();
    settle(merger_.merge(region, JoinRule::Convex), tolerance_rad, halvings);
    if (rule_ == JoinRule::Convex || pieces.size() - before == region.size()) return true;
    pieces.resize(before);
    return false;
  }

  void settle(std::vector<MergedPiece> parts, double tolerance_rad, int halvings) {
    for (MergedPiece& part : parts) settle(std::move(part), tolerance_rad, halvings);
  }

  /// Takes a polygon that paper can follow; else tries its faces again, with half the tolerance while it is
  /// not flat and as two halves where that does not help.
  void settle(MergedPiece piece, double tolerance_rad, int halvings) {
    const PolygonKind kind = piece.sources.size() == 1
                                 ? PolygonKind::Paper
                                 : kind_of(corners_of(mesh_, piece.loop), mesh_.mean_edge());
    if (kind == PolygonKind::Paper) {
      pieces.push_back(std::move(piece));
    } else if (kind == PolygonKind::Uneven && halvings < kMostHalvings) {
      join(piece.sources, tolerance_rad / 2, halvings + 1);
    } else {
      const auto [low, high] = halves(std::move(piece.sources));
      join(low, tolerance_rad, std::max(halvings, 1));
      join(high, tolerance_rad, std::max(halvings, 1));
    }
  }

  /// The faces on both sides of the middle of their longest extent.
  [[nodiscard]] std::pair<FaceList, FaceList> halves(FaceList faces) const {
    Box3 box;
    for (const FaceId f : faces) box.add(mesh_.centre(f));
    const glm::dvec3 size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    std::sort(faces.begin(), faces.end(), [&](FaceId a, FaceId b) {
      const double x = mesh_.centre(a)[axis];
      const double y = mesh_.centre(b)[axis];
      return x != y ? x < y : a < b;
    });
    const auto middle = faces.begin() + static_cast<std::ptrdiff_t>(faces.size() / 2);
    return {{faces.begin(), middle}, {middle, faces.end()}};
  }

  const MergeStage& stage_;
  const Mesh& mesh_;
  JoinRule rule_;
  FlatRegions regions_;
  PieceMerger merger_;
};

FaceList free_faces(const MergeStage& stage) {
  FaceList free;
  for (const FaceId f : stage.mesh->faces()) {
    if (!stage.is_left_alone[f.index()]) free.push_back(f);
  }
  return free;
}

/// Cuts single faces of a stage and remembers which sides there are, so that no diagonal makes one anew.
class Opener {
 public:
  explicit Opener(const MergeStage& stage) : stage_(stage), mesh_(*stage.mesh) {
    for (const HalfedgeId h : mesh_.halfedges()) sides_.insert(side_of(h, mesh_.next(h)));
  }

  std::vector<Outline> open(FaceId f) {
    const std::vector<HalfedgeId> loop = loop_of(mesh_, f);
    const FaceList& sources = stage_.sources[f.index()];
    std::vector<Outline> uncut{{loop, sources, stage_.is_left_alone[f.index()]}};
    if (sources.size() == 1) return uncut;
    const std::vector<glm::dvec3> corners = corners_of(mesh_, loop);
    const std::vector<glm::dvec2> flat = laid_flat(corners);
    if (is_open(flat) || !is_simple(flat)) return uncut;
    std::vector<Outline> parts;
    for (const std::vector<int>& ring : convex_cuts(flat)) {
      Outline& part = parts.emplace_back();
      for (const int i : ring) part.corners.push_back(loop[static_cast<std::size_t>(i)]);
      if (kind_of(corners_of(mesh_, part.corners), mesh_.mean_edge()) != PolygonKind::Paper) return uncut;
    }
    if (parts.size() > sources.size() || !take_sides(parts)) return uncut;
    share_out(sources, parts);
    return parts;
  }

 private:
  [[nodiscard]] std::pair<VertexId, VertexId> side_of(HalfedgeId a, HalfedgeId b) const {
    return std::minmax(mesh_.from(a), mesh_.from(b));
  }

  /// Each diagonal belongs to two parts and joins corners that no side joins yet.
  bool take_sides(const std::vector<Outline>& parts) {
    Sides fresh;
    for (const Outline& part : parts) {
      const std::size_t n = part.corners.size();
      for (std::size_t i = 0; i < n; ++i) {
        const HalfedgeId here = part.corners[i];
        const HalfedgeId there = part.corners[(i + 1) % n];
        if (there == mesh_.next(here)) continue;
        if (sides_.contains(side_of(here, there))) return false;
        fresh.insert(side_of(here, there));
      }
    }
    sides_.merge(fresh);
    return true;
  }

  /// Gives every source to the part nearest to it, but first one to each.
  void share_out(FaceList sources, std::vector<Outline>& parts) const {
    const auto distance = [&](FaceId source, const Outline& part) {
      glm::dvec3 middle(0);
      for (const HalfedgeId h : part.corners)
        middle += mesh_.position(h) / static_cast<double>(part.corners.size());
      return glm::distance(stage_.given->centre(source), middle);
    };
    for (Outline& part : parts) {
      const auto nearest = std::min_element(sources.begin(), sources.end(), [&](FaceId a, FaceId b) {
        return distance(a, part) < distance(b, part);
      });
      part.sources.push_back(*nearest);
      sources.erase(nearest);
    }
    for (const FaceId source : sources) {
      const auto nearest = std::min_element(
          parts.begin(), parts.end(),
          [&](const Outline& a, const Outline& b) { return distance(source, a) < distance(source, b); });
      nearest->sources.push_back(source);
    }
    for (Outline& part : parts) std::sort(part.sources.begin(), part.sources.end());
  }

  const MergeStage& stage_;
  const Mesh& mesh_;
  Sides sides_;
};

}  // namespace

MergeStage join_faces(const MergeStage& from, double tolerance_rad, JoinRule rule) {
  const Mesh& mesh = *from.mesh;
  Joiner joiner(from, rule);
  for (const FaceId f : mesh.faces()) {
    if (from.is_left_alone[f.index()]) joiner.keep(f);
  }
  joiner.join(free_faces(from), tolerance_rad);
  std::vector<bool> is_group;
  std::vector<bool> is_left_alone;
  for (const MergedPiece& piece : joiner.pieces) {
    const std::size_t first = piece.sources.front().index();
    is_group.push_back(piece.sources.size() > 1 || from.sources[first].size() > 1);
    is_left_alone.push_back(from.is_left_alone[first]);
  }
  const IdVector<VertexId, char> is_dropped =
      StraightSides(mesh, joiner.pieces, is_group, is_left_alone, tolerance_rad).find();
  std::vector<Outline> outlines;
  for (std::size_t p = 0; p < joiner.pieces.size(); ++p) {
    Outline& outline = outlines.emplace_back();
    outline.is_left_alone = is_left_alone[p];
    for (const HalfedgeId h : joiner.pieces[p].loop) {
      if (is_dropped[mesh.from(h)] == 0) outline.corners.push_back(h);
    }
    for (const FaceId f : joiner.pieces[p].sources) {
      const FaceList& old = from.sources[f.index()];
      outline.sources.insert(outline.sources.end(), old.begin(), old.end());
    }
    std::sort(outline.sources.begin(), outline.sources.end());
  }
  MergeStage to = stage_of(from, std::move(outlines));
  to.n_split_regions = joiner.n_split_regions;
  return to;
}

MergeStage open_regions(const MergeStage& from, double tolerance_rad) {
  const Mesh& mesh = *from.mesh;
  std::vector<bool> is_cut(mesh.n_faces(), false);
  PieceMerger merger(mesh);
  for (const FaceList& region : FlatRegions(mesh).grow(free_faces(from), tolerance_rad)) {
    if (merger.merge(region, JoinRule::Simple).size() == 1) continue;
    for (const FaceId f : region) is_cut[f.index()] = true;
  }
  Opener opener(from);
  std::vector<Outline> outlines;
  for (const FaceId f : mesh.faces()) {
    if (is_cut[f.index()]) {
      for (Outline& part : opener.open(f)) outlines.push_back(std::move(part));
    } else {
      outlines.push_back({loop_of(mesh, f), from.sources[f.index()], from.is_left_alone[f.index()]});
    }
  }
  MergeStage to = stage_of(from, std::move(outlines));
  to.n_split_regions = from.n_split_regions;
  return to;
}

}  // namespace netwright
