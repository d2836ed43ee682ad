// An edge near the pointer comes before the face under it: what is lit is what a click takes.
#include "ui/pointing.h"

#include "ui/selection.h"
#include "ui/status.h"

namespace netwright {
namespace {

constexpr float kEdgeReach = 7;

}  // namespace

double edge_reach(const UiState& ui) { return static_cast<double>(kEdgeReach * ui.look.scale); }

void take_pointer(UiContext& context, const Pointed& pointed, const Gesture& gesture,
                  const std::string& ground_hint) {
  UiState& ui = context.ui;
  const Mesh& mesh = context.session.project().dual->mesh();
  ui.hovered = pointed.face;
  ui.hovered_side = pointed.side;
  if (pointed.side.is_valid()) {
    ui.hint = edge_text(context.session, mesh.edge(pointed.side), ui.settings.unit) +
              " · click selects · G must fold · C must cut";
  } else if (pointed.face.is_valid()) {
    ui.hint = face_text(pointed.face) + " · click selects · R makes it the root · double-click centres it";
  } else {
    ui.hint = ground_hint;
  }
  if (const std::string selected = selection_text(ui); !selected.empty())
    ui.hint = selected + " · " + ui.hint;
  if (gesture.is_clicked) {
    // A trembling Shift+click beside the model must not lose a selection.
    if (pointed.side.is_valid()) {
      select_side(ui, mesh, pointed.side, gesture.is_adding);
    } else {
      select_face(ui, pointed.face, gesture.is_adding);
    }
  }
  const FaceId centred = pointed.side.is_valid() ? mesh.face(pointed.side) : pointed.face;
  if (gesture.is_double_clicked && centred.is_valid()) ui.wants_centre = centred;
}

std::string band_hint(const UiState& ui) {
  return counted(static_cast<std::int64_t>(ui.selected_faces.size()), "face", "faces") + " selected";
}

}  // namespace netwright
