// The fixed layout: menu bar, toolbar, slim progress bar, side panel, two views with a splitter, status bar.
#include "ui/workspace.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/arranging.h"
#include "ui/first_hints.h"
#include "ui/frame_parts.h"
#include "ui/messages.h"
#include "ui/panels.h"
#include "ui/replacing.h"
#include "ui/size_bar.h"
#include "ui/unrepaired_bar.h"
#include "ui/why_bar.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kToolbarHeight = 48;
constexpr float kProgressHeight = 32;
constexpr float kStatusHeight = 30;
constexpr float kSideWidth = 280;
constexpr float kLeastViews = 400;  ///< both views together; with less the side panel makes room
constexpr float kSplitterWidth = 5;
constexpr int kShiftBit = 1;
constexpr int kSpaceKey = 32;
constexpr int kEscapeKey = 256;
constexpr int kEnterKey = 257;
constexpr int kTabKey = 258;
constexpr int kRightKey = 262;
constexpr int kLeftKey = 263;
constexpr int kF1Key = 290;

constexpr auto kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                        ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                        ImGuiWindowFlags_NoBringToFrontOnFocus;

/// A part of the frame: a window without anything of a window.
template <class Content>
void area(const char* name, ImVec2 min, ImVec2 size, ImVec2 padding, bool can_scroll,
          const Content& content) {
  ImGui::SetNextWindowPos(min);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));  // the splitter is that thin
  const auto scrolling = can_scroll ? 0 : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  const bool is_visible = ImGui::Begin(name, nullptr, kFixed | scrolling);
  ImGui::PopStyleVar(2);
  if (is_visible) content();
  ImGui::End();
}

void line_at_bottom(const UiState& ui, ImVec2 min, ImVec2 size) {
  const float y = min.y + size.y - 0.5F;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRectFullScreen();
  draw.AddLine(ImVec2(min.x, y), ImVec2(min.x + size.x, y), ui.look.colours.border);
  draw.PopClipRect();
}

}  // namespace

// Tab is ours: ImGui's would go from text field to text field and pass by all else.
Workspace::Workspace() { ImGui::GetIO().KeyMap[ImGuiKey_Tab] = -1; }
Workspace::~Workspace() = default;

bool Workspace::update_look(UiState& ui, double content_scale) {
  const int percent = ui.settings.scale_percent;
  const float scale = percent == 0 ? std::clamp(static_cast<float>(content_scale), 1.0F, 3.0F)
                                   : static_cast<float>(percent) / 100;
  const bool is_dark = ui.settings.theme == ThemeChoice::Dark ||
                       (ui.settings.theme == ThemeChoice::System && ui.is_desktop_dark);
  const bool needs_fonts = ui.look.fonts.text == nullptr || scale != ui.look.scale;
  if (!needs_fonts && is_dark == ui.look.colours.is_dark) return false;
  ui.look.colours = colours_of(is_dark);
  ui.look.scale = scale;
  if (needs_fonts) ui.look.fonts = load_fonts(scale);
  apply_style(ui.look);
  return needs_fonts;
}

void Workspace::draw_splitter(UiContext& context, ImVec2 min, ImVec2 size) {
  UiState& ui = context.ui;
  const float width = ui.look.px(kSplitterWidth);
  const float x = min.x + std::floor((size.x - width) * ui.settings.splitter);
  area("##splitter", ImVec2(x, min.y), ImVec2(width, size.y), ImVec2(0, 0), false, [&] {
    ImGui::InvisibleButton("splitter", ImVec2(width, size.y));
    note_widget(ui, "splitter");
    const bool is_hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (is_hot) {
      ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
      ui.hint = "Drag shares the space · double-click halves it";
    }
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, 1)) {
      const float wanted = (ImGui::GetIO().MousePos.x - width / 2 - min.x) / std::max(size.x - width, 1.0F);
      ui.settings.splitter = std::clamp(wanted, 0.15F, 0.85F);
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) ui.settings.splitter = 0.5F;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 middle(x + width / 2, min.y + size.y / 2);
    const float half = ui.look.px(16);
    draw.AddRectFilled(ImVec2(middle.x - ui.look.px(1.5F), middle.y - half),
                       ImVec2(middle.x + ui.look.px(1.5F), middle.y + half),
                       is_hot ? ui.look.colours.accent : ui.look.colours.muted, ui.look.px(2));
  });
}

void Workspace::draw_views(UiContext& context, ImVec2 min, ImVec2 size) {
  UiState& ui = context.ui;
  if (const float bar = error_bar_height(ui, size.x); bar > 0) {
    area("##error", min, ImVec2(size.x, bar), ImVec2(0, 0), false, [&] { draw_error_bar(ui); });
    min.y += bar;
    size.y -= bar;
  }
  if (const float bar = unrepaired_bar_height(context, size.x); bar > 0) {
    area("##unrepaired", min, ImVec2(size.x, bar), ImVec2(0, 0), false,
         [&] { draw_unrepaired_bar(context); });
    min.y += bar;
    size.y -= bar;
  }
  if (const float bar = why_bar_height(context, size.x); bar > 0) {
    area("##why", min, ImVec2(size.x, bar), ImVec2(0, 0), false, [&] { draw_why_bar(context); });
    min.y += bar;
    size.y -= bar;
  }
  if (const float bar = size_bar_height(context, size.x); bar > 0) {
    area("##size", min, ImVec2(size.x, bar), ImVec2(0, 0), false, [&] { draw_size_bar(context); });
    min.y += bar;
    size.y -= bar;
  }
  if (const float strip = first_hint_height(context, size.x); strip > 0) {
    area("##hint", min, ImVec2(size.x, strip), ImVec2(0, 0), false, [&] { draw_first_hint(context); });
    min.y += strip;
    size.y -= strip;
  }
  if (!context.session.has_model()) {
    area("##empty", min, size, ImVec2(0, 0), true, [&] { empty_state_.draw(context, renderers_); });
    return;
  }
  const float splitter = ui.look.px(kSplitterWidth);
  const float left = std::floor((size.x - splitter) * ui.settings.splitter);
  area("##model", min, ImVec2(left, size.y), ImVec2(0, 0), false,
       [&] { model_view_.draw(context, scene_, renderers_); });
  area("##net", ImVec2(min.x + left + splitter, min.y), ImVec2(size.x - left - splitter, size.y),
       ImVec2(0, 0), false, [&] { net_view_.draw(context, scene_, renderers_); });
  draw_splitter(context, min, size);
}

void Workspace::draw(Session& session, UiState& ui) {
  UiContext context{session, ui};
  if (ui.widgets != nullptr) ui.widgets->begin_frame();
  const FaceId hovered_before = ui.hovered;
  const HalfedgeId side_before = ui.hovered_side;
  take_messages(context);
  watch_replacement(context);
  ui.centre_now = std::exchange(ui.wants_centre, FaceId());
  ui.flight_now = std::exchange(ui.wants_flight, {});
  follow_pages(context);
  scene_.update(context, renderers_);
  run_pictures_.tidy();
  ui.run_pictures = &run_pictures_;
  ui.focus = &focus_;
  focus_.begin_frame(dialogs_.is_open());
  if (ImGui::IsAnyMouseDown()) focus_.hide();
  if (std::exchange(has_left_field_, false)) ImGui::ClearActiveID();  // what was being typed is taken over
  // Menus and lists that drop down are gone through with the arrows.
  const bool is_dropped_down =
      ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  ImGui::GetIO().ConfigFlags = is_dropped_down ? ImGuiConfigFlags_NavEnableKeyboard : ImGuiConfigFlags_None;
  ui.hint.clear();
  ui.hovered = FaceId();
  ui.hovered_side = HalfedgeId();
  if (session.chore() == nullptr) ui.chore_since = ui.now;

  const ImVec2 window = ImGui::GetIO().DisplaySize;
  float y = draw_menu_bar(context);
  const ImVec2 bar(window.x, ui.look.px(kToolbarHeight));
  area("##toolbar", ImVec2(0, y), bar, ImVec2(ui.look.px(8), ui.look.px(8)), false, [&] {
    draw_toolbar(context);
    line_at_bottom(ui, ImVec2(0, y), bar);
  });
  y += bar.y;
  if (has_progress(context)) {
    const ImVec2 size(window.x, ui.look.px(kProgressHeight));
    area("##progress", ImVec2(0, y), size, ImVec2(0, 0), false, [&] {
      draw_progress(context);
      line_at_bottom(ui, ImVec2(0, y), size);
    });
    y += size.y;
  }
  const float bottom = window.y - ui.look.px(kStatusHeight);
  ui.has_room_for_side = window.x >= ui.look.px(kSideWidth + kLeastViews);
  const float side = ui.settings.is_side_open && ui.has_room_for_side ? ui.look.px(kSideWidth) : 0;
  if (side > 0) {
    area("##side", ImVec2(0, y), ImVec2(side, bottom - y), ImVec2(0, 0), true, [&] {
      side_panel(context);
      ImGui::GetWindowDrawList()->AddLine(ImVec2(side - 0.5F, y), ImVec2(side - 0.5F, bottom),
                                          ui.look.colours.border);
    });
  }
  if (ui.is_dragging_faces && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {  // the panel went from under it
    ui.is_dragging_faces = false;
    session.simplify_to(session.wanted_recipe().faces, false);
  }
  draw_views(context, ImVec2(side, y), ImVec2(window.x - side, bottom - y));
  area("##status", ImVec2(0, bottom), ImVec2(window.x, window.y - bottom), ImVec2(0, 0), false, [&] {
    ImGui::GetWindowDrawList()->AddLine(ImVec2(0, bottom), ImVec2(window.x, bottom), ui.look.colours.border);
    draw_status_bar(context);
  });
  draw_toasts(ui, ImVec2(window.x, bottom - ui.look.px(36)));
  dialogs_.draw(context);
  if (ui.hovered != hovered_before || ui.hovered_side != side_before)
    ui.frames_wanted = std::max(ui.frames_wanted, 2);
}

bool Workspace::focus_key(UiState& ui, int key_number, int modifiers) {
  ui.frames_wanted = std::max(ui.frames_wanted, 3);
  const bool is_shifted = modifiers == kShiftBit;
  if (key_number == kTabKey && (modifiers == 0 || is_shifted)) {
    has_left_field_ = true;
    focus_.go(is_shifted ? -1 : 1);
    return true;
  }
  if (!focus_.is_shown() || modifiers != 0 || ImGui::GetIO().WantTextInput) return false;
  if (key_number == kSpaceKey || key_number == kEnterKey) return focus_.press();
  if (key_number == kLeftKey || key_number == kRightKey)
    return focus_.slide(key_number == kRightKey ? 1 : -1);
  if (key_number != kEscapeKey || dialogs_.is_open()) return false;
  focus_.hide();
  return true;
}

void Workspace::key(Session& session, UiState& ui, int key_number, int modifiers) {
  UiContext context{session, ui};
  if (focus_key(ui, key_number, modifiers) || ImGui::GetIO().WantTextInput) return;
  if (dialogs_.is_open()) {
    if (key_number == kEscapeKey) dialogs_.cancel();
    if (key_number == kEnterKey) dialogs_.accept();
    return;
  }
  if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return;
  run_shortcut(context, {key_number, modifiers});
}

void Workspace::character(Session& session, UiState& ui, char32_t code_point) {
  if (code_point == U'?') key(session, ui, kF1Key, 0);
}

}  // namespace netwright
