// Selections are sorted lists: a model has thousands of faces, a person selects dozens.
#include "ui/selection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/base/predicates.h"
#include "ui/status.h"

namespace netwright {
namespace {

/// In when it was out, out when it was in; true when it is in now.
template <class Key>
bool toggle(std::vector<Key>& sorted, Key key) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), key);
  if (at != sorted.end() && *at == key) {
    sorted.erase(at);
    return false;
  }
  sorted.insert(at, key);
  return true;
}

const char* kind_word(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::Cut:
      return "cut";
    case EdgeKind::Border:
      return "border";
    default:
      return "fold";
  }
}

std::string bend_text(double bend_rad) {
  if (std::abs(bend_rad) < kFlatFold) return "flat";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.0f°", std::abs(bend_rad) * 180 / std::numbers::pi);
  return std::string(text.data()) + (bend_rad > 0 ? " mountain" : " valley");
}

}  // namespace

void select_face(UiState& ui, FaceId face, bool adds) {
  if (!adds) clear_selection(ui);
  if (!face.is_valid()) return;
  const bool is_in = toggle(ui.selected_faces, face);
  ui.selected = is_in ? face : (ui.selected_faces.empty() ? FaceId() : ui.selected_faces.back());
}

void select_side(UiState& ui, const Mesh& mesh, HalfedgeId side, bool adds) {
  if (!adds) clear_selection(ui);
  if (!side.is_valid()) return;
  const bool is_in = toggle(ui.selected_edges, mesh.edge(side));
  ui.selected_side = is_in                       ? side
                     : ui.selected_edges.empty() ? HalfedgeId()
                                                 : mesh.halfedge(ui.selected_edges.back());
}

void select_faces(UiState& ui, std::vector<FaceId> faces, const std::vector<FaceId>& before) {
  faces.insert(faces.end(), before.begin(), before.end());
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  ui.selected_faces = std::move(faces);
  if (!std::binary_search(ui.selected_faces.begin(), ui.selected_faces.end(), ui.selected))
    ui.selected = ui.selected_faces.empty() ? FaceId() : ui.selected_faces.back();
}

void clear_selection(UiState& ui) {
  ui.selected = FaceId();
  ui.selected_side = HalfedgeId();
  ui.selected_faces.clear();
  ui.selected_edges.clear();
  ui.shown_overlap.reset();
}

bool has_selection(const UiState& ui) {
  return !ui.selected_faces.empty() || !ui.selected_edges.empty() || ui.shown_overlap.has_value();
}

EdgeId hovered_edge(const UiState& ui, const Mesh& mesh) {
  return ui.hovered_side.is_valid() ? mesh.edge(ui.hovered_side) : EdgeId();
}

double print_scale(const Session& session) {
  if (!session.has_model()) return 0;
  if (const auto pages = session.pages()) return pages->scale;
  const Project& project = session.project();
  const double height = project.dual->mesh().height();
  return project.size.kind == PrintSize::Kind::Height && height > 0 ? project.size.height_mm / height : 0;
}

std::string edge_text(const Session& session, EdgeId edge, LengthUnit unit) {
  const DualGraph& dual = *session.project().dual;
  std::string text = "Edge " + std::to_string(edge.value + 1) + ": ";
  const auto shown = session.shown();
  const bool is_border = dual.mesh().is_border(edge);
  if (is_border || shown != nullptr) text += kind_word(is_border ? EdgeKind::Border : shown->kinds[edge]);
  if (!is_border) text += (shown == nullptr ? "" : ", ") + bend_text(dual.bend(edge));
  const double scale = print_scale(session);
  if (scale > 0) text += ", " + exact_length_text(dual.mesh().length(edge) * scale, unit);
  return text;
}

std::string selection_text(const UiState& ui) {
  const std::size_t n = ui.selected_faces.size() + ui.selected_edges.size();
  if (n < 2) return {};
  std::string text;
  if (!ui.selected_faces.empty())
    text = counted(static_cast<std::int64_t>(ui.selected_faces.size()), "face", "faces");
  if (!ui.selected_edges.empty())
    text += (text.empty() ? "" : " and ") +
            counted(static_cast<std::int64_t>(ui.selected_edges.size()), "edge", "edges");
  return text + " selected";
}

}  // namespace netwright
