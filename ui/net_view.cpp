// The net's view. As long as the user has not moved the camera it keeps the whole net in sight.
#include "ui/net_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "assets/icons.h"
#include "ui/arranging.h"
#include "ui/editing.h"
#include "ui/legend.h"
#include "ui/measure.h"
#include "ui/net_numbers.h"
#include "ui/pointing.h"
#include "ui/selection.h"
#include "ui/status.h"
#include "ui/tab_tool.h"
#include "ui/timeline.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr double kFlownToShare = 0.3;  ///< of the view, filled by faces that are flown to
constexpr double kMostMagnified = 12;  ///< against the framed net, so that one still sees where one is
constexpr double kSoon_s = 0.3;        ///< what is done sooner need not be told
constexpr double kTooSmall = 0.55;     ///< a net that fills less of the view than this is framed again

/// While a search runs the net changes size at every move; following each would make the picture tremble.
bool needs_framing(const PanZoomCamera& camera, const Box2& box) {
  const Box2 seen = camera.visible();
  const bool is_outside =
      box.min.x < seen.min.x || box.min.y < seen.min.y || box.max.x > seen.max.x || box.max.y > seen.max.y;
  const glm::dvec2 share = box.size() / seen.size();
  return is_outside || std::max(share.x, share.y) < kTooSmall;
}

/// At the top left of the desk.
void draw_note(const UiState& ui, const char* text, ImVec2 corner) {
  const ImFont* font = ui.look.fonts.small;
  const ImVec2 at(corner.x + ui.look.px(16), corner.y + ui.look.px(4));
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, at, ui.look.colours.text, text);
}

/// An empty desk says what will lie on it.
void draw_empty_desk(const UiState& ui, const ImVec2& corner, const ImVec2& size) {
  const std::string text = shortened("Press Space: the net will be found here", size.x - ui.look.px(32));
  const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
  const ImVec2 at(std::floor(corner.x + (size.x - extent.x) / 2),
                  std::floor(corner.y + (size.y - extent.y) / 2));
  ImGui::GetWindowDrawList()->AddText(at, ui.look.colours.text, text.c_str());
}

}  // namespace

void NetView::follow_net(UiContext& context, const Scene& scene) {
  UiState& ui = context.ui;
  const Net* net = scene.net();
  if (file_version_ != scene.file_version()) is_moved_by_user_ = shows_desk_ = false;
  file_version_ = scene.file_version();
  const bool is_asked = ui.wants_frame_net;
  ui.wants_frame_net = false;
  if (is_asked) {
    is_moved_by_user_ = false;
    shows_desk_ = std::exchange(ui.wants_frame_desk, false);
  }
  if (net == nullptr) return;
  const bool is_laid_anew = was_on_pages_ != scene.is_on_pages() || model_version_ != scene.model_version();
  const bool is_new = version_ != scene.version();
  model_version_ = scene.model_version();
  version_ = scene.version();
  was_on_pages_ = scene.is_on_pages();
  const auto line = context.session.timeline();
  const bool is_moving = line && line->position != line->home;
  const bool is_resting = context.session.state() == RunState::Idle && !is_moving;
  // Under a hand that arranges pieces the desk holds still.
  const bool is_framed = shows_desk_ || !needs_framing(flight_ ? flight_->to : camera_, scene.net_box());
  const bool follows =
      !is_arranging(context, scene) && (!is_framed || (is_new && is_resting && !scene.is_gliding()));
  const bool is_due = is_asked || is_laid_anew || follows;
  if (is_due && !is_moved_by_user_) {
    PanZoomCamera framed = camera_;
    framed.frame(shows_desk_ ? scene.desk_box() : scene.net_box(), ui.look.px(24));
    // With a net that glides the view does, too.
    const bool is_jump = is_asked || is_laid_anew || !scene.is_gliding();
    flight_.reset();
    if (is_jump)
      camera_ = framed;
    else
      flight_.emplace(Flight{camera_, framed, ui.now});
  }
  if (!ui.flight_now.empty()) start_flight(ui.flight_now, *net, ui.now);
  if (!ui.centre_now.is_valid()) return;
  camera_.centre_on(net->box(ui.centre_now).centre());
  is_moved_by_user_ = true;
}

void NetView::start_flight(const std::vector<FaceId>& faces, const Net& net, double now) {
  Box2 box;
  for (const FaceId f : faces) box.add(net.box(f));
  PanZoomCamera goal = camera_;
  goal.approach(box, kFlownToShare, kMostMagnified);
  flight_.emplace(Flight{camera_, goal, now});
  is_moved_by_user_ = true;
}

void NetView::fly(UiState& ui, const Gesture& gesture) {
  if (!flight_) return;
  if (gesture.drag_button >= 0 || gesture.wheel != 0) {  // the hand comes first
    flight_.reset();
    return;
  }
  const double t = ui.is_motion_reduced ? 1 : flight_share(ui.now - flight_->since);
  camera_ = t >= 1 ? flight_->to : PanZoomCamera::between(flight_->from, flight_->to, t);
  camera_.set_size(flight_->to.size_px());
  if (t >= 1) flight_.reset();
  ui.frames_wanted = std::max(ui.frames_wanted, 2);
}

void NetView::handle(UiContext& context, const Scene& scene, const Gesture& gesture) {
  UiState& ui = context.ui;
  if (scene.net() == nullptr) return;
  const glm::dvec2 pointer(gesture.pointer.x, gesture.pointer.y);
  if (scene.is_swinging()) return;  // what is seen lies elsewhere in a moment
  const Pointed pointed = gesture.is_hovered
                              ? point_at(scene.net_picker(), *scene.net(), camera_, pointer, edge_reach(ui))
                              : Pointed();
  const bool arranges = is_arranging(context, scene);
  if (band_.follow(ui, arranges ? with_band(context, scene, pointed, gesture, camera_) : gesture)) {
    select_faces(ui, faces_in_band(*scene.net()), band_.before());
    if (arranges) select_whole_pieces(context);
    ui.hint = arranges ? pieces_hint(context) : band_hint(ui);
    return;
  }
  if (gesture.is_pressed)
    is_panning_ = !arranges && !is_at_tab(context) && !pointed.face.is_valid() && !pointed.side.is_valid();
  if (gesture.drag_button > 0 || (gesture.drag_button == 0 && is_panning_)) {
    camera_.pan({gesture.drag.x, gesture.drag.y});
    is_moved_by_user_ = true;
  }
  if (gesture.wheel != 0) {
    camera_.zoom(std::pow(1.15, gesture.wheel), pointer);
    is_moved_by_user_ = true;
  }
  if (arranges) {
    take_arrange(context, scene, pointed, gesture, camera_);
    return;
  }
  if (ui.editing.is_on && (gesture.is_hovered || ui.editing.branch.is_valid())) {
    const glm::dvec2 at = camera_.to_world(pointer);
    take_edit(context, pointed, gesture, scene.net(), &at);
    return;
  }
  if (ui.tabbing.is_on) {
    if (gesture.is_hovered || ui.tabbing.is_dragging) take_tab(context, &scene, pointed, gesture, &camera_);
    return;
  }
  if (!gesture.is_hovered || gesture.drag_button >= 0) return;
  if (ui.measuring.is_on) {
    const PaperPoint point =
        paper_point(pointed, *scene.net(), camera_, pointer, edge_reach(ui), !gesture.is_free);
    take_measure(context, point, gesture, scene.net());
    return;
  }
  take_pointer(context, pointed, gesture, "Drag moves · wheel zooms · F shows all");
}

std::vector<FaceId> NetView::faces_in_band(const Net& net) const {
  std::vector<FaceId> faces;
  for (const FaceId f : net.mesh().faces()) {
    if (band_.holds(camera_.to_pixel(face_anchor(net, f)))) faces.push_back(f);
  }
  return faces;
}

void NetView::tell_of_pages(const UiContext& context, const Scene& scene, ImVec2 corner) {
  UiState& ui = context.ui;
  const bool is_waiting = ui.settings.show_pages && scene.net() != nullptr && !scene.is_on_pages() &&
                          context.session.is_laying_out() && context.session.state() == RunState::Idle;
  if (!is_waiting) return laying_since_.reset();
  if (!laying_since_) laying_since_ = ui.now;
  ui.frames_wanted = std::max(ui.frames_wanted, 2);
  if (ui.now - *laying_since_ >= kSoon_s) draw_note(ui, "Laying out the pages…", corner);
}

void NetView::show_numbers(const UiState& ui, const Scene& scene, ImVec2 corner) {
  n_numbers_ = draw_numbers(ui, *scene.net(), scene.shown()->kinds, camera_, corner);
  if (n_numbers_ > 0) return;
  draw_note(ui, "Zoom in to read the numbers", corner);
}

void NetView::draw_measured(const UiContext& context, const Scene& scene, ImVec2 corner) const {
  PaperPoint from;
  PaperPoint to;
  const Net* net = scene.net();
  if (net == nullptr || !measured_points(context.ui.measuring, from, to)) return;
  if (net->piece[from.face] != net->piece[to.face]) return;
  const glm::dvec2 a = place_in_net(*net, from);
  const glm::dvec2 b = place_in_net(*net, to);
  draw_measure_label(context, glm::distance(a, b), camera_.to_pixel(a), camera_.to_pixel(b), corner);
}

void NetView::paint(const UiContext& context, const Scene& scene, Renderers& renderers) {
  const UiState& ui = context.ui;
  const Palette& colours = palette_of(ui);
  Background::clear_desk(colours);
  if (scene.net() == nullptr) return;
  NetLook look;
  look.scale = ui.look.scale;
  look.shows_folds = !scene.is_rough();
  look.is_printed = scene.is_net_on_paper();
  renderers.net.draw_sheets(camera_, colours, look);
  look.draws_sheets = false;
  renderers.sheets.draw(camera_, colours, ui.look.scale);
  renderers.net.draw(camera_, colours, scene.states(), look);
  TreeLook tree{ui.settings.show_tree, ui.settings.show_root, true, ui.look.scale};
  // On the printed page it would hide the numbers.
  if (!look.is_printed) renderers.tree.draw_on_net(camera_, colours, tree);
  renderers.overlay.draw_on_net(camera_, colours, ui.look.scale);
}

void NetView::draw(UiContext& context, const Scene& scene, Renderers& renderers) {
  UiState& ui = context.ui;
  const std::string state = scene.net() == nullptr ? "" : status_of(context.session).in_short;
  // Of "one piece, proved" the last is what matters most.
  const std::size_t comma = state.rfind(", ");
  const std::string brief = comma == std::string::npos ? "" : state.substr(comma + 2);
  HeaderState says{state, brief};
  if (scene.is_net_on_paper()) {
    says.idle = ActionId::ToggleTree;
    says.why_idle = "The tree is not printed. Without tabs (B) or pages (P) the net shows it.";
  }
  view_header(context, "net", "Net", says, to_u32(palette_of(ui).desk),
              {ActionId::ToggleNumbers, ActionId::ToggleTree, ActionId::ToggleOverlaps, ActionId::ToggleRoot,
               ActionId::TogglePages, ActionId::ToggleTabs, ActionId::Frame});
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 size(room.x, room.y - legend_height(ui) - timeline_height(context));
  if (size.x < 1 || size.y < 1) return;
  camera_.set_size({size.x, size.y});
  follow_net(context, scene);
  const Gesture gesture = picture_gesture(ui, "net/picture", size);
  fly(ui, gesture);
  handle(context, scene, gesture);
  PictureKey key;
  key.add(camera_).add(scene.version()).add(ui.look.colours.is_dark).add(ui.look.scale);
  key.add(ui.settings.show_tree).add(ui.settings.show_root).add(renderers.overlay.version());
  key.add(scene.is_rough());
  key.add_bytes(scene.states().bits().data(), scene.states().size());
  renderers.net_picture.redraw({static_cast<int>(size.x), static_cast<int>(size.y)}, key,
                               [&] { paint(context, scene, renderers); });
  const auto texture = reinterpret_cast<ImTextureID>(renderers.net_picture.texture());
  ImGui::GetWindowDrawList()->AddImage(texture, corner, ImVec2(corner.x + size.x, corner.y + size.y),
                                       ImVec2(0, 1), ImVec2(1, 0));
  if (ui.settings.show_numbers && scene.net() != nullptr) show_numbers(ui, scene, corner);
  tell_of_pages(context, scene, corner);
  draw_arranging(context, scene, camera_, corner);
  band_.draw(ui, corner);
  draw_measured(context, scene, corner);
  if (scene.net() == nullptr && context.session.state() == RunState::Idle) draw_empty_desk(ui, corner, size);
  ImGui::SetCursorScreenPos(ImVec2(corner.x, corner.y + size.y));
  draw_timeline(context);
  ImGui::SetCursorScreenPos(ImVec2(corner.x, corner.y + size.y + timeline_height(context)));
  draw_legend(context, scene.shown().get(), scene.is_net_on_paper());
}

}  // namespace netwright
