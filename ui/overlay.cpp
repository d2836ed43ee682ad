// Gathers the overlay's lines. The curve between the two sides of a cut leaves each side at a right angle, so
// that one sees which side it belongs to.
#include "ui/overlay.h"

#include <algorithm>
#include <array>

#include "ui/selection.h"

namespace netwright {
namespace {

constexpr int kCurveSteps = 32;
constexpr double kBulge = 0.35;          ///< of the distance between the sides
constexpr std::size_t kMostCurves = 60;  ///< more than this is a tangle

struct Target {
  const ModelPose& pose;
  const Net* net;
  const IdVector<EdgeId, EdgeKind>* kinds;
  OverlayLines& lines;

  [[nodiscard]] bool is_cut(EdgeId e) const { return kinds != nullptr && (*kinds)[e] == EdgeKind::Cut; }
};

void add_edge(const Target& to, EdgeId e, OverlayStyle style) {
  const Mesh& mesh = to.pose.mesh();
  for (const HalfedgeId h : {mesh.halfedge(e), to.is_cut(e) ? mesh.twin(mesh.halfedge(e)) : HalfedgeId()}) {
    if (!h.is_valid()) continue;
    const HalfedgeId end = mesh.next(h);
    const bool is_there_already = to.pose.is_model() && h != mesh.halfedge(e);
    if (!is_there_already) to.lines.add_in_space(to.pose.position(h), to.pose.position(end), style);
    if (to.net != nullptr) to.lines.add_in_plane(to.net->corner(h), to.net->corner(end), style);
  }
}

void add_pins(const Target& to, const Constraints& pins) {
  const Mesh& mesh = to.pose.mesh();
  for (const std::vector<FaceId>& patch : pins.together)
    for (const FaceId f : patch)
      for (const HalfedgeId h : mesh.halfedges(f))
        if (!std::binary_search(patch.begin(), patch.end(), mesh.neighbour(h)))
          add_edge(to, mesh.edge(h), OverlayStyle::Patch);
  for (const EdgeId e : pins.must_fold) add_edge(to, e, OverlayStyle::PinnedFold);
  for (const EdgeId e : pins.must_cut) add_edge(to, e, OverlayStyle::PinnedCut);
}

/// What the tool in hand would bring: the moved faces where they would lie, those that would overlap marked,
/// and the places a dragged branch could hang at.
void add_edit(const Target& to, const Editing& editing) {
  const Mesh& mesh = to.pose.mesh();
  for (const HalfedgeId h : editing.places) add_edge(to, mesh.edge(h), OverlayStyle::Selected);
  if (!editing.edit || editing.preview == nullptr || to.net == nullptr) return;
  const HandEdit& edit = *editing.edit;
  const Net& after = editing.preview->net;
  std::vector<char> is_moved(mesh.n_faces(), 0);
  for (const FaceId f : edit.moved) is_moved[f.index()] = 1;
  Rigid2 there;  // from the preview's plane to the one that is drawn
  if (!edit.joined.empty()) {
    const HalfedgeId h = mesh.halfedge(edit.joined.front());
    const FaceId still = is_moved[mesh.face(h).index()] != 0 ? mesh.neighbour(h) : mesh.face(h);
    there = to.net->placement[still] * after.placement[still].inverse();
  }
  for (const FaceId f : edit.moved) {
    const OverlayStyle style =
        editing.preview->is_overlapping[f.index()] ? OverlayStyle::Culprit : OverlayStyle::Hovered;
    for (const HalfedgeId h : mesh.halfedges(f)) {
      if (edit.joined.empty()) {
        to.lines.add_in_plane(to.net->corner(h), to.net->corner(mesh.next(h)), style);
      } else {
        to.lines.add_in_plane(there(after.corner(h)), there(after.corner(mesh.next(h))), style);
      }
    }
  }
}

/// From the middle of a cut's side to the middle of its other side.
void add_curve(const Target& to, EdgeId e) {
  const Mesh& mesh = to.pose.mesh();
  const HalfedgeId h = mesh.halfedge(e);
  const auto middle = [&](HalfedgeId g) { return (to.net->corner(g) + to.net->corner(mesh.next(g))) * 0.5; };
  const auto outward = [&](HalfedgeId g) {
    const glm::dvec2 along = glm::normalize(to.net->corner(mesh.next(g)) - to.net->corner(g));
    return glm::dvec2(along.y, -along.x);
  };
  const glm::dvec2 from = middle(h);
  const glm::dvec2 end = middle(mesh.twin(h));
  const double bulge = kBulge * glm::distance(from, end);
  const std::array<glm::dvec2, 4> p{from, from + bulge * outward(h), end + bulge * outward(mesh.twin(h)),
                                    end};
  glm::dvec2 before = from;
  for (int k = 1; k <= kCurveSteps; ++k) {
    const double t = static_cast<double>(k) / kCurveSteps;
    const double s = 1 - t;
    const glm::dvec2 here = s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
    to.lines.add_in_plane(before, here, OverlayStyle::Partner);
    before = here;
  }
}

/// What a line of the report is about. What the mesh has not can only be shown where the model stands.
void add_lit(const Target& to, const Lit& lit) {
  for (const EdgeId e : lit.edges) add_edge(to, e, OverlayStyle::Culprit);
  if (!to.pose.is_model()) return;
  for (const auto& [a, b] : lit.segments) to.lines.add_in_space(a, b, OverlayStyle::Culprit);
  for (const glm::dvec3& p : lit.points) to.lines.add_in_space(p, p, OverlayStyle::CulpritDot);
}

}  // namespace

OverlayLines overlay_of(const UiState& ui, const ModelPose& pose, const Net* net,
                        const IdVector<EdgeId, EdgeKind>* kinds, const Constraints& pins,
                        const Contradiction* contradiction) {
  OverlayLines lines;
  const Target to{pose, net, kinds, lines};
  add_pins(to, pins);
  if (contradiction != nullptr)
    for (const EdgeId e : contradiction->edges) add_edge(to, e, OverlayStyle::Culprit);
  const EdgeId hovered = hovered_edge(ui, pose.mesh());
  std::size_t n_curves = 0;
  for (const EdgeId e : ui.selected_edges) {
    if (to.is_cut(e) && e != hovered && n_curves++ < kMostCurves) add_curve(to, e);
  }
  if (hovered.is_valid() && to.is_cut(hovered)) add_curve(to, hovered);
  for (const EdgeId e : ui.selected_edges) add_edge(to, e, OverlayStyle::Selected);
  if (ui.editing.is_on) add_edit(to, ui.editing);
  add_lit(to, ui.lit);
  if (hovered.is_valid()) add_edge(to, hovered, OverlayStyle::Hovered);
  return lines;
}

}  // namespace netwright
