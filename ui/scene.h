// What both views show in this frame: the net (laid on its pages once it is finished, if wanted), and the
// state of every face. Feeds renderers and pickers, which take over only what changed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/project/session.h"
#include "render/face_states.h"
#include "render/picker.h"
#include "render/renderers.h"
#include "ui/folded_net.h"
#include "ui/ui_state.h"

namespace netwright {

/// A finished net on its paper, in the net's own units, y up; pages stand side by side.
struct PagedNet {
  Net net;
  std::vector<SheetOutline> sheets;
};

/// Moves a net to where it will be printed.
PagedNet on_pages(const Net& net, const PageLayout& layout);

class Scene {
 public:
  /// Brings everything up to date; call once per frame before the views.
  void update(const UiContext& context, Renderers& renderers);

  [[nodiscard]] const std::shared_ptr<const DualGraph>& dual() const { return dual_; }
  [[nodiscard]] const std::shared_ptr<const ShownNet>& shown() const { return shown_; }
  /// The net as it is drawn; null when there is none.
  [[nodiscard]] const Net* net() const {
    if (swinging_) return &swinging_->swing.net();
    return shown_ == nullptr ? nullptr : (paged_ ? &paged_->net : &shown_->net);
  }
  /// That, and the tiles' sheets as the printer gives them, which lie below.
  [[nodiscard]] Box2 desk_box() const {
    Box2 box = net_box();
    if (is_printed()) box.add(spread_box_);
    return box;
  }
  /// A part of the net is on its way to where it was joined; until it is there the desk stays as it was.
  [[nodiscard]] bool is_swinging() const { return swinging_.has_value() && !swinging_->is_glide; }
  /// The net is on its way from one that polish had found to a better one, or lies where that ended.
  [[nodiscard]] bool is_gliding() const { return swinging_.has_value() && swinging_->is_glide; }
  /// Everything the net's view should show: net and pages.
  [[nodiscard]] const Box2& net_box() const { return swinging_ ? swinging_->box : net_box_; }
  /// The pages are seen as they will be printed.
  [[nodiscard]] bool is_printed() const { return sheets_ != nullptr && !swinging_ && paged_ != nullptr; }
  /// The sheets beside which the net itself is drawn, since they are mirrored.
  [[nodiscard]] bool is_net_on_paper() const { return is_printed() && !is_mirrored_; }
  [[nodiscard]] bool is_on_pages() const { return swinging_ ? swinging_->is_on_pages : paged_ != nullptr; }
  /// Changes whenever the net, its pages or its overlaps do.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  /// Changes with every mesh, also when one file is made into another mesh.
  [[nodiscard]] std::uint64_t model_version() const { return model_version_; }
  /// Counts the files shown so far: a new one is framed.
  [[nodiscard]] std::uint64_t file_version() const { return file_version_; }
  /// Where the model's corners are drawn. Only with a model.
  [[nodiscard]] ModelPose pose() const { return ModelPose(dual_->mesh(), folded_.corners()); }
  /// Changes whenever the pose does.
  [[nodiscard]] std::uint64_t pose_version() const { return folded_.version(); }
  [[nodiscard]] const FaceStates& states() const { return states_; }
  /// A large model on the move: trees and folds are left out until all has stood still for a moment.
  [[nodiscard]] bool is_rough() const { return is_rough_; }
  /// Made when they are asked for: most frames have no pointer over the view.
  [[nodiscard]] const ModelPicker& model_picker() const;
  [[nodiscard]] const NetPicker& net_picker() const;

 private:
  void take_net(const UiContext& context, Renderers& renderers);
  void mark_faces(const UiContext& context);
  void mark_pieces(const UiContext& context);
  void follow_swing(const UiContext& context, const std::shared_ptr<const ShownNet>& shown);
  void advance_swing(const UiContext& context, const std::shared_ptr<const ShownNet>& shown);
  [[nodiscard]] bool is_next_of_polish(const UiContext& context, const ShownNet* shown) const;
  [[nodiscard]] bool waits_for_pages(const UiContext& context);
  void move_held_pieces(const Arranging& arranging);
  void take_pose(const UiContext& context, Renderers& renderers);
  void notice_motion(const UiContext& context);
  void give_net(const UiContext& context, Renderers& renderers) const;
  void take_sheets(const UiContext& context, Renderers& renderers);
  void give_tabs(const UiContext& context, Renderers& renderers);
  void place();

  /// The desk as it was when the swing began; under a glide, as it will be.
  struct Swinging {
    Swing swing;
    Box2 box;
    bool is_on_pages;
    double since;
    bool is_glide = false;
    bool is_home = false;  ///< where it goes is where the session lays the net out
    bool is_over = false;  ///< arrived; a glide's net stays there until the next one comes
  };

  std::shared_ptr<const PolygonSoup> source_;
  std::shared_ptr<const DualGraph> dual_;
  std::shared_ptr<const ShownNet> shown_;
  std::unique_ptr<const PagedNet> paged_;
  std::shared_ptr<const PageLayout> layout_;
  std::shared_ptr<const std::vector<Sheet>> sheets_;  ///< shown in place of the net's own drawing,
  std::shared_ptr<const Sheet> instructions_;         ///< with this page, which may be null,
  bool are_instructions_first_ = false;               ///< before or behind them
  bool is_mirrored_ = false;
  std::uint64_t sheets_version_ = 1;
  std::uint64_t tabs_of_ = 0;  ///< the version of the net whose tabs were drawn
  std::shared_ptr<const PageLayout> tabs_layout_;
  bool is_dark_ = false;
  Box2 net_box_;
  Box2 spread_box_;
  std::optional<double> waits_since_;  ///< for the pages of a net that is not drawn yet
  std::optional<Swinging> swinging_;
  int viewed_run_ = 0;  ///< whose net is shown; 0 for the project's
  std::uint64_t version_ = 1;
  std::uint64_t arranged_version_ = 0;
  std::uint64_t model_version_ = 0;
  std::uint64_t file_version_ = 0;
  FoldedNet folded_;
  FaceStates states_;
  std::uint64_t moved_version_ = 0;  ///< of net and pose together, as last seen
  double moved_at_ = 0;              ///< on the clock of UiState::now
  bool is_rough_ = false;
  mutable ModelPicker model_picker_;
  mutable NetPicker net_picker_;
};

}  // namespace netwright
