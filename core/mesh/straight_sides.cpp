// Splits the outlines into runs between points that three polygons need, and straightens each run as Douglas
// and Peucker do: a point stays where the run leaves the straight line between its ends.
#include "core/mesh/straight_sides.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/base/predicates.h"
#include "core/mesh/flat_regions.h"

namespace netwright {

namespace {

std::pair<VertexId, VertexId> side_between(VertexId a, VertexId b) { return std::minmax(a, b); }

}  // namespace

StraightSides::StraightSides(const Mesh& mesh, std::span<const MergedPiece> pieces,
                             const std::vector<bool>& may_change, const std::vector<bool>& must_stay,
                             double tolerance_rad)
    : mesh_(mesh),
      pieces_(pieces),
      may_change_(may_change),
      must_stay_(must_stay),
      sine_(std::sin(tolerance_rad)),
      rounding_(rounding_of(mesh, tolerance_rad)),
      piece_of_(mesh.n_faces(), -1),
      n_sides_(mesh.n_vertices(), 0) {
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    for (const FaceId f : pieces[p].sources) piece_of_[f] = static_cast<int>(p);
    for (const HalfedgeId h : pieces[p].loop) {
      if (mesh.twin(h).is_valid() && mesh.twin(h) < h) continue;
      ++n_sides_[mesh.from(h)];
      ++n_sides_[mesh.to(h)];
    }
  }
}

IdVector<VertexId, char> StraightSides::find() {
  for (bool is_done = false; !is_done;) {
    is_dropped_.assign(mesh_.n_vertices(), 0);
    is_settled_.assign(mesh_.n_vertices(), 0);
    sides_.clear();
    for (const MergedPiece& piece : pieces_) {
      for (const HalfedgeId h : piece.loop) sides_.insert(side_between(mesh_.from(h), mesh_.to(h)));
    }
    for (std::size_t p = 0; p < pieces_.size(); ++p) look_along(p);
    is_done = true;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (!is_spoiled(p)) continue;
      must_stay_[p] = true;
      is_done = false;
    }
  }
  return is_dropped_;
}

/// Cuts the piece's outline at the points that stay whatever happens and straightens what lies between.
void StraightSides::look_along(std::size_t piece) {
  const std::vector<HalfedgeId>& loop = pieces_[piece].loop;
  const auto is_node = [&](HalfedgeId h) { return n_sides_[mesh_.from(h)] != 2; };
  auto start = std::find_if(loop.begin(), loop.end(), is_node);
  if (start == loop.end()) start = loop.begin() + static_cast<std::ptrdiff_t>(sharpest(loop));
  std::vector<HalfedgeId> around(start, loop.end());
  around.insert(around.end(), loop.begin(), start);
  for (std::size_t i = 0; i < around.size();) {
    std::size_t j = i + 1;
    while (j < around.size() && !is_node(around[j])) ++j;
    const std::span run(around.begin() + static_cast<std::ptrdiff_t>(i), j - i);
    // The other side of the run may have been here before.
    if (run.size() > 1 && may_touch(run[0]) && is_settled_[mesh_.from(run[1])] == 0) straighten(run);
    i = j;
  }
}

std::size_t StraightSides::sharpest(std::span<const HalfedgeId> loop) const {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const HalfedgeId before = loop[(i + loop.size() - 1) % loop.size()];
    const glm::dvec3 here = mesh_.position(loop[i]);
    const glm::dvec3 in = glm::normalize(here - mesh_.position(before));
    const glm::dvec3 out = glm::normalize(mesh_.position(mesh_.to(loop[i])) - here);
    if (glm::dot(in, out) < least) {
      least = glm::dot(in, out);
      best = i;
    }
  }
  return best;
}

void StraightSides::straighten(std::span<const HalfedgeId> run) {
  if (run.size() < 2) return;
  for (std::size_t i = 1; i < run.size(); ++i) is_settled_[mesh_.from(run[i])] = 1;
  const auto ends = side_between(mesh_.from(run.front()), mesh_.to(run.back()));
  std::size_t keep = worst_bend(run);
  if (keep == 0 && sides_.contains(ends)) keep = run.size() / 2;
  if (keep == 0) {
    sides_.insert(ends);
    for (std::size_t i = 1; i < run.size(); ++i) is_dropped_[mesh_.from(run[i])] = 1;
    return;
  }
  straighten(run.first(keep));
  straighten(run.subspan(keep));
}

/// The point of the run that must stay most of all; 0 when all may go.
std::size_t StraightSides::worst_bend(std::span<const HalfedgeId> run) const {
  const auto worst_by = [&](const auto& off_at) {
    std::size_t worst = 0;
    double most = 0;
    for (std::size_t i = 1; i < run.size(); ++i) {
      const double off = off_at(i);
      if (off > most) {
        most = off;
        worst = i;
      }
    }
    return worst;
  };
  const std::size_t bent = worst_by([&](std::size_t i) { return bend(run, run[i]); });
  if (bent > 0 || !mesh_.has_uv()) return bent;
  return worst_by([&](std::size_t i) { return texture_shift(run, i); });
}

/// How far a point is off the line between the ends of its run; 0 when it is as good as on it, in between.
double StraightSides::bend(std::span<const HalfedgeId> run, HalfedgeId at) const {
  const glm::dvec3 begin = mesh_.position(run.front());
  const glm::dvec3 end = mesh_.position(mesh_.to(run.back()));
  const glm::dvec3 point = mesh_.position(at);
  const double length = glm::length(end - begin);
  const double to_begin = glm::length(point - begin);
  const double to_end = glm::length(end - point);
  if (length <= rounding_) return std::min(to_begin, to_end);
  const glm::dvec3 along = (end - begin) / length;
  const double place = glm::dot(point - begin, along);
  const double off = glm::length(point - begin - place * along);
  const bool is_on = off <= std::max(rounding_, sine_ * std::min(to_begin, to_end));
  return is_on && place > 0 && place < length ? 0 : std::max(off, std::abs(place - length / 2) - length / 2);
}

/// How far a texture would move at a point of a straight run, on either side, if the point went; 0 when by
/// less than can be seen.
double StraightSides::texture_shift(std::span<const HalfedgeId> run, std::size_t at) const {
  const glm::dvec3 begin = mesh_.position(run.front());
  const double length = glm::length(mesh_.position(mesh_.to(run.back())) - begin);
  const double share = glm::length(mesh_.position(run[at]) - begin) / length;
  const auto shift = [&](HalfedgeId from, HalfedgeId middle, HalfedgeId to) {
    return glm::length(mesh_.uv(middle) - mesh_.uv(from) - share * (mesh_.uv(to) - mesh_.uv(from)));
  };
  double most = shift(run.front(), run[at], mesh_.next(run.back()));
  if (mesh_.twin(run.front()).is_valid()) {
    const HalfedgeId from = mesh_.next(mesh_.twin(run.front()));
    most = std::max(most, shift(from, mesh_.twin(run[at - 1]), mesh_.twin(run.back())));
  }
  return most > kSameUv ? most : 0;
}

bool StraightSides::may_touch(HalfedgeId h) const {
  const auto here = static_cast<std::size_t>(piece_of_[mesh_.face(h)]);
  if (must_stay_[here]) return false;
  if (!mesh_.twin(h).is_valid()) return may_change_[here];
  const auto there = static_cast<std::size_t>(piece_of_[mesh_.neighbour(h)]);
  return !must_stay_[there] && (may_change_[here] || may_change_[there]);
}

bool StraightSides::is_spoiled(std::size_t piece) const {
  std::vector<glm::dvec3> corners;
  for (const HalfedgeId h : pieces_[piece].loop) {
    if (is_dropped_[mesh_.from(h)] == 0) corners.push_back(mesh_.position(h));
  }
  return corners.size() < pieces_[piece].loop.size() &&
         kind_of(corners, mesh_.mean_edge()) != PolygonKind::Paper;
}

}  // namespace netwright
