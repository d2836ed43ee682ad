// Regions are the surroundings of points whose neighbours have more than a full turn of paper around them, as
// the foot of a spike has. The search chooses for region after region how its doors are joined, next to those
// chosen already, until faces come apart; it jumps back over choices that did not matter.
#include "core/solve/prove_regions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/solve/disjoint_sets.h"
#include "core/solve/proof_writer.h"
#include "core/solve/reason.h"

namespace netwright {
namespace {

using Region = ImpossibilityProof::Region;
using Step = ImpossibilityProof::Step;

constexpr std::size_t kMostFaces = 18;             ///< of a region
constexpr std::int64_t kRegionSteps = 15'000;      ///< to try one region's forests
constexpr std::int64_t kAllRegionSteps = 500'000;  ///< for all of them together

/// Paper around each point: the angles of its faces there, radians.
IdVector<VertexId, double> turns(const DualGraph& dual) {
  const Mesh& mesh = dual.mesh();
  IdVector<VertexId, double> turn(mesh.n_vertices(), 0);
  for (const HalfedgeId h : mesh.halfedges()) {
    const glm::dvec2 out = dual.flat(mesh.next(h)) - dual.flat(h);
    const glm::dvec2 in = dual.flat(mesh.prev(h)) - dual.flat(h);
    const double angle = std::atan2(cross(out, in), glm::dot(out, in));
    turn[mesh.from(h)] += angle < 0 ? angle + 2 * std::numbers::pi : angle;
  }
  return turn;
}

std::vector<FaceId> sorted(std::vector<FaceId> faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

/// Around every point: its faces, and those around its neighbours with more than a full turn.
std::vector<std::vector<FaceId>> candidates(const DualGraph& dual) {
  const Mesh& mesh = dual.mesh();
  const IdVector<VertexId, double> turn = turns(dual);
  IdVector<VertexId, std::vector<FaceId>> around(mesh.n_vertices());
  for (const HalfedgeId h : mesh.halfedges()) around[mesh.from(h)].push_back(mesh.face(h));
  std::vector<std::vector<FaceId>> found;
  for (const VertexId v : mesh.vertices()) {
    std::vector<FaceId> faces = around[v];
    bool has_foot = false;
    for (const FaceId f : around[v])
      for (const HalfedgeId h : mesh.halfedges(f)) {
        const VertexId w = mesh.from(h);
        if (w == v || turn[w] <= 2 * std::numbers::pi) continue;
        has_foot = true;
        faces.insert(faces.end(), around[w].begin(), around[w].end());
      }
    faces = sorted(std::move(faces));
    if (has_foot && faces.size() <= kMostFaces && faces.size() < mesh.n_faces()) found.push_back(faces);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

int n_groups(const std::vector<int>& joins) {
  std::vector<int> groups = joins;
  std::sort(groups.begin(), groups.end());
  return static_cast<int>(std::unique(groups.begin(), groups.end()) - groups.begin());
}

/// How many more parts a net must have here than where nothing is in the way.
int forced_parts(const Region& region) {
  int fewest = static_cast<int>(region.faces.size()) + 1;
  for (const std::vector<int>& joins : region.joins) fewest = std::min(fewest, n_groups(joins));
  return fewest - 1;
}

class Search {
 public:
  Search(const Mesh& mesh, std::vector<Region> regions, std::int64_t max_steps, const Progress& progress)
      : mesh_(mesh),
        regions_(std::move(regions)),
        region_of_(mesh.n_faces(), -1),
        is_door_(mesh.n_faces(), 1),
        chosen_(regions_.size(), kOpen),
        meets_(regions_.size(), std::vector<char>(regions_.size(), 0)),
        steps_(max_steps),
        progress_(progress) {
    for (std::size_t r = 0; r < regions_.size(); ++r)
      for (const FaceId f : regions_[r].faces) region_of_[f] = static_cast<int>(r);
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      doors_.emplace_back();
      for (const FaceId f : regions_[r].faces) note_door(r, f);
    }
    note_meetings();
  }

  std::optional<ImpossibilityProof> run() {
    Reason reason(regions_.size());
    if (!refute(reason)) return std::nullopt;
    return ImpossibilityProof{regions_, writer_.nodes()};
  }

 private:
  void note_door(std::size_t r, FaceId f) {
    is_door_[f] = 0;
    for (const HalfedgeId h : mesh_.halfedges(f)) {
      const FaceId g = mesh_.neighbour(h);
      if (g.is_valid() && region_of_[g] != static_cast<int>(r)) is_door_[f] = 1;
    }
    if (is_door_[f] != 0) doors_[r].push_back(f);
  }

  /// Regions meet where they share a point of the model.
  void note_meetings() {
    IdVector<VertexId, std::vector<int>> around(mesh_.n_vertices());
    for (const HalfedgeId h : mesh_.halfedges())
      if (const int r = region_of_[mesh_.face(h)]; r >= 0) around[mesh_.from(h)].push_back(r);
    for (const VertexId v : mesh_.vertices())
      for (const int r : around[v])
        for (const int s : around[v]) meets_[static_cast<std::size_t>(r)][static_cast<std::size_t>(s)] = 1;
  }

  bool refute(Reason& reason) {
    if (--steps_ < 0 || progress_.is_cancelled()) return false;
    if (is_apart(reason)) {
      writer_.add(Step::Topology);
      return true;
    }
    const std::size_t r = next_region();
    if (r == regions_.size()) return false;  // the regions allow a net
    const std::size_t begin = writer_.size();
    writer_.add(Step::Region, static_cast<std::int32_t>(r));
    Reason all(regions_.size());
    for (std::size_t k = 0; k < regions_[r].joins.size(); ++k) {
      chosen_[r] = static_cast<int>(k);
      const std::size_t middle = writer_.size();
      Reason one(regions_.size());
      const bool is_refuted = refute(one);
      chosen_[r] = kOpen;
      if (!is_refuted) return false;
      if (!one.has(r)) {
        writer_.strike(begin, middle);
        reason = one;
        return true;
      }
      all.add(one);
    }
    all.drop(r);
    reason = all;
    return true;
  }

  /// Have the chosen joins parted a component? Then also: which of them did.
  bool is_apart(Reason& reason) const {
    DisjointSets sets(mesh_.n_faces());
    for (const EdgeId e : mesh_.edges()) {
      const HalfedgeId h = mesh_.halfedge(e);
      if (mesh_.is_border(e)) continue;
      const FaceId f = mesh_.face(h);
      const FaceId g = mesh_.neighbour(h);
      if (region_of_[f] < 0 || region_of_[f] != region_of_[g]) sets.join(f.value, g.value);
    }
    for (std::size_t r = 0; r < regions_.size(); ++r)
      for (std::size_t i = 0; i < doors_[r].size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (chosen_[r] == kOpen || joins(r)[i] == joins(r)[j])
            sets.join(doors_[r][i].value, doors_[r][j].value);
    return find_parting(sets, reason);
  }

  bool find_parting(DisjointSets& sets, Reason& reason) const {
    std::vector<int> home(mesh_.n_components(), -1);
    bool is_parted = false;
    std::size_t fewest = regions_.size() + 1;
    for (const FaceId f : mesh_.faces()) {
      if (is_door_[f] == 0) continue;
      int& first = home[static_cast<std::size_t>(mesh_.component(f))];
      const int set = sets.find(f.value);
      if (first < 0) first = set;
      if (first == set) continue;
      is_parted = true;
      for (const int part : {first, set}) {
        const auto [why, count] = around(sets, part);
        if (count >= fewest) continue;
        fewest = count;
        reason = why;
      }
    }
    return is_parted;
  }

  /// The regions that have doors both in this part and elsewhere.
  std::pair<Reason, std::size_t> around(DisjointSets& sets, int part) const {
    Reason why(regions_.size());
    std::size_t count = 0;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      const auto inside = std::count_if(doors_[r].begin(), doors_[r].end(),
                                        [&](FaceId f) { return sets.find(f.value) == part; });
      if (inside == 0 || inside == static_cast<std::ptrdiff_t>(doors_[r].size())) continue;
      why.add(r);
      ++count;
    }
    return {why, count};
  }

  /// The open region that meets most of the chosen ones; of those, the one with fewest ways.
  [[nodiscard]] std::size_t next_region() const {
    std::size_t best = regions_.size();
    std::pair<int, int> best_rank{};
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (chosen_[r] != kOpen) continue;
      int met = 0;
      for (std::size_t s = 0; s < regions_.size(); ++s)
        met += chosen_[s] != kOpen && meets_[r][s] != 0 ? 1 : 0;
      const std::pair<int, int> rank{met, -static_cast<int>(regions_[r].joins.size())};
      if (regions_[r].joins.empty()) return r;
      if (best < regions_.size() && rank <= best_rank) continue;
      best = r;
      best_rank = rank;
    }
    return best;
  }

  [[nodiscard]] const std::vector<int>& joins(std::size_t r) const {
    return regions_[r].joins[static_cast<std::size_t>(chosen_[r])];
  }

  static constexpr int kOpen = -1;

  const Mesh& mesh_;
  std::vector<Region> regions_;
  IdVector<FaceId, int> region_of_;
  IdVector<FaceId, char> is_door_;  ///< faces inside a region are none; those of no region are
  std::vector<std::vector<FaceId>> doors_;
  std::vector<int> chosen_;
  std::vector<std::vector<char>> meets_;
  std::int64_t steps_;
  const Progress& progress_;
  ProofWriter writer_;
};

}  // namespace

std::vector<Region> telling_regions(const DualGraph& dual, const Progress& progress) {
  std::vector<Region> all;
  std::int64_t left = kAllRegionSteps;
  for (std::vector<FaceId>& faces : candidates(dual)) {
    if (progress.is_cancelled()) return {};
    const std::int64_t allowed = std::min(kRegionSteps, left);
    std::int64_t steps = allowed;
    if (auto region = region_joins(dual, std::move(faces), steps); region && forced_parts(*region) > 0)
      all.push_back(std::move(*region));
    left -= allowed - std::max<std::int64_t>(steps, 0);
    if (left <= 0) break;
  }
  std::stable_sort(all.begin(), all.end(), [](const Region& a, const Region& b) {
    const int more = forced_parts(a) - forced_parts(b);
    return more != 0 ? more > 0 : a.faces.size() < b.faces.size();
  });
  std::vector<Region> chosen;
  IdVector<FaceId, char> is_taken(dual.mesh().n_faces(), 0);
  for (Region& region : all) {
    if (std::any_of(region.faces.begin(), region.faces.end(), [&](FaceId f) { return is_taken[f] != 0; }))
      continue;
    for (const FaceId f : region.faces) is_taken[f] = 1;
    chosen.push_back(std::move(region));
  }
  return chosen;
}

int least_pieces(const Mesh& mesh, const std::vector<Region>& telling) {
  IdVector<FaceId, int> region_of(mesh.n_faces(), -1);
  int n_outside = static_cast<int>(mesh.n_faces());
  for (std::size_t r = 0; r < telling.size(); ++r)
    for (const FaceId f : telling[r].faces) {
      region_of[f] = static_cast<int>(r);
      --n_outside;
    }
  // Folds outside the regions close no loop, even where all trees in the regions are taken apart.
  DisjointSets sets(mesh.n_faces());
  int most_folds = 0;
  for (const EdgeId e : mesh.edges()) {
    if (mesh.is_border(e)) continue;
    const FaceId f = mesh.face(mesh.halfedge(e));
    const FaceId g = mesh.neighbour(mesh.halfedge(e));
    if (region_of[f] < 0 || region_of[f] != region_of[g]) most_folds += sets.join(f.value, g.value) ? 1 : 0;
  }
  return std::max(static_cast<int>(mesh.n_components()),
                  2 * static_cast<int>(telling.size()) + n_outside - most_folds);
}

std::optional<ImpossibilityProof> search_regions(const DualGraph& dual, std::int64_t max_steps,
                                                 const Progress& progress) {
  std::vector<Region> regions = telling_regions(dual, progress);
  if (regions.empty()) return std::nullopt;
  return Search(dual.mesh(), std::move(regions), max_steps, progress).run();
}

}  // namespace netwright
