// The whole window: where everything lies, one frame at a time. Owns the views, the dialogs and the
// renderers; made once the window's context is current.
#pragma once

#include <glm/vec2.hpp>

#include "ui/dialogs.h"
#include "ui/empty_state.h"
#include "ui/key_focus.h"
#include "ui/model_view.h"
#include "ui/net_view.h"
#include "ui/run_pictures.h"

namespace netwright {

class Workspace {
 public:
  Workspace();
  ~Workspace();

  /// Takes the theme and scale of the settings over; true when the font atlas changed.
  bool update_look(UiState& ui, double content_scale);
  /// Between ImGui::NewFrame and ImGui::Render.
  void draw(Session& session, UiState& ui);
  /// A key the window reported; shortcuts rest while a dialog is up or text is typed.
  void key(Session& session, UiState& ui, int key_number, int modifiers);
  /// A typed character, for the keys that move about on keyboards.
  void character(Session& session, UiState& ui, char32_t code_point);

  [[nodiscard]] const ModelView& model_view() const { return model_view_; }
  [[nodiscard]] const NetView& net_view() const { return net_view_; }
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const SheetRenderer& sheets() const { return renderers_.sheets; }
  [[nodiscard]] const OverlayRenderer& overlay() const { return renderers_.overlay; }

 private:
  /// Keys that move and use the keyboard's focus; true when this was one.
  bool focus_key(UiState& ui, int key_number, int modifiers);
  void draw_views(UiContext& context, ImVec2 min, ImVec2 size);
  void draw_splitter(UiContext& context, ImVec2 min, ImVec2 size);

  Renderers renderers_;
  Scene scene_;
  ModelView model_view_;
  NetView net_view_;
  EmptyState empty_state_;
  RunPictures run_pictures_;
  KeyFocus focus_;
  bool has_left_field_ = false;  ///< by Tab
  Dialogs dialogs_;
};

}  // namespace netwright
