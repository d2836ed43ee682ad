// A walk over the graph of cuts, whose nodes are the model's corners, noting each cut when the walk comes
// back over it.
#include "core/unfold/gluing_order.h"

#include <algorithm>

namespace netwright {

namespace {

class Gluing {
 public:
  explicit Gluing(const Net& net)
      : mesh_(net.mesh()),
        cuts_at_(mesh_.n_vertices(), std::vector<EdgeId>()),
        is_walked_(mesh_.n_edges(), 0),
        room_(mesh_.n_edges(), 0) {
    IdVector<VertexId, double> area(mesh_.n_vertices(), 0);
    for (const HalfedgeId h : mesh_.halfedges()) area[mesh_.from(h)] += mesh_.area(mesh_.face(h));
    for (const EdgeId e : mesh_.edges()) {
      if (mesh_.is_border(e) || net.tree.is_fold(mesh_, e) || net.dual->is_hidden(e)) continue;
      cuts_.push_back(e);
      for (const VertexId v : ends(e)) {
        cuts_at_[v].push_back(e);
        room_[e] += area[v];
      }
    }
  }

  std::vector<EdgeId> order() {
    std::vector<EdgeId> last_first = cuts_;
    std::ranges::stable_sort(last_first, std::greater<>(), [&](EdgeId e) { return room_[e]; });
    for (const EdgeId last : last_first) {
      if (is_walked_[last] != 0) continue;
      is_walked_[last] = 1;
      for (const VertexId v : ends(last)) walk(v);
      order_.push_back(last);
    }
    return order_;
  }

 private:
  [[nodiscard]] std::vector<VertexId> ends(EdgeId e) const {
    const HalfedgeId h = mesh_.halfedge(e);
    return {mesh_.from(h), mesh_.to(h)};
  }

  void walk(VertexId start) {
    struct Step {
      VertexId at;
      EdgeId by;  ///< the cut that led here
    };
    std::vector<Step> path{{start, EdgeId()}};
    while (!path.empty()) {
      const auto [at, by] = path.back();
      const auto next = std::ranges::find_if(cuts_at_[at], [&](EdgeId e) { return is_walked_[e] == 0; });
      if (next == cuts_at_[at].end()) {
        if (by.is_valid()) order_.push_back(by);
        path.pop_back();
        continue;
      }
      is_walked_[*next] = 1;
      const std::vector<VertexId> both = ends(*next);
      path.push_back({both[0] == at ? both[1] : both[0], *next});
    }
  }

  const Mesh& mesh_;
  std::vector<EdgeId> cuts_;
  IdVector<VertexId, std::vector<EdgeId>> cuts_at_;
  IdVector<EdgeId, char> is_walked_;
  IdVector<EdgeId, double> room_;
  std::vector<EdgeId> order_;
};

}  // namespace

std::vector<EdgeId> gluing_order(const Net& net) { return Gluing(net).order(); }

}  // namespace netwright
