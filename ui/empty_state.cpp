// The empty state. The samples' pictures are drawn by the same renderer as the model's view.
#include "ui/empty_state.h"

#include <algorithm>
#include <cmath>

#include "assets/assets.h"
#include "assets/icons.h"
#include "core/base/error.h"
#include "core/mesh/dual_graph.h"
#include "core/mesh/repair.h"
#include "ui/actions.h"
#include "ui/leave.h"
#include "ui/recent_files.h"
#include "ui/samples.h"
#include "ui/status.h"
#include "ui/view_parts.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kWidest = 760;

void centred_text(const std::string& text, ImFont* font, ImU32 colour, float middle, float y) {
  const ImVec2 extent = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str());
  ImGui::GetWindowDrawList()->AddText(
      font, font->FontSize, ImVec2(std::floor(middle - extent.x / 2), std::floor(y)), colour, text.c_str());
}

/// ImGui draws no dashed frames.
void dashed_line(ImVec2 from, ImVec2 to, ImU32 colour, float dash, float width) {
  const ImVec2 way(to.x - from.x, to.y - from.y);
  const float length = std::hypot(way.x, way.y);
  for (float at = 0; at < length; at += 2 * dash) {
    const float end = std::min(at + dash, length);
    ImGui::GetWindowDrawList()->AddLine(ImVec2(from.x + way.x * at / length, from.y + way.y * at / length),
                                        ImVec2(from.x + way.x * end / length, from.y + way.y * end / length),
                                        colour, width);
  }
}

std::string format_names() {
  std::string names;
  for (const ModelFormat& format : model_formats()) {
    std::string name(format.extensions.front());
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    names += (names.empty() ? "" : " · ") + name;
  }
  return names;
}

}  // namespace

void EmptyState::drop_target(UiContext& context, ImVec2 size) {
  UiState& ui = context.ui;
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  ImGui::GetWindowDrawList()->AddRectFilled(min, max, look.colours.bar, look.px(8));
  const float dash = look.px(7);
  const float width = look.px(1.5F);
  dashed_line(min, ImVec2(max.x, min.y), look.colours.muted, dash, width);
  dashed_line(ImVec2(max.x, min.y), max, look.colours.muted, dash, width);
  dashed_line(max, ImVec2(min.x, max.y), look.colours.muted, dash, width);
  dashed_line(ImVec2(min.x, max.y), min, look.colours.muted, dash, width);
  const float middle = (min.x + max.x) / 2;
  const float top = min.y + (size.y - look.px(132)) / 2;
  centred_text("Drop a model here", look.fonts.title, look.colours.text, middle, top);
  centred_text(format_names(), look.fonts.small, look.colours.muted, middle, top + look.px(40));
  ButtonSpec open{"empty/Open", "Open a model…", icon::kOpen, tip_of(context, action(ActionId::Open)),
                  ButtonKind::Accent};
  open.height = look.px(36);
  const float button_left = std::floor(middle - button_width(ui, open) / 2);
  ImGui::SetCursorScreenPos(ImVec2(button_left, top + look.px(76)));
  if (button(ui, open)) run_action(context, ActionId::Open);
}

void EmptyState::load_one(UiState& ui) {
  if (pictures_.size() >= samples().size()) return;
  const Sample& sample = samples()[pictures_.size()];
  auto picture = std::make_unique<Picture>();
  try {
    auto prepared =
        prepare(read_soup_bytes(sample_name(sample), asset_text(sample.file), sample_companions()));
    if (prepared.is_fit()) picture->dual = std::make_shared<const DualGraph>(prepared.mesh);
  } catch (const Error&) {
    picture->dual = nullptr;  // the card stays without a picture; opening it tells what is wrong
  }
  pictures_.push_back(std::move(picture));
  ui.frames_wanted = std::max(ui.frames_wanted, 2);
}

void EmptyState::paint(const UiState& ui, Picture& picture, MeshRenderer& mesh, const Renderers& renderers,
                       glm::ivec2 size) {
  const Palette& colours = palette_of(ui);
  OrbitCamera camera;
  camera.set_size(size);
  camera.set_up_axis(picture.dual->mesh().up_axis());
  camera.reset_direction();
  frame_model(camera, picture.dual->mesh(), 0.8);
  PictureKey key;
  key.add(camera).add(ui.look.colours.is_dark);
  picture.viewport.redraw(size, key, [&] {
    renderers.background.draw_gradient(colours);
    mesh.set_model(picture.dual);
    MeshLook look;
    look.scale = ui.look.scale;
    mesh.draw(camera, colours, FaceStates(picture.dual->mesh().n_faces()), look);
  });
}

bool EmptyState::card(UiContext& context, std::size_t index, ImVec2 size, const Renderers& renderers) {
  const UiState& ui = context.ui;
  const Look& look = ui.look;
  const Sample& sample = samples()[index];
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  const std::string name = "sample/" + std::string(sample.title);
  bool is_pressed = ImGui::InvisibleButton(name.c_str(), size);
  note_widget(ui, name);
  is_pressed = pressed_by_key(ui, name) || is_pressed;
  const bool is_hovered = ImGui::IsItemHovered();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, look.colours.field, look.px(4));
  const float picture_height = size.y - look.px(32);
  if (index < pictures_.size() && pictures_[index]->dual != nullptr) {
    Picture& picture = *pictures_[index];
    const glm::ivec2 pixels(static_cast<int>(size.x), static_cast<int>(picture_height));
    paint(ui, picture, *renderers_[index], renderers, pixels);
    draw.AddImageRounded(reinterpret_cast<ImTextureID>(picture.viewport.texture()), min,
                         ImVec2(max.x, min.y + picture_height), ImVec2(0, 1), ImVec2(1, 0), IM_COL32_WHITE,
                         look.px(4), ImDrawFlags_RoundCornersTop);
    const std::string faces = grouped(static_cast<std::int64_t>(picture.dual->mesh().n_faces()));
    ImFont* font = look.fonts.small;
    const ImVec2 extent = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, faces.c_str());
    draw.AddText(font, font->FontSize,
                 ImVec2(max.x - look.px(10) - extent.x, max.y - look.px(16) - extent.y / 2),
                 look.colours.muted, faces.c_str());
  }
  draw.AddText(ImVec2(min.x + look.px(10), std::floor(max.y - look.px(16) - ImGui::GetTextLineHeight() / 2)),
               look.colours.text, std::string(sample.title).c_str());
  draw.AddRect(min, max, is_hovered ? look.colours.accent : look.colours.border, look.px(4), 0,
               is_hovered ? look.px(2) : 1);
  return is_pressed;
}

void EmptyState::sample_cards(UiContext& context, const Renderers& renderers, float width) {
  UiState& ui = context.ui;
  load_one(ui);
  while (renderers_.size() < pictures_.size())
    renderers_.push_back(std::make_unique<MeshRenderer>(renderers.lines));
  const float gap = ui.look.px(12);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  constexpr std::size_t kColumns = 3;
  const ImVec2 size(std::floor((width - gap * (kColumns - 1)) / kColumns), ui.look.px(148));
  for (std::size_t i = 0; i < samples().size(); ++i) {
    const auto column = static_cast<float>(i % kColumns);
    const std::size_t line_number = i / kColumns;
    const auto line = static_cast<float>(line_number);
    ImGui::SetCursorScreenPos(ImVec2(start.x + column * (size.x + gap), start.y + line * (size.y + gap)));
    if (card(context, i, size, renderers))
      leave(context, [i](UiContext& c) { open_sample(c.session, samples()[i]); });
  }
}

void EmptyState::recent_files(UiContext& context) {
  UiState& ui = context.ui;
  std::size_t listed = 0;
  for (const auto& file : std::vector(ui.settings.recent)) {
    if (++listed > 3) break;
    ButtonSpec spec{"recent/" + file.filename().string(), file.filename().string(), icon::kRecent,
                    file.string()};
    if (listed > 1) ImGui::SameLine();
    ImGui::PushID(file.c_str());
    if (button(ui, spec)) open_recent(context, file);
    ImGui::PopID();
  }
}

void EmptyState::draw(UiContext& context, const Renderers& renderers) {
  UiState& ui = context.ui;
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 corner = ImGui::GetWindowPos();
  const ImVec2 extent = ImGui::GetWindowSize();
  ImGui::GetWindowDrawList()->AddRectFilled(corner, ImVec2(corner.x + extent.x, corner.y + extent.y),
                                            to_u32(palette_of(ui).background_top));
  const float width = std::min(room.x - look.px(48), look.px(kWidest));
  const bool has_recent = !ui.settings.recent.empty();
  const float fixed = look.px(48) + 2 * look.px(148) + look.px(12) + (has_recent ? look.px(48) : 0);
  const float target = std::clamp(room.y - fixed - look.px(48), look.px(156), look.px(240));
  const float left = std::floor(min.x + (room.x - width) / 2);
  float y = std::floor(min.y + std::max(look.px(16), (room.y - fixed - target) / 2));
  ImGui::SetCursorScreenPos(ImVec2(left, y));
  drop_target(context, ImVec2(width, target));
  y += target + look.px(16);
  centred_text("or start with a sample", look.fonts.text, look.colours.muted, left + width / 2, y);
  y += look.px(32);
  ImGui::SetCursorScreenPos(ImVec2(left, y));
  sample_cards(context, renderers, width);
  y += 2 * look.px(148) + look.px(24);
  ImGui::SetCursorScreenPos(ImVec2(left, y));
  if (has_recent) recent_files(context);
  ImGui::Dummy(ImVec2(0, look.px(8)));
}

}  // namespace netwright
