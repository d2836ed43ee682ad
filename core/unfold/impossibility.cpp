// Walks through the cases of a proof and asks of each end whether what it claims is so.
#include "core/unfold/impossibility.h"

#include <numeric>

#include "core/unfold/certain_overlap.h"
#include "core/unfold/impossibility_region.h"

namespace netwright {
namespace {

constexpr std::int64_t kMostSteps = 50'000'000;  ///< forests tried and faces looked at: some minutes at most

using Node = ImpossibilityProof::Node;
using Step = ImpossibilityProof::Step;

class Checker {
 public:
  Checker(const Mesh& mesh, const ImpossibilityProof& proof)
      : mesh_(mesh),
        proof_(proof),
        rolled_(mesh),
        state_(mesh.n_edges(), kOpen),
        region_of_(mesh.n_faces(), -1) {}

  std::string fault() {
    if (std::string wrong = check_regions(); !wrong.empty()) return wrong;
    for (std::size_t i = 0; i < proof_.nodes.size(); ++i) {
      if (std::string wrong = visit(proof_.nodes[i]); !wrong.empty()) return wrong;
      if (open_.empty()) return i + 1 == proof_.nodes.size() ? "" : "The proof goes on after its last case.";
    }
    return "A case of the proof is missing.";
  }

 private:
  /// A step whose cases are being gone through.
  struct Branch {
    Step step;
    std::int32_t subject;
    int now;
    int n_cases;
  };

  std::string check_regions() {
    for (std::size_t r = 0; r < proof_.regions.size(); ++r) {
      if (std::string wrong = proof::region_fault(rolled_, proof_.regions[r], steps_); !wrong.empty())
        return wrong;
      for (const FaceId f : proof_.regions[r].faces) {
        if (region_of_[f] >= 0) return "A face is in two regions of the proof.";
        region_of_[f] = static_cast<int>(r);
      }
      doors_.push_back(proof::region_doors(mesh_, proof_.regions[r].faces));
    }
    chosen_.assign(proof_.regions.size(), kOpen);
    return "";
  }

  std::string visit(const Node& node) {
    switch (node.step) {
      case Step::Hinge:
        return open_hinge(node.a);
      case Step::Region:
        return open_region(node.a);
      case Step::Overlap:
        if (!is_overlap(node.a, node.b)) return "Two faces do not overlap where the proof says so.";
        break;
      case Step::Topology:
        if (!is_loop_or_apart()) return "A case of the proof ends without a reason.";
        break;
      default:
        return "The proof has a step of an unknown kind.";
    }
    next_case();
    return steps_ < 0 ? "The proof takes too long to check." : "";
  }

  std::string open_hinge(std::int32_t edge) {
    if (edge < 0 || static_cast<std::size_t>(edge) >= mesh_.n_edges() || mesh_.is_border(EdgeId(edge)) ||
        state_[EdgeId(edge)] != kOpen)
      return "The proof decides a hinge that is not there or decided already.";
    const HalfedgeId h = mesh_.halfedge(EdgeId(edge));
    const int region = region_of_[mesh_.face(h)];
    if (region >= 0 && region == region_of_[mesh_.neighbour(h)])
      return "The proof decides a hinge inside a region.";
    open_.push_back({Step::Hinge, edge, 0, 2});
    take_case();
    return "";
  }

  std::string open_region(std::int32_t region) {
    if (region < 0 || static_cast<std::size_t>(region) >= chosen_.size() ||
        chosen_[static_cast<std::size_t>(region)] != kOpen)
      return "The proof decides a region that is not there or decided already.";
    const auto r = static_cast<std::size_t>(region);
    open_.push_back({Step::Region, region, 0, static_cast<int>(proof_.regions[r].joins.size())});
    if (proof_.regions[r].joins.empty()) {
      next_case();
    } else {
      take_case();
    }
    return "";
  }

  void take_case() {
    const Branch& branch = open_.back();
    const bool is_over = branch.now >= branch.n_cases;
    if (branch.step == Step::Hinge) {
      state_[EdgeId(branch.subject)] = is_over ? kOpen : branch.now;
    } else {
      chosen_[static_cast<std::size_t>(branch.subject)] = is_over ? kOpen : branch.now;
    }
  }

  /// A case has ended: on to the next one of the innermost step that has one.
  void next_case() {
    while (!open_.empty()) {
      ++open_.back().now;
      take_case();
      if (open_.back().now < open_.back().n_cases) return;
      open_.pop_back();
    }
  }

  /// Rolls out what folds join to face a, until b is reached.
  bool is_overlap(std::int32_t a, std::int32_t b) {
    const auto n = static_cast<std::int32_t>(mesh_.n_faces());
    if (a < 0 || b < 0 || a >= n || b >= n || a == b) return false;
    std::vector<std::pair<FaceId, proof::Laid>> reached{{FaceId(a), {}}};
    std::vector<HalfedgeId> came_over{HalfedgeId()};
    for (std::size_t i = 0; i < reached.size() && reached.size() <= mesh_.n_faces(); ++i) {
      const auto [f, laid] = reached[i];
      if (f == FaceId(b)) return rolled_.overlap(FaceId(a), {}, f, laid);
      for (const HalfedgeId h : mesh_.halfedges(f)) {
        if (state_[mesh_.edge(h)] != kFold || h == came_over[i]) continue;
        reached.emplace_back(mesh_.neighbour(h), rolled_.across(laid, h));
        came_over.push_back(mesh_.twin(h));
        --steps_;
      }
    }
    return false;
  }

  bool is_loop_or_apart() {
    steps_ -= static_cast<std::int64_t>(mesh_.n_edges());
    std::vector<int> by_folds(mesh_.n_faces());
    std::iota(by_folds.begin(), by_folds.end(), 0);
    std::vector<int> by_chance = by_folds;  // all that is not cut
    for (const EdgeId e : mesh_.edges()) {
      const HalfedgeId h = mesh_.halfedge(e);
      if (mesh_.is_border(e) ||
          (region_of_[mesh_.face(h)] >= 0 && region_of_[mesh_.face(h)] == region_of_[mesh_.neighbour(h)]))
        continue;
      const int f = mesh_.face(h).value;
      const int g = mesh_.neighbour(h).value;
      if (state_[e] == kFold && !join(by_folds, f, g)) return true;
      if (state_[e] != kCut) join(by_chance, f, g);
    }
    for (std::size_t r = 0; r < proof_.regions.size(); ++r) join_doors(r, by_chance);
    return is_apart(by_chance);
  }

  /// Doors may be joined inside the region: as the case at hand says, or any with any while it is open.
  void join_doors(std::size_t r, std::vector<int>& by_chance) const {
    for (std::size_t i = 0; i < doors_[r].size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const bool may_join = chosen_[r] == kOpen || joins_of(r)[i] == joins_of(r)[j];
        if (may_join) join(by_chance, doors_[r][i].value, doors_[r][j].value);
      }
  }

  [[nodiscard]] const std::vector<int>& joins_of(std::size_t r) const {
    return proof_.regions[r].joins[static_cast<std::size_t>(chosen_[r])];
  }

  /// Faces inside a region are joined to some door of it, so they need not be asked.
  bool is_apart(std::vector<int>& by_chance) const {
    std::vector<int> home(mesh_.n_components(), -1);
    for (const FaceId f : mesh_.faces()) {
      if (region_of_[f] >= 0 && !is_door(f)) continue;
      int& first = home[static_cast<std::size_t>(mesh_.component(f))];
      const int root = find(by_chance, f.value);
      if (first >= 0 && first != root) return true;
      first = root;
    }
    return false;
  }

  [[nodiscard]] bool is_door(FaceId f) const {
    const std::vector<FaceId>& doors = doors_[static_cast<std::size_t>(region_of_[f])];
    for (const FaceId door : doors)
      if (door == f) return true;
    return false;
  }

  static int find(std::vector<int>& parent, int i) {
    while (parent[static_cast<std::size_t>(i)] != i) {
      int& up = parent[static_cast<std::size_t>(i)];
      up = parent[static_cast<std::size_t>(up)];
      i = up;
    }
    return i;
  }
  static bool join(std::vector<int>& parent, int a, int b) {
    a = find(parent, a);
    b = find(parent, b);
    parent[static_cast<std::size_t>(a)] = b;
    return a != b;
  }

  static constexpr int kOpen = -1;
  static constexpr int kFold = 0;
  static constexpr int kCut = 1;

  const Mesh& mesh_;
  const ImpossibilityProof& proof_;
  proof::RolledFaces rolled_;
  IdVector<EdgeId, int> state_;
  IdVector<FaceId, int> region_of_;
  std::vector<std::vector<FaceId>> doors_;  ///< per region
  std::vector<int> chosen_;                 ///< per region: which of its joins
  std::vector<Branch> open_;
  std::int64_t steps_ = kMostSteps;
};

}  // namespace

ImpossibilityVerdict verify_impossible(const Mesh& mesh, const ImpossibilityProof& proof) {
  std::string fault = Checker(mesh, proof).fault();
  return {fault.empty(), fault};
}

}  // namespace netwright
