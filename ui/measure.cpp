// A measured point belongs to a face and keeps its place in the face's flat frame, so that one point is at
// home in both views and stays on its paper while the net changes.
#include "ui/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "ui/selection.h"
#include "ui/status.h"

namespace netwright {
namespace {

/// Three corners of a face that span it well: the way between its flat frame and space.
struct Span {
  glm::dvec2 flat;  ///< of the first corner
  glm::dvec2 flat_u, flat_v;
  glm::dvec3 space;
  glm::dvec3 space_u, space_v;

  Span(const DualGraph& dual, const ModelPose& pose, FaceId f) {
    const Mesh& mesh = dual.mesh();
    const HalfedgeId origin = mesh.first(f);
    double best = -1;
    for (const HalfedgeId h : mesh.halfedges(f)) {
      const glm::dvec2 u = dual.flat(h) - dual.flat(origin);
      const glm::dvec2 v = dual.flat(mesh.next(h)) - dual.flat(origin);
      if (std::abs(cross(u, v)) <= best) continue;
      best = std::abs(cross(u, v));
      flat_u = u;
      flat_v = v;
      space_u = pose.position(h) - pose.position(origin);
      space_v = pose.position(mesh.next(h)) - pose.position(origin);
    }
    flat = dual.flat(origin);
    space = pose.position(origin);
  }

  [[nodiscard]] glm::dvec3 to_space(glm::dvec2 p) const {
    const double whole = cross(flat_u, flat_v);
    return space + space_u * (cross(p - flat, flat_v) / whole) + space_v * (cross(flat_u, p - flat) / whole);
  }
  /// Where a ray meets the face's plane.
  [[nodiscard]] glm::dvec2 to_flat(const Ray& ray) const {
    const glm::dvec3 n = glm::cross(space_u, space_v);
    const double t = glm::dot(n, space - ray.origin) / glm::dot(n, ray.direction);
    const glm::dvec3 q = ray.origin + t * ray.direction - space;
    const double whole = glm::dot(n, n);
    return flat + flat_u * (glm::dot(glm::cross(q, space_v), n) / whole) +
           flat_v * (glm::dot(glm::cross(space_u, q), n) / whole);
  }
};

/// The nearest corner within reach, else the nearest point of the edge that is pointed at.
template <class PixelOf>
PaperPoint snapped(const Pointed& pointed, const DualGraph& dual, glm::dvec2 pixel, double reach_px,
                   const PixelOf& pixel_of) {
  const Mesh& mesh = dual.mesh();
  PaperPoint found;
  double nearest = 1.4 * reach_px;  // a corner is what people mean most often
  for (const FaceId f : {pointed.face, pointed.side.is_valid() ? mesh.face(pointed.side) : FaceId()}) {
    if (!f.is_valid()) continue;
    for (const HalfedgeId h : mesh.halfedges(f)) {
      const double away = glm::distance(pixel, pixel_of(h));
      if (away >= nearest) continue;
      nearest = away;
      found = {f, dual.flat(h), HalfedgeId()};
    }
  }
  if (found.is_valid() || !pointed.side.is_valid()) return found;
  const HalfedgeId end = mesh.next(pointed.side);
  const glm::dvec2 a = pixel_of(pointed.side);
  const glm::dvec2 along = pixel_of(end) - a;
  const double t = std::clamp(glm::dot(pixel - a, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
  return {mesh.face(pointed.side), glm::mix(dual.flat(pointed.side), dual.flat(end), t), pointed.side};
}

std::string distance_text(const UiContext& context, double distance) {
  const double scale = print_scale(context.session);
  if (scale > 0) return exact_length_text(distance * scale, context.ui.settings.unit);
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.4g of the model's units", distance);
  return text.data();
}

/// Between two edges: at their common end when they have one, else between their lines.
double angle_between(const Mesh& mesh, HalfedgeId a, HalfedgeId b, const glm::dvec3& along_a,
                     const glm::dvec3& along_b) {
  const double angle = std::atan2(glm::length(glm::cross(along_a, along_b)), glm::dot(along_a, along_b)) *
                       180 / std::numbers::pi;
  const bool same_end = mesh.from(a) == mesh.from(b) || mesh.to(a) == mesh.to(b);
  if (same_end) return angle;
  if (mesh.from(a) == mesh.to(b) || mesh.to(a) == mesh.from(b)) return 180 - angle;
  return std::min(angle, 180 - angle);
}

std::string angle_text(double degrees) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f°", degrees);
  return text.data();
}

/// "in the net" and "on the model", or once for both where they agree.
std::string both(const std::string& in_net, const std::string& in_space) {
  if (in_net.empty()) return in_space + " on the model";
  return in_net == in_space ? in_space : in_net + " in the net, " + in_space + " on the model";
}

std::string angles_text(const PaperPoint& a, const PaperPoint& b, const Net* net, const ModelPose& pose) {
  const Mesh& mesh = pose.mesh();
  const auto in_space = [&](HalfedgeId h) { return pose.position(mesh.next(h)) - pose.position(h); };
  const auto in_net = [&](HalfedgeId h) { return glm::dvec3(net->corner(mesh.next(h)) - net->corner(h), 0); };
  std::string space = angle_text(angle_between(mesh, a.side, b.side, in_space(a.side), in_space(b.side)));
  if (net == nullptr) return space;
  return both(angle_text(angle_between(mesh, a.side, b.side, in_net(a.side), in_net(b.side))), space);
}

std::string result_text(const UiContext& context, const PaperPoint& a, const PaperPoint& b, const Net* net,
                        const ModelPose& pose) {
  const DualGraph& dual = *context.session.project().dual;
  const double in_space = distance_on_model(dual, a, b);
  // Between pieces of paper there is no distance that means anything.
  const bool is_one_paper = net != nullptr && net->piece[a.face] == net->piece[b.face];
  const std::string flat =
      is_one_paper ? distance_text(context, glm::distance(place_in_net(*net, a), place_in_net(*net, b))) : "";
  std::string text = both(flat, distance_text(context, in_space));
  const bool are_edges =
      a.side.is_valid() && b.side.is_valid() && pose.mesh().edge(a.side) != pose.mesh().edge(b.side);
  if (are_edges) text += " · angle of the edges " + angles_text(a, b, is_one_paper ? net : nullptr, pose);
  return text;
}

}  // namespace

glm::dvec2 place_in_net(const Net& net, const PaperPoint& point) {
  return net.placement[point.face](point.flat);
}

glm::dvec3 place_in_space(const DualGraph& dual, const ModelPose& pose, const PaperPoint& point) {
  return Span(dual, pose, point.face).to_space(point.flat);
}

PaperPoint paper_point(const Pointed& pointed, const DualGraph& dual, const ModelPose& pose,
                       const OrbitCamera& camera, glm::dvec2 pixel, double reach_px, bool snaps) {
  if (snaps) {
    const PaperPoint point = snapped(pointed, dual, pixel, reach_px, [&](HalfedgeId h) {
      return glm::dvec2(camera.project(pose.position(h)));
    });
    if (point.is_valid()) return point;
  }
  if (!pointed.face.is_valid()) return {};
  return {pointed.face, Span(dual, pose, pointed.face).to_flat(camera.ray(pixel)), HalfedgeId()};
}

PaperPoint paper_point(const Pointed& pointed, const Net& net, const PanZoomCamera& camera, glm::dvec2 pixel,
                       double reach_px, bool snaps) {
  if (snaps) {
    const PaperPoint point = snapped(pointed, *net.dual, pixel, reach_px,
                                     [&](HalfedgeId h) { return camera.to_pixel(net.corner(h)); });
    if (point.is_valid()) return point;
  }
  if (!pointed.face.is_valid()) return {};
  return {pointed.face, net.placement[pointed.face].inverse()(camera.to_world(pixel)), HalfedgeId()};
}

void take_measure(UiContext& context, const PaperPoint& point, const Gesture& gesture, const Net* net) {
  UiState& ui = context.ui;
  // A net that is folded half is drawn at a size of its own; what counts is the finished model.
  const ModelPose pose(context.session.project().dual->mesh());
  Measuring& measuring = ui.measuring;
  measuring.hovered = point;
  ui.hovered_side = point.side;
  if (gesture.is_clicked && point.is_valid()) {
    if (measuring.points.size() >= 2) measuring.points.clear();
    measuring.points.push_back(point);
  }
  PaperPoint from;
  PaperPoint to;
  if (measured_points(measuring, from, to)) {
    ui.hint = result_text(context, from, to, net, pose) +
              (measuring.points.size() == 2 ? " · click measures anew · Esc ends" : "");
  } else if (!measuring.points.empty()) {
    ui.hint = "Click the second point · Esc lets go of the first";
  } else {
    ui.hint =
        (point.side.is_valid() ? edge_text(context.session, pose.mesh().edge(point.side), ui.settings.unit)
                               : "Measure: click two corners, edges or points") +
        " · Ctrl switches snapping off · Esc ends";
  }
}

void end_measure(UiState& ui) {
  if (ui.measuring.points.empty()) ui.measuring.is_on = false;
  ui.measuring.points.clear();
  ui.measuring.hovered = PaperPoint();
}

bool measured_points(const Measuring& measuring, PaperPoint& from, PaperPoint& to) {
  if (!measuring.is_on || measuring.points.empty()) return false;
  from = measuring.points.front();
  to = measuring.points.size() > 1 ? measuring.points[1] : measuring.hovered;
  return to.is_valid();
}

void add_measure(const Measuring& measuring, const DualGraph& dual, const ModelPose& pose, const Net* net,
                 OverlayLines& lines) {
  if (!measuring.is_on) return;
  PaperPoint from;
  PaperPoint to;
  if (measured_points(measuring, from, to)) {
    lines.add_in_space(place_in_space(dual, pose, from), place_in_space(dual, pose, to),
                       OverlayStyle::Measured);
    if (net != nullptr && net->piece[from.face] == net->piece[to.face])
      lines.add_in_plane(place_in_net(*net, from), place_in_net(*net, to), OverlayStyle::Measured);
  }
  std::vector<PaperPoint> dots = measuring.points;
  if (dots.size() < 2 && measuring.hovered.is_valid()) dots.push_back(measuring.hovered);
  for (const PaperPoint& point : dots) {
    for (const OverlayStyle style : {OverlayStyle::Rim, OverlayStyle::Dot}) {
      const glm::dvec3 at = place_in_space(dual, pose, point);
      lines.add_in_space(at, at, style);
      if (net != nullptr) lines.add_in_plane(place_in_net(*net, point), place_in_net(*net, point), style);
    }
  }
}

double distance_on_model(const DualGraph& dual, const PaperPoint& a, const PaperPoint& b) {
  const ModelPose model(dual.mesh());
  return glm::distance(place_in_space(dual, model, a), place_in_space(dual, model, b));
}

void draw_measure_label(const UiContext& context, double distance, glm::dvec2 from_px, glm::dvec2 to_px,
                        ImVec2 corner) {
  const Look& look = context.ui.look;
  const std::string text = distance_text(context, distance);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const glm::dvec2 middle = (from_px + to_px) * 0.5;
  const ImVec2 rim(look.px(8), look.px(4));
  const ImVec2 min(std::floor(corner.x + static_cast<float>(middle.x) - size.x / 2),
                   std::floor(corner.y + static_cast<float>(middle.y) - size.y - look.px(14)));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 low(min.x - rim.x, min.y - rim.y);
  const ImVec2 high(min.x + size.x + rim.x, min.y + size.y + rim.y);
  draw.AddRectFilled(low, high, look.colours.field, look.px(4));
  draw.AddRect(low, high, look.colours.border, look.px(4));
  draw.AddText(min, look.colours.text, text.c_str());
}

}  // namespace netwright
