// Decides what is drawn, and carries nets from the pages' millimetres (y down) to the view's units (y up).
#include "ui/scene.h"

#include <algorithm>

#include "core/sheet/pages.h"
#include "ui/arranging.h"
#include "ui/desk.h"
#include "ui/heat.h"
#include "ui/lit.h"
#include "ui/measure.h"
#include "ui/overlay.h"
#include "ui/printed.h"
#include "ui/selection.h"
#include "ui/tab_tool.h"
#include "ui/view_parts.h"

namespace netwright {
namespace {

/// From here on a frame of software drawing takes longer than a hand on a slider should feel, and edges are
/// so short on screen that their dashes run together anyway.
constexpr std::size_t kManyFaces = 3000;
constexpr double kRest_s = 0.25;  ///< without motion before everything is drawn again
/// A net whose pages are not laid out yet is not drawn for so long: what was seen before stays instead of
/// jumping to and fro.
constexpr double kPatience_s = 0.5;

/// The session's net will lie on pages in a moment.
bool is_laying_out(const UiContext& context) {
  const Session& session = context.session;
  return context.ui.settings.show_pages && session.is_laying_out() && session.pages() == nullptr &&
         session.state() == RunState::Idle;
}

Box2 flipped(glm::dvec2 corner, glm::dvec2 size, double scale) {
  Box2 box;
  box.add(glm::dvec2(corner.x, -corner.y) / scale);
  box.add(glm::dvec2(corner.x + size.x, -corner.y - size.y) / scale);
  return box;
}

/// A page that stands alone is shown whole; tiles are shown as what they print, since their margins overlap.
SheetOutline outline_of(const PageLayout& layout, const PageLayout::Page& page) {
  const PageFrame& frame = layout.frame;
  const glm::dvec2 shift(canvas_left(layout, page.canvas), 0);
  if (layout.canvases[static_cast<std::size_t>(page.canvas)].is_tiled()) {
    const glm::dvec2 size = page.shown.size();
    const glm::dvec2 inset = glm::min(glm::dvec2(layout.overlap_mm), size / 4.0);
    return {flipped(page.shown.min + shift, size, layout.scale),
            flipped(page.shown.min + shift + inset, size - 2.0 * inset, layout.scale)};
  }
  const glm::dvec2 corner = page.origin + shift - frame.net.min;
  return {flipped(corner, {frame.width_mm, frame.height_mm}, layout.scale),
          flipped(corner + frame.printable.min, frame.printable.size(), layout.scale)};
}

}  // namespace

PagedNet on_pages(const Net& net, const PageLayout& layout) {
  PagedNet paged{net, {}};
  for (const FaceId f : net.mesh().faces()) {
    const auto& placement = layout.pieces[static_cast<std::size_t>(net.piece[f])];
    // The turn acts on millimetres; divided by the scale it acts on the net's own units.
    Rigid2 turn = placement.turn;
    turn.x = (turn.x + canvas_left(layout, placement.canvas)) / layout.scale;
    turn.y /= layout.scale;
    paged.net.placement[f] = turn * net.placement[f];
  }
  for (const auto& page : layout.pages) paged.sheets.push_back(outline_of(layout, page));
  return paged;
}

void Scene::place() {
  paged_ = nullptr;
  net_box_ = Box2();
  if (shown_ == nullptr) return;
  if (layout_ != nullptr) paged_ = std::make_unique<const PagedNet>(on_pages(shown_->net, *layout_));
  net_box_ = paged_ ? paged_->net.box() : shown_->net.box();
  if (paged_ == nullptr) return;
  for (const SheetOutline& sheet : paged_->sheets) net_box_.add(sheet.border);
}

void Scene::move_held_pieces(const Arranging& arranging) {
  if (paged_ == nullptr || !arranging.has_motion || arranging.layout != layout_) return;
  PagedNet moved = *paged_;
  for (const FaceId f : moved.net.mesh().faces()) {
    const bool is_held =
        std::binary_search(arranging.pieces.begin(), arranging.pieces.end(), moved.net.piece[f]);
    if (is_held) moved.net.placement[f] = arranging.motion * moved.net.placement[f];
  }
  paged_ = std::make_unique<const PagedNet>(std::move(moved));
}

bool Scene::waits_for_pages(const UiContext& context) {
  const auto shown = context.session.shown();
  const bool is_due = is_laying_out(context) && paged_ != nullptr && !swinging_ && !context.ui.swing &&
                      shown != nullptr && shown->net.dual == shown_->net.dual;
  if (!is_due) {
    waits_since_.reset();
    return false;
  }
  if (!waits_since_) waits_since_ = context.ui.now;
  context.ui.frames_wanted = std::max(context.ui.frames_wanted, 2);
  return context.ui.now - *waits_since_ < kPatience_s;
}

void Scene::take_net(const UiContext& context, Renderers& renderers) {
  const auto shown = context.session.shown();
  const auto layout = context.ui.settings.show_pages ? context.session.pages() : nullptr;
  const std::uint64_t arranged = context.ui.arranging.version;
  const bool was_swinging = swinging_.has_value();
  const bool was_resting = was_swinging && swinging_->is_over;
  follow_swing(context, shown);
  const bool is_resting = was_resting && swinging_ && swinging_->is_over;
  const bool is_still = !was_swinging || is_resting;
  if (shown == shown_ && layout == layout_ && arranged == arranged_version_ && is_still) return;
  shown_ = shown;
  viewed_run_ = context.session.viewed_run();
  layout_ = layout;
  arranged_version_ = arranged;
  ++version_;
  place();
  move_held_pieces(context.ui.arranging);
  if (shown_ == nullptr) {
    renderers.net.clear();
    renderers.tree.clear();
    return;
  }
  if (!swinging_)
    renderers.net.set_sheets(paged_ == nullptr ? std::span<const SheetOutline>() : paged_->sheets);
}

/// A search or a replay goes on, of the run that is looked at.
bool is_on_the_way(const Session& session) {
  const RunState state = session.state();
  return state == RunState::Running || state == RunState::Paused || state == RunState::Replaying ||
         session.timeline().has_value();
}

/// One net without overlaps after another, of the same search or replay: that is what polish shows.
bool Scene::is_next_of_polish(const UiContext& context, const ShownNet* shown) const {
  if (context.ui.is_motion_reduced || shown == nullptr || shown_ == nullptr || shown == shown_.get() ||
      paged_ != nullptr)
    return false;
  return is_on_the_way(context.session) && context.session.viewed_run() == viewed_run_ &&
         shown->net.dual == shown_->net.dual && shown->overlaps.empty() && shown_->overlaps.empty() &&
         !(shown->net.tree == shown_->net.tree);
}

void Scene::advance_swing(const UiContext& context, const std::shared_ptr<const ShownNet>& shown) {
  const UiState& ui = context.ui;
  Swinging& now = *swinging_;
  const bool is_other =
      shown == nullptr || shown->net.dual != shown_->net.dual || !(shown->net.tree == now.swing.goal());
  if (is_other) return swinging_.reset();
  if (!now.is_over) now.is_over = !now.swing.advance(ui.now);
  if (!now.is_over) return;
  const bool waits = is_laying_out(context);
  if (!now.is_glide) {
    // It rests where it arrived until it has a place on a page.
    const bool is_resting = now.is_on_pages && waits && ui.now - now.since < Swing::kSeconds + kPatience_s;
    if (!is_resting) swinging_.reset();
    return;
  }
  const bool has_pages = ui.settings.show_pages && context.session.pages() != nullptr;
  if (now.is_home || has_pages) return swinging_.reset();
  if (is_on_the_way(context.session) || waits) return;
  const Net drawn = now.swing.net();
  swinging_ = Swinging{Swing(drawn, shown->net, ui.now), shown->net.box(), false, ui.now, true, true};
}

void Scene::follow_swing(const UiContext& context, const std::shared_ptr<const ShownNet>& shown) {
  UiState& ui = context.ui;
  const std::optional<SwingWish> wish = std::exchange(ui.swing, std::nullopt);
  std::optional<Net> drawn;
  if (!wish && is_next_of_polish(context, shown.get())) drawn = *net();
  if (swinging_) advance_swing(context, shown);
  const bool begins = wish && shown != shown_ && shown && shown_ && shown->net.dual == shown_->net.dual;
  if (begins) {
    const Swinging began{Swing(*net(), shown->net, *wish, ui.now), net_box(), is_on_pages(), ui.now};
    swinging_ = began;
  }
  if (drawn) {
    const Net goal = laid_over(shown->net, *drawn);
    swinging_ = Swinging{Swing(*drawn, goal, ui.now), goal.box(), false, ui.now, true};
  }
  if (swinging_ && !swinging_->is_over) ui.frames_wanted = std::max(ui.frames_wanted, 2);
}

/// What the sheets show: everything that will be printed, as long as nothing of it is on the move.
void Scene::take_sheets(const UiContext& context, Renderers& renderers) {
  const UiState& ui = context.ui;
  const bool is_wanted = ui.settings.show_tabs && paged_ != nullptr && !swinging_ && !ui.editing.is_on &&
                         !ui.arranging.is_on && layout_ == context.session.pages();
  const auto sheets = is_wanted ? context.session.sheets() : nullptr;
  const PrintedSide side = context.session.project().sheet.printed_side;
  if (sheets == sheets_ && sheets == nullptr) return give_tabs(context, renderers);
  tabs_of_ = 0;
  const auto instructions = sheets == nullptr ? nullptr : context.session.instructions();
  const bool are_first = context.session.project().exports.instructions == InstructionPage::First;
  if (sheets == sheets_ && instructions == instructions_ && are_first == are_instructions_first_) return;
  sheets_ = sheets;
  instructions_ = instructions;
  are_instructions_first_ = are_first;
  ++version_;
  if (sheets_ == nullptr) return give_tabs(context, renderers);
  is_mirrored_ = side == PrintedSide::Inside;
  place();  // without what stood beside the sheets before
  std::vector<PlacedSheet> placed = place_sheets(*sheets_, *layout_, side);
  if (instructions_ != nullptr)
    placed.push_back(place_beside(*instructions_, are_instructions_first_, placed, *layout_));
  for (const PlacedSheet& sheet : placed) net_box_.add(box_of(sheet, layout_->scale));
  const std::vector<PlacedSheet> spread = spread_tiles(*sheets_, *layout_, side, placed);
  spread_box_ = Box2();
  for (const PlacedSheet& sheet : spread) spread_box_.add(box_of(sheet, layout_->scale));
  placed.insert(placed.end(), spread.begin(), spread.end());
  renderers.sheets.set_sheets(placed, layout_->scale, ++sheets_version_);
}

/// Beside the net's own drawing, wherever its faces lie.
void Scene::give_tabs(const UiContext& context, Renderers& renderers) {
  const auto pages = context.ui.settings.show_tabs ? context.session.pages() : nullptr;
  const bool is_dark = context.ui.look.colours.is_dark;
  if (tabs_of_ == version_ && tabs_layout_ == pages && is_dark_ == is_dark) return;
  if (tabs_layout_ != pages) ++version_;
  tabs_of_ = version_;
  tabs_layout_ = pages;
  is_dark_ = is_dark;
  if (shown_ == nullptr || pages == nullptr || pages->tabs.tabs.empty()) return renderers.sheets.clear();
  const Palette& colours = palette_of(context.ui);
  const Sheet tabs = draw_tabs(pages->tabs, shown_->net, *net(), pages->scale, colours);
  const PlacedSheet placed{&tabs};
  renderers.sheets.set_sheets({&placed, 1}, pages->scale, ++sheets_version_);
}

void Scene::give_net(const UiContext& context, Renderers& renderers) const {
  if (shown_ == nullptr) return;
  renderers.net.set_net(*net(), shown_->kinds, version_, !is_rough_);
  renderers.tree.set_tree(*net(), shown_->climbed, shown_->candidates, version_,
                          !is_rough_ && context.ui.settings.show_tree);
}

void Scene::notice_motion(const UiContext& context) {
  UiState& ui = context.ui;
  const std::uint64_t version = version_ + folded_.version();  // both only count up
  if (version != moved_version_) moved_at_ = ui.now;
  moved_version_ = version;
  is_rough_ = dual_ != nullptr && dual_->mesh().n_faces() >= kManyFaces && ui.now - moved_at_ < kRest_s;
  if (is_rough_) ui.frames_wanted = std::max(ui.frames_wanted, 2);
}

const ModelPicker& Scene::model_picker() const {
  model_picker_.set_model(dual_);
  model_picker_.set_pose(folded_.corners(), folded_.version());
  return model_picker_;
}

const NetPicker& Scene::net_picker() const {
  if (shown_ == nullptr)
    net_picker_.clear();
  else
    net_picker_.set_net(*net(), version_);
  return net_picker_;
}

void Scene::mark_faces(const UiContext& context) {
  states_ = FaceStates(dual_ == nullptr ? 0 : dual_->mesh().n_faces());
  if (dual_ == nullptr) return;
  const UiState& ui = context.ui;
  if (!ui.hovered_side.is_valid()) states_.add(ui.hovered, FaceState::Hovered);
  // Chosen pieces have an outline of their own.
  if (!ui.arranging.is_on)
    for (const FaceId face : ui.selected_faces) states_.add(face, FaceState::Selected);
  for (const FaceId face : ui.hovered_part_faces) states_.add(face, FaceState::Hovered);
  for (const FaceId face : ui.lit.faces) {
    states_.add(face, FaceState::Hovered);
    states_.add(face, FaceState::Selected);
  }
  const bool is_gone = shown_ == nullptr ||
                       (ui.shown_overlap && !std::binary_search(shown_->overlaps.begin(),
                                                                shown_->overlaps.end(), *ui.shown_overlap));
  if (is_gone) context.ui.shown_overlap.reset();
  if (ui.shown_overlap) {
    for (const FaceId face : {ui.shown_overlap->first, ui.shown_overlap->second}) {
      states_.add(face, FaceState::Hovered);
      states_.add(face, FaceState::Selected);
    }
  }
  if (ui.settings.show_root) {
    states_.add(context.session.project().pins.root, FaceState::Root);
    if (shown_ != nullptr) {
      for (const FaceId root : shown_->net.tree.roots()) states_.add(root, FaceState::Root);
    }
  }
  if (shown_ == nullptr) return;
  mark_heat(context, states_);
  if (ui.settings.show_overlaps && !shows_heat(context)) {
    for (std::size_t f = 0; f < shown_->is_overlapping.size(); ++f) {
      if (shown_->is_overlapping[f]) states_.add(FaceId(f), FaceState::Overlapping);
    }
  }
  mark_pieces(context);
  for (const FaceId f : shown_->climbed) states_.add(f, FaceState::Climbed);
  if (shown_->last_move) states_.add(shown_->last_move->chosen, FaceState::Chosen);
}

void Scene::mark_pieces(const UiContext& context) {
  const Arranging& arranging = context.ui.arranging;
  if (paged_ == nullptr) return;
  if (arranging.has_motion) {
    for (const FaceId f : arranging.misplaced) states_.add(f, FaceState::Overlapping);
  } else if (const Misplaced* const wrong = context.session.misplaced()) {
    for (const FaceId f : wrong->faces) states_.add(f, FaceState::Overlapping);
  }
  if (!arranging.is_on || arranging.hovered < 0) return;
  for (const FaceId f : net()->mesh().faces())
    if (net()->piece[f] == arranging.hovered) states_.add(f, FaceState::Hovered);
}

void Scene::update(const UiContext& context, Renderers& renderers) {
  const auto& dual = context.session.project().dual;
  if (dual != dual_) {
    dual_ = dual;
    ++model_version_;
    renderers.mesh.set_model(dual_);
    UiState& ui = context.ui;
    ui.hovered = FaceId();
    ui.hovered_side = HalfedgeId();
    clear_selection(ui);
    ui.folding = Folding();
    ui.measuring = Measuring();
    end_arranging(ui);
    end_tab_tool(ui);
    clear_lit(ui);
    ui.hovered_part.reset();
    ui.hovered_part_faces.clear();
  }
  if (const auto& source = context.session.project().source; source != source_) {
    source_ = source;
    ++file_version_;
  }
  if (!waits_for_pages(context)) {
    take_net(context, renderers);
    take_sheets(context, renderers);
  }
  mark_faces(context);
  take_pose(context, renderers);
  notice_motion(context);
  give_net(context, renderers);
}

void Scene::take_pose(const UiContext& context, Renderers& renderers) {
  if (dual_ == nullptr) {
    renderers.overlay.set_lines(OverlayLines());
    return;
  }
  // While another mesh is on its way, the net may still be that of the one before.
  const ShownNet* own = shown_ != nullptr && shown_->net.dual == dual_ ? shown_.get() : nullptr;
  const auto* kinds = own == nullptr ? nullptr : &own->kinds;
  const Net* drawn = own == nullptr ? nullptr : net();
  folded_.update(context.ui, own, dual_->mesh().up_axis());
  renderers.mesh.set_pose(folded_.corners(), folded_.version(), kinds, version_);
  OverlayLines lines = overlay_of(context.ui, pose(), drawn, kinds, context.session.project().pins,
                                  context.session.contradiction());
  add_excess_points(context, pose(), drawn, lines);
  add_measure(context.ui.measuring, *dual_, pose(), drawn, lines);
  if (drawn != nullptr) add_arranging(context, *drawn, lines);
  if (drawn != nullptr) add_tab_tool(context, *drawn, lines);
  renderers.overlay.set_lines(std::move(lines));
}

}  // namespace netwright
