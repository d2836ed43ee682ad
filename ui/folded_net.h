// The net as it stands in the model's view while it is folded up or down: turned towards the eye and drawn
// smaller the flatter it lies, so that it fills the place of the model.
#pragma once

#include <cstdint>
#include <optional>

#include "core/unfold/fold_pose.h"
#include "render/model_pose.h"
#include "ui/ui_state.h"

namespace netwright {

class FoldedNet {
 public:
  /// Once per frame: moves a playing fold on and poses the net again when it or the amount changed. `shown`
  /// may be null; then the model stands as it is.
  void update(UiState& ui, const ShownNet* shown, UpAxis up_axis);
  /// Null while the model itself is shown.
  [[nodiscard]] const Corners* corners() const { return corners_ ? &*corners_ : nullptr; }
  /// Changes with every other pose; never 0.
  [[nodiscard]] std::uint64_t version() const { return version_; }

 private:
  void play(UiState& ui);
  void pose(const Mesh& mesh, UpAxis up_axis);

  std::optional<FoldPath> path_;
  std::uint64_t net_version_ = 0;
  std::optional<Corners> corners_;
  double amount_ = 1;
  double played_at_ = -1;  ///< on the clock of UiState::now; negative while nothing plays
  std::uint64_t version_ = 1;
};

}  // namespace netwright
