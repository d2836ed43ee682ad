// Puts models together from the history of collapses. One pass over the points finds what each has become,
// one over the triangles writes those that live.
#include "core/mesh/simplify.h"

#include <algorithm>
#include <functional>
#include <span>

#include "core/mesh/deviation.h"
#include "core/mesh/simplify_collapse.h"

namespace netwright {
namespace {

/// For each node of a forest that exists among the first n: the last one it has become by then. Children come
/// before their parents.
std::vector<int> representatives(const std::vector<int>& parent, int n) {
  std::vector<int> result(static_cast<std::size_t>(n));
  for (int i = n - 1; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    const int p = parent[k];
    result[k] = p >= 0 && p < n ? result[static_cast<std::size_t>(p)] : i;
  }
  return result;
}

/// Walks over the faces of one state: whole polygons first come where their first triangle stands.
class StateWalk {
 public:
  StateWalk(const CollapseHistory& history, int step) : history_(history), step_(step) {}

  /// Calls polygon(mesh face) and triangle(t) in the order of the state's faces.
  template <class Polygon, class Single>
  void run(Polygon&& polygon, Single&& triangle) const {
    int whole = -1;
    for (std::size_t t = 0; t < history_.polygon.size(); ++t) {
      const int f = history_.polygon[t];
      if (history_.broken_at[static_cast<std::size_t>(f)] > step_) {
        if (f != whole) polygon(f);
        whole = f;
      } else if (history_.death[t] >= step_) {
        triangle(static_cast<int>(t));
      }
    }
  }

 private:
  const CollapseHistory& history_;
  int step_;
};

/// Writes the soup of one state.
class SoupWriter {
 public:
  SoupWriter(const Mesh& mesh, const CollapseHistory& history, int step)
      : mesh_(mesh),
        history_(history),
        step_(step),
        point_(representatives(history.parent, history.n_leaves + step)),
        number_(point_.size(), -1) {
    if (mesh.has_uv())
      uv_ = representatives(history.uv_parent, history.n_uv_at[static_cast<std::size_t>(step)]);
    soup_.name = mesh.name();
    soup_.up_axis = mesh.up_axis();
    soup_.materials = mesh.materials();
  }

  PolygonSoup write() {
    StateWalk(history_, step_).run([&](int f) { add_polygon(FaceId(f)); }, [&](int t) { add_triangle(t); });
    return std::move(soup_);
  }

 private:
  void add_corner(int leaf) {
    const int p = point_[static_cast<std::size_t>(leaf)];
    int& number = number_[static_cast<std::size_t>(p)];
    if (number < 0) {
      number = static_cast<int>(soup_.points.size());
      soup_.points.push_back(history_.position[static_cast<std::size_t>(p)]);
    }
    soup_.corners.push_back(number);
  }
  void end_face(FaceId source) {
    soup_.face_begin.push_back(static_cast<int>(soup_.corners.size()));
    if (!mesh_.materials().empty()) soup_.face_material.push_back(mesh_.material(source));
  }
  void add_polygon(FaceId f) {
    for (const HalfedgeId h : mesh_.halfedges(f)) {
      add_corner(mesh_.from(h).value);
      if (mesh_.has_uv()) soup_.corner_uv.push_back(mesh_.uv(h));
    }
    end_face(f);
  }
  void add_triangle(int t) {
    for (int i = 3 * t; i < 3 * t + 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      add_corner(history_.leaf[k]);
      if (mesh_.has_uv())
        soup_.corner_uv.push_back(
            history_.uv[static_cast<std::size_t>(uv_[static_cast<std::size_t>(history_.uv_leaf[k])])]);
    }
    end_face(FaceId(history_.polygon[static_cast<std::size_t>(t)]));
  }

  const Mesh& mesh_;
  const CollapseHistory& history_;
  int step_;
  std::vector<int> point_;
  std::vector<int> number_;  ///< in the soup, of each point used
  std::vector<int> uv_;
  PolygonSoup soup_;
};

}  // namespace

Simplifier::Simplifier(std::shared_ptr<const Mesh> mesh, const SimplifyOptions& options, Progress& progress)
    : mesh_(std::move(mesh)) {
  progress.set_phase("simplifying");
  history_ = std::make_shared<const CollapseHistory>(simplify::collapse_all(*mesh_, options, progress));
  surface_ = std::make_shared<const SurfaceTree>(*mesh_);
}

int Simplifier::n_faces_max() const { return history_->n_faces_at.front(); }

int Simplifier::n_faces_min() const {
  return *std::min_element(history_->n_faces_at.begin(), history_->n_faces_at.end());
}

// Breaking a polygon may add more faces than its step takes away, so the counts do not fall steadily.
int Simplifier::step_at(int n_faces) const {
  const std::vector<int>& counts = history_->n_faces_at;
  const int wanted = std::clamp(n_faces, n_faces_min(), counts.front());
  int best = -1;
  for (std::size_t s = 0; s < counts.size(); ++s) {
    if (counts[s] > wanted) continue;
    if (best < 0 || counts[s] > counts[static_cast<std::size_t>(best)]) best = static_cast<int>(s);
    if (counts[s] == wanted) break;
  }
  return best;
}

PolygonSoup Simplifier::soup_at(int n_faces) const {
  return SoupWriter(*mesh_, *history_, step_at(n_faces)).write();
}

std::vector<int> Simplifier::sources_at(int n_faces) const {
  std::vector<int> sources;
  StateWalk(*history_, step_at(n_faces))
      .run([&](int f) { sources.push_back(f); },
           [&](int t) { sources.push_back(history_->polygon[static_cast<std::size_t>(t)]); });
  return sources;
}

std::vector<int> Simplifier::heirs_at(int n_faces) const {
  const int step = step_at(n_faces);
  std::vector<int> number(history_->polygon.size(), -1);  // of each triangle that lives, in the soup
  std::vector<int> whole(mesh_->n_faces(), -1);
  int n = 0;
  StateWalk(*history_, step)
      .run([&](int f) { whole[static_cast<std::size_t>(f)] = n++; },
           [&](int t) { number[static_cast<std::size_t>(t)] = n++; });
  // Who dies later is settled first, so that every chain of heirs is one link long.
  std::vector<std::size_t> dead;
  for (std::size_t t = 0; t < number.size(); ++t) {
    const int polygon = whole[static_cast<std::size_t>(history_->polygon[t])];
    if (polygon >= 0) number[t] = polygon;
    if (number[t] < 0) dead.push_back(t);
  }
  std::ranges::sort(dead, std::greater<>(), [&](std::size_t t) { return history_->death[t]; });
  std::vector<int> heirs(mesh_->n_faces(), -1);
  for (const std::size_t t : dead) {
    number[t] = number[static_cast<std::size_t>(history_->heir[t])];
    heirs[static_cast<std::size_t>(history_->polygon[t])] = number[t];
  }
  for (std::size_t t = 0; t < number.size(); ++t)
    if (history_->death[t] >= step) heirs[static_cast<std::size_t>(history_->polygon[t])] = number[t];
  return heirs;
}

double Simplifier::deviation_at(int n_faces) const {
  if (step_at(n_faces) == 0) return 0;
  return hausdorff_distance(*surface_, SurfaceTree(soup_at(n_faces)));
}

double Simplifier::deviation_of(const Mesh& mesh, const Progress& progress) const {
  return hausdorff_distance(*surface_, SurfaceTree(mesh), progress);
}

}  // namespace netwright
