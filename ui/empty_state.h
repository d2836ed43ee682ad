// What is shown before there is a model: a drop target, the samples as pictures, recent files.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "render/renderers.h"
#include "ui/ui_state.h"

namespace netwright {

class EmptyState {
 public:
  /// Draws into the present ImGui window. One sample's picture is made per frame, so the window comes up at
  /// once.
  void draw(UiContext& context, const Renderers& renderers);

 private:
  struct Picture {
    std::shared_ptr<const DualGraph> dual;
    Viewport viewport;
  };
  void drop_target(UiContext& context, ImVec2 size);
  void sample_cards(UiContext& context, const Renderers& renderers, float width);
  bool card(UiContext& context, std::size_t index, ImVec2 size, const Renderers& renderers);
  void load_one(UiState& ui);
  void paint(const UiState& ui, Picture& picture, MeshRenderer& mesh, const Renderers& renderers,
             glm::ivec2 size);
  void recent_files(UiContext& context);

  std::vector<std::unique_ptr<Picture>> pictures_;
  std::vector<std::unique_ptr<MeshRenderer>> renderers_;
};

}  // namespace netwright
