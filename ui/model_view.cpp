// The model's view: its camera follows the mouse, its picture is drawn again only when something in it
// changed.
#include "ui/model_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/editing.h"
#include "ui/fold_bar.h"
#include "ui/lit.h"
#include "ui/measure.h"
#include "ui/pointing.h"
#include "ui/selection.h"
#include "ui/tab_tool.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr double kShareOfView = 0.78;  ///< what a framed model fills; some room stays for turning it
constexpr double kGrazing = 0.25;  ///< cosine; a face seen more from the side than this is turned to the eye
constexpr double kLitShare = 0.3;  ///< of the view, filled by faces that are flown to
constexpr double kLeastMagnified = 0.3;  ///< points may lie far away from the model
constexpr double kMostMagnified = 4;     ///< against the framed model, so that one still sees where one is

}  // namespace

void ModelView::follow_wishes(UiContext& context, const Scene& scene) {
  UiState& ui = context.ui;
  if (scene.dual() == nullptr) return;
  const Mesh& mesh = scene.dual()->mesh();
  const bool is_new = file_version_ != scene.file_version();
  camera_.set_up_axis(mesh.up_axis());
  if (is_new || ui.wants_home) camera_.reset_direction();
  if (is_new || ui.wants_frame_model) frame_model(camera_, mesh, kShareOfView);
  file_version_ = scene.file_version();
  ui.wants_home = ui.wants_frame_model = false;
  if (ui.centre_now.is_valid()) show_face(ui, scene.pose());
  Lit flown_to;
  flown_to.faces = ui.flight_now;
  start_flight(flown_to, scene.pose(), ui.now);
  if (std::exchange(ui.wants_lit_in_view, false)) start_flight(ui.lit, scene.pose(), ui.now);
}

void ModelView::show_face(const UiState& ui, const ModelPose& pose) {
  const glm::dvec3 centre = pose.centre(ui.centre_now);
  const glm::dvec3 normal = pose.normal(ui.centre_now);
  const bool is_turned_away = glm::dot(normal, glm::normalize(camera_.eye() - centre)) < kGrazing;
  if (!is_turned_away || !pose.is_model()) {
    camera_.centre_on(centre);
    return;
  }
  OrbitCamera goal = camera_;
  goal.look_from(normal);
  goal.centre_on(centre);
  flight_.emplace(Flight{camera_, goal, ui.now});
}

void ModelView::start_flight(const Lit& lit, const ModelPose& pose, double now) {
  const Box3 box = lit_box(lit, pose);
  if (!(box.min.x <= box.max.x)) return;
  OrbitCamera goal = camera_;
  const glm::dvec3 side = lit_side(lit, pose);
  if (glm::length(side) > 0) goal.look_from(side);
  frame_model(goal, pose.mesh(), kShareOfView);
  const double share = box.diagonal() / std::max(pose.mesh().box().diagonal(), 1e-300);
  goal.centre_on(box.centre());
  goal.zoom(std::clamp(kLitShare / std::max(share, 1e-9), kLeastMagnified, kMostMagnified),
            goal.size_px() * 0.5);
  flight_.emplace(Flight{camera_, goal, now});
}

void ModelView::fly(UiState& ui, const Gesture& gesture) {
  if (!flight_) return;
  if (gesture.drag_button >= 0 || gesture.wheel != 0) {  // the hand comes first
    flight_.reset();
    return;
  }
  const double t = ui.is_motion_reduced ? 1 : flight_share(ui.now - flight_->since);
  camera_ = t >= 1 ? flight_->to : OrbitCamera::between(flight_->from, flight_->to, t);
  if (t >= 1) flight_.reset();
  ui.frames_wanted = std::max(ui.frames_wanted, 2);
}

void ModelView::handle(UiContext& context, const Scene& scene, const Gesture& gesture) {
  UiState& ui = context.ui;
  const glm::dvec2 pointer(gesture.pointer.x, gesture.pointer.y);
  const glm::dvec2 drag(gesture.drag.x, gesture.drag.y);
  if (band_.follow(ui, gesture)) {
    select_faces(ui, faces_in_band(scene), band_.before());
    ui.hint = band_hint(ui);
    return;
  }
  if (gesture.drag_button == 0) camera_.orbit(drag);
  if (gesture.drag_button > 0) camera_.pan(drag);
  if (gesture.wheel != 0) camera_.zoom(std::pow(1.15, gesture.wheel), pointer);
  if (!gesture.is_hovered || gesture.drag_button >= 0) return;
  if (scene.dual() == nullptr || ui.folding.is_playing) return;
  const Pointed pointed = point_at(scene.model_picker(), scene.pose(), camera_, pointer, edge_reach(ui));
  if (ui.editing.is_on) {
    take_edit(context, pointed, gesture, nullptr, nullptr);
    return;
  }
  if (ui.tabbing.is_on) {
    take_tab(context, nullptr, pointed, gesture, nullptr);
    return;
  }
  if (ui.measuring.is_on) {
    const PaperPoint point =
        paper_point(pointed, *scene.dual(), scene.pose(), camera_, pointer, edge_reach(ui), !gesture.is_free);
    take_measure(context, point, gesture, scene.net());
    return;
  }
  take_pointer(context, pointed, gesture, "Drag turns · right drag moves · wheel zooms · F shows all");
}

std::vector<FaceId> ModelView::faces_in_band(const Scene& scene) const {
  std::vector<FaceId> faces;
  const ModelPose pose = scene.pose();
  for (const FaceId f : pose.mesh().faces()) {
    const glm::dvec3 middle = pose.is_model() ? face_anchor(*scene.dual(), f) : pose.centre(f);
    // Of paper that is still open both sides are seen.
    if (pose.is_model() && glm::dot(pose.normal(f), camera_.eye() - middle) <= 0) continue;
    const glm::dvec2 pixel(camera_.project(middle));
    if (band_.holds(pixel) && scene.model_picker().pick(camera_.ray(pixel)) == f) faces.push_back(f);
  }
  return faces;
}

void ModelView::paint(const UiContext& context, const Scene& scene, Renderers& renderers) {
  const UiState& ui = context.ui;
  const Palette& colours = palette_of(ui);
  renderers.background.draw_gradient(colours);
  if (scene.dual() == nullptr) return;
  MeshLook look;
  look.scale = ui.look.scale;
  look.is_seen_through = ui.settings.is_xray;
  look.shows_materials = ui.settings.show_textures;
  look.shows_folds = !scene.is_rough();
  renderers.mesh.draw(camera_, colours, scene.states(), look);
  if (scene.shown() != nullptr && scene.pose().is_model()) {
    TreeLook tree{ui.settings.show_tree, ui.settings.show_root, true, ui.look.scale, ui.settings.is_xray};
    renderers.tree.draw_on_model(camera_, colours, tree);
  }
  renderers.overlay.draw_on_model(camera_, colours, ui.look.scale);
}

void ModelView::draw_measured(const UiContext& context, const Scene& scene, ImVec2 corner) const {
  PaperPoint from;
  PaperPoint to;
  if (scene.dual() == nullptr || !measured_points(context.ui.measuring, from, to)) return;
  const glm::dvec3 a = place_in_space(*scene.dual(), scene.pose(), from);
  const glm::dvec3 b = place_in_space(*scene.dual(), scene.pose(), to);
  draw_measure_label(context, distance_on_model(*scene.dual(), from, to), glm::dvec2(camera_.project(a)),
                     glm::dvec2(camera_.project(b)), corner);
}

void ModelView::draw_axes(const UiState& ui, const Mesh& mesh, ImVec2 corner, ImVec2 size) const {
  static constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
  static constexpr std::array<ImU32, 3> kPaint{
      IM_COL32(0xC8, 0x3C, 0x3C, 255), IM_COL32(0x3A, 0x8E, 0x4A, 255), IM_COL32(0x3C, 0x62, 0xC8, 255)};
  if (mesh.n_faces() == 0) return;
  const Look& look = ui.look;
  const ImVec2 origin(corner.x + look.px(40), corner.y + size.y - look.px(40));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < 3; ++i) {
    glm::dvec3 axis(0);
    axis[static_cast<int>(i)] = 1;
    const glm::dvec2 along = camera_.screen_direction(axis);
    const auto at = [&](double length) {
      return ImVec2(origin.x + static_cast<float>(along.x * length),
                    origin.y + static_cast<float>(along.y * length));
    };
    draw.AddLine(origin, at(look.px(22)), kPaint[i], look.px(1.5F));
    ImFont* font = look.fonts.small;
    const ImVec2 extent = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, kNames[i]);
    const ImVec2 tip = at(look.px(30));
    draw.AddText(font, font->FontSize,
                 ImVec2(std::floor(tip.x - extent.x / 2), std::floor(tip.y - extent.y / 2)),
                 look.colours.muted, kNames[i]);
  }
}

void ModelView::draw(UiContext& context, const Scene& scene, Renderers& renderers) {
  UiState& ui = context.ui;
  const std::string name = scene.dual() == nullptr ? "" : scene.dual()->mesh().name();
  view_header(context, "model", "Model", {name, ""}, to_u32(palette_of(ui).background_top),
              {ActionId::ToggleXray, ActionId::ToggleTextures, ActionId::ToggleTree, ActionId::ToggleOverlaps,
               ActionId::ToggleRoot, ActionId::Frame});
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 size(room.x, room.y - fold_bar_height(ui));
  if (size.x < 1 || size.y < 1) return;
  camera_.set_size({size.x, size.y});
  follow_wishes(context, scene);
  const Gesture gesture = picture_gesture(ui, "model/picture", size);
  fly(ui, gesture);
  handle(context, scene, gesture);
  PictureKey key;
  key.add(camera_)
      .add(scene.model_version())
      .add(scene.version())
      .add(scene.pose_version())
      .add(ui.look.colours.is_dark)
      .add(ui.look.scale);
  key.add(ui.settings.show_tree).add(ui.settings.show_root).add(ui.settings.show_textures);
  key.add(ui.settings.is_xray).add(renderers.overlay.version()).add(scene.is_rough());
  key.add_bytes(scene.states().bits().data(), scene.states().size());
  renderers.model_picture.redraw({static_cast<int>(size.x), static_cast<int>(size.y)}, key,
                                 [&] { paint(context, scene, renderers); });
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const auto texture = reinterpret_cast<ImTextureID>(renderers.model_picture.texture());
  draw_list.AddImage(texture, corner, ImVec2(corner.x + size.x, corner.y + size.y), ImVec2(0, 1),
                     ImVec2(1, 0));
  band_.draw(ui, corner);
  draw_measured(context, scene, corner);
  if (scene.dual() != nullptr) draw_axes(ui, scene.dual()->mesh(), corner, size);
  ImGui::SetCursorScreenPos(ImVec2(corner.x, corner.y + size.y));
  draw_fold_bar(context);
}

}  // namespace netwright
