// What is selected: any number of faces and edges, the ones clicked last kept apart for actions that work on
// one. These functions alone change it, so that the parts agree.
#pragma once

#include "ui/ui_state.h"

namespace netwright {

/// `adds`: keeps what is selected already, and lets go of it when it is selected twice; else it is selected
/// alone. Invalid ids select nothing.
void select_face(UiState& ui, FaceId face, bool adds);
/// An edge, clicked at from this side.
void select_side(UiState& ui, const Mesh& mesh, HalfedgeId side, bool adds);
/// These faces and `before`; the last one clicked stays when it is among them. Any order, any number of
/// times.
void select_faces(UiState& ui, std::vector<FaceId> faces, const std::vector<FaceId>& before);
void clear_selection(UiState& ui);
[[nodiscard]] bool has_selection(const UiState& ui);

/// Edges that are drawn lit: the hovered one and the selected ones.
[[nodiscard]] EdgeId hovered_edge(const UiState& ui, const Mesh& mesh);

/// Millimetres on paper per unit of the model; 0 while the size on paper isn't known, which is before the
/// first net when the model is to fill a page.
[[nodiscard]] double print_scale(const Session& session);
/// "Edge 12: fold, 34° mountain, 18.2 mm"; what is not known is left out.
std::string edge_text(const Session& session, EdgeId edge, LengthUnit unit);
/// "3 faces and 2 edges selected"; empty for fewer than two things.
std::string selection_text(const UiState& ui);

}  // namespace netwright
