// Turns a Net into plain points and faces, with one point wherever folds hold corners together.
#include "core/unfold/flat_net.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/unfold/settle.h"

namespace netwright {

namespace {

// Below this bend (0.1 degree) "mountain" or "valley" would only state the model's rounding.
constexpr double kCertainBend = 0.0017453292519943296;

// Corners that a chain of folds holds together share one point: union by folds, the smallest corner leads.
class CornerClasses {
 public:
  explicit CornerClasses(const Net& net) : leader_(net.mesh().n_halfedges()) {
    const Mesh& mesh = net.mesh();
    std::iota(leader_.begin(), leader_.end(), 0);
    for (const EdgeId e : mesh.edges()) {
      if (!net.tree.is_fold(mesh, e)) continue;
      const HalfedgeId h = mesh.halfedge(e);
      const HalfedgeId t = mesh.twin(h);
      join(h, mesh.next(t));
      join(mesh.next(h), t);
    }
  }
  int find(HalfedgeId h) {
    int i = h.value;
    while (leader_[static_cast<std::size_t>(i)] != i) {
      int& up = leader_[static_cast<std::size_t>(i)];
      up = leader_[static_cast<std::size_t>(up)];
      i = up;
    }
    return i;
  }

 private:
  void join(HalfedgeId a, HalfedgeId b) {
    const int x = find(a);
    const int y = find(b);
    leader_[static_cast<std::size_t>(std::max(x, y))] = std::min(x, y);
  }
  std::vector<int> leader_;
};

// Repair may split a face of the file or fill a hole; then the net's faces are counted as the mesh has them.
bool are_distinct(std::vector<int> sources) {
  std::sort(sources.begin(), sources.end());
  return (sources.empty() || sources.front() >= 0) &&
         std::adjacent_find(sources.begin(), sources.end()) == sources.end();
}

Assignment assignment(double bend) {
  if (std::abs(bend) < kCertainBend) return Assignment::Flat;
  return bend > 0 ? Assignment::Mountain : Assignment::Valley;
}

void add_edges(const Net& net, const IdVector<HalfedgeId, int>& point, FlatNet& flat) {
  const Mesh& mesh = net.mesh();
  for (const HalfedgeId h : mesh.halfedges()) {
    const bool is_fold = net.tree.is_fold(mesh, mesh.edge(h));
    if (is_fold && mesh.halfedge(mesh.edge(h)) != h) continue;
    FlatNet::Edge edge{point[h], point[mesh.next(h)], Assignment::Boundary, 0};
    if (is_fold) {
      const double bend = net.dual->bend(mesh.edge(h));
      edge.assignment = assignment(bend);
      edge.fold_angle_rad = -bend;
    }
    flat.edges.push_back(edge);
  }
}

}  // namespace

FlatNet to_flat_net(const Net& net, double scale) {
  const Mesh& mesh = net.mesh();
  FlatNet flat;
  flat.title = mesh.name();
  CornerClasses classes(net);
  std::vector<int> point_of(mesh.n_halfedges(), -1);
  IdVector<HalfedgeId, int> point(mesh.n_halfedges(), -1);
  // Parents first: the corners of a fold are where the parent has them, as the layout had it.
  for (const FaceId f : net.tree.preorder(mesh))
    for (const HalfedgeId h : mesh.halfedges(f)) {
      int& p = point_of[static_cast<std::size_t>(classes.find(h))];
      if (p < 0) {
        p = static_cast<int>(flat.points.size());
        flat.points.push_back(net.corner(h) * scale);
        flat.folded.push_back(mesh.position(h));
      }
      point[h] = p;
    }
  // Where the whole file runs inwards the net is written as the file has it; single turned faces are not.
  const auto range = mesh.faces();
  bool all_flipped = true;
  for (const FaceId f : range) all_flipped = all_flipped && mesh.is_flipped(f);
  for (const FaceId f : range) {
    std::vector<int> face;
    for (const HalfedgeId h : mesh.halfedges(f)) face.push_back(point[h]);
    if (all_flipped) std::reverse(face.begin(), face.end());
    flat.faces.push_back(std::move(face));
    flat.face_source.push_back(mesh.face_source(f));
  }
  if (!are_distinct(flat.face_source)) std::iota(flat.face_source.begin(), flat.face_source.end(), 0);
  add_edges(net, point, flat);
  settle(flat, mesh.mean_edge() * scale);
  return flat;
}

double mean_edge(const FlatNet& net) {
  double total = 0;
  std::size_t count = 0;
  for (const auto& face : net.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      total += glm::distance(net.points[static_cast<std::size_t>(face[i])],
                             net.points[static_cast<std::size_t>(face[(i + 1) % face.size()])]);
      ++count;
    }
  return count == 0 ? 0 : total / static_cast<double>(count);
}

}  // namespace netwright
