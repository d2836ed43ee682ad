// Finds every pinned edge and face again in another mesh. Pins are few and made by hand, so each one simply
// looks at all candidates; only patches, which may hold many faces, ask in the other direction.
#include "core/project/carry_pins.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netwright {

namespace {

constexpr double kSameWay = 0.8660254037844387;  // cos 30°

struct Segment {
  glm::dvec3 middle;
  glm::dvec3 along;  // from end to end
};

Segment segment(const Mesh& mesh, EdgeId e) {
  const HalfedgeId h = mesh.halfedge(e);
  const glm::dvec3& a = mesh.position(mesh.from(h));
  const glm::dvec3& b = mesh.position(mesh.to(h));
  return {0.5 * (a + b), b - a};
}

FaceId nearest_face(const Mesh& from, FaceId pinned, const Mesh& to) {
  FaceId best;
  double least = std::numeric_limits<double>::infinity();
  for (const FaceId f : to.faces()) {
    const double distance = glm::length(to.centre(f) - from.centre(pinned));
    const bool is_same = to.face_source(f) == from.face_source(pinned);
    const bool looks_alike = glm::dot(to.normal(f), from.normal(pinned)) >= kSameWay;
    const double reach = 0.5 * (to.size(f) + from.size(pinned));
    if (!looks_alike || distance > reach) continue;
    const double rank = is_same ? distance - 2 * reach : distance;
    if (rank >= least) continue;
    least = rank;
    best = f;
  }
  return best;
}

// A face belongs to the patch that holds the face nearest to its middle.
std::vector<std::vector<FaceId>> carry_patches(const Constraints& pins, const Mesh& from, const Mesh& to) {
  std::vector<std::vector<FaceId>> patches(pins.together.size());
  if (patches.empty()) return patches;
  for (const FaceId f : to.faces()) {
    const FaceId own = nearest_face(to, f, from);
    const int patch = own.is_valid() ? patch_of(pins, own) : -1;
    if (patch >= 0) patches[static_cast<std::size_t>(patch)].push_back(f);
  }
  return patches;
}

}  // namespace

EdgeId nearest_edge(const Mesh& from, EdgeId edge, const Mesh& to) {
  const Segment own = segment(from, edge);
  const double own_length = glm::length(own.along);
  EdgeId best;
  double least = std::numeric_limits<double>::infinity();
  for (const EdgeId e : to.edges()) {
    const Segment other = segment(to, e);
    const double distance = glm::length(other.middle - own.middle);
    const double length = glm::length(other.along);
    if (distance >= least || distance > 0.5 * std::max(length, own_length)) continue;
    if (std::abs(glm::dot(own.along, other.along)) < kSameWay * own_length * length) continue;
    least = distance;
    best = e;
  }
  return best;
}

std::string CarriedPins::sentence() const {
  if (n_lost == 0) return "";
  return n_lost == 1 ? "One pin found no place on the new faces and is gone."
                     : std::to_string(n_lost) + " pins found no place on the new faces and are gone.";
}

CarriedPins carry_pins(const Constraints& pins, const Mesh& from, const Mesh& to) {
  CarriedPins carried;
  if (pins.root.is_valid()) {
    carried.pins.root = nearest_face(from, pins.root, to);
    carried.n_lost += carried.pins.root.is_valid() ? 0 : 1;
  }
  const auto carry_edges = [&](const std::vector<EdgeId>& edges, EdgePin pin) {
    for (const EdgeId e : edges) {
      const EdgeId place = nearest_edge(from, e, to);
      const bool is_free =
          place.is_valid() && !to.is_border(place) && pin_of(carried.pins, place) == EdgePin::None;
      if (is_free)
        set_pin(carried.pins, place, pin);
      else
        ++carried.n_lost;
    }
  };
  carry_edges(pins.must_fold, EdgePin::MustFold);
  carry_edges(pins.must_cut, EdgePin::MustCut);
  for (auto& patch : carry_patches(pins, from, to)) {
    if (patch.size() > 1)
      keep_together(carried.pins, std::move(patch));
    else
      ++carried.n_lost;
  }
  return carried;
}

}  // namespace netwright
