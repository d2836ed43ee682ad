// The controls, drawn by hand where ImGui's own would not look like the rest: buttons with an icon and a
// label, the accordion's headers, the thin slider.
#include "ui/widgets.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "assets/icons.h"
#include "ui/key_focus.h"

namespace netwright {
namespace {

constexpr float kIconGap = 8;
constexpr float kButtonPadding = 10;

ImVec2 text_size(ImFont* font, const std::string& text) {
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str(), text.c_str() + text.size());
}

struct ButtonColours {
  ImU32 back;
  ImU32 text;
  ImU32 border;
};

ButtonColours colours_for(const Colours& c, const ButtonSpec& spec, bool is_hovered, bool is_held) {
  if (spec.kind == ButtonKind::Accent && spec.is_enabled) {
    return {is_hovered ? c.accent_hover : c.accent, c.on_accent, 0};
  }
  const ImU32 text = spec.is_enabled ? c.text : c.faint;
  const ImU32 back = !spec.is_enabled ? 0 : (is_held ? c.tint : (is_hovered ? c.hover : 0));
  if (spec.kind == ButtonKind::Outlined) return {back == 0 ? c.field : back, text, c.border};
  if (spec.kind == ButtonKind::On && spec.is_enabled) return {is_held ? c.hover : c.tint, c.on_tint, 0};
  return {back, text, 0};
}

void draw_button(const UiState& ui, const ButtonSpec& spec, ImVec2 min, ImVec2 max) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ButtonColours paint =
      colours_for(ui.look.colours, spec, ImGui::IsItemHovered(), ImGui::IsItemActive());
  const float radius = ui.look.px(4);
  if (paint.back != 0) draw.AddRectFilled(min, max, paint.back, radius);
  if (paint.border != 0) draw.AddRect(min, max, paint.border, radius);
  const float icon_width = *spec.icon == 0 ? 0 : ImGui::CalcTextSize(spec.icon).x;
  const float gap = icon_width > 0 && !spec.label.empty() ? ui.look.px(kIconGap) : 0;
  const float content = icon_width + gap + ImGui::CalcTextSize(spec.label.c_str()).x;
  const float y = std::floor((min.y + max.y - ImGui::GetTextLineHeight()) / 2);
  const float x = std::floor((min.x + max.x - content) / 2);
  if (icon_width > 0) draw.AddText(ImVec2(x, y), paint.text, spec.icon);
  if (!spec.label.empty()) draw.AddText(ImVec2(x + icon_width + gap, y), paint.text, spec.label.c_str());
}

bool is_in_dialog() {
  const ImGuiWindow* window = ImGui::GetCurrentWindow();
  return (window->RootWindow->Flags & ImGuiWindowFlags_Modal) != 0;
}

bool is_next_item_enabled() {
  return (ImGui::GetCurrentContext()->CurrentItemFlags & ImGuiItemFlags_Disabled) == 0;
}

bool is_last_item_enabled() { return (ImGui::GetItemFlags() & ImGuiItemFlags_Disabled) == 0; }

/// Offers the focus to the last item and draws the ring around it. True when it has it.
bool focus_last_item(const UiState& ui, const std::string& name, KeyFocus::Kind kind) {
  if (ui.focus == nullptr || !ui.focus->offer(name, kind, is_last_item_enabled(), is_in_dialog()))
    return false;
  if (ui.focus->has_arrived(name)) ImGui::SetScrollHereY();
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  const float in = ui.look.px(1);
  ImGui::GetWindowDrawList()->AddRect(ImVec2(min.x + in, min.y + in), ImVec2(max.x - in, max.y - in),
                                      ui.look.colours.text, ui.look.px(4), 0, ui.look.px(2));
  return true;
}

/// ImGui applies what is typed at every key and forgets it when another item takes the focus; the draft keeps
/// it until the field is left.
template <class Number>
bool scalar_field(UiState& ui, const std::string& name, ImGuiDataType type, Number& value,
                  const char* format) {
  static_assert(sizeof(Number) == sizeof(ui.draft));
  Number typed = value;
  const bool is_focused = ui.focus != nullptr &&
                          ui.focus->offer(name, KeyFocus::Kind::Type, is_next_item_enabled(), is_in_dialog());
  if (is_focused && ui.focus->has_arrived(name)) {
    ImGui::SetScrollHereY();
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::InputScalar(("##" + name).c_str(), type, &typed, nullptr, nullptr, format);
  note_widget(ui, name);
  if (ImGui::IsItemActive()) ui.draft = std::bit_cast<std::uint64_t>(typed);
  if (!ImGui::IsItemDeactivatedAfterEdit()) return false;
  if (typed == value) typed = std::bit_cast<Number>(ui.draft);
  const bool is_new = typed != value;
  value = typed;
  return is_new;
}

/// Below the last item, or above where the window ends, so that its neighbours stay in sight.
ImVec2 place_of_tooltip(const UiState& ui, ImVec2 size) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const ImVec2 min = ImGui::GetItemRectMin();
  const float gap = ui.look.px(6);
  const float below = ImGui::GetItemRectMax().y + gap;
  const float y = below + size.y <= window.y ? below : min.y - gap - size.y;
  return {std::floor(std::clamp(min.x, 0.0F, std::max(0.0F, window.x - size.x - gap))), std::floor(y)};
}

}  // namespace

void note_widget(const UiState& ui, const std::string& name) {
  if (ui.widgets == nullptr) return;
  const bool is_enabled = (ImGui::GetItemFlags() & ImGuiItemFlags_Disabled) == 0;
  ui.widgets->note(name, {ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), is_enabled});
}

bool pressed_by_key(const UiState& ui, const std::string& name) {
  return focus_last_item(ui, name, KeyFocus::Kind::Press) && ui.focus->take_press(name);
}

void tooltip(const UiState& ui, const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  const ImVec2 padding(ui.look.px(10), ui.look.px(6));
  const float wrap = ui.look.px(320);
  const ImVec2 extent = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap - padding.x);
  ImGui::SetNextWindowPos(place_of_tooltip(ui, {extent.x + 2 * padding.x, extent.y + 2 * padding.y}));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(wrap);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

float button_width(const UiState& ui, const ButtonSpec& spec) {
  if (spec.width > 0) return spec.width;
  if (spec.label.empty()) return ui.look.px(32);
  const float icon = *spec.icon == 0 ? 0 : ImGui::CalcTextSize(spec.icon).x + ui.look.px(kIconGap);
  return std::ceil(icon + ImGui::CalcTextSize(spec.label.c_str()).x + 2 * ui.look.px(kButtonPadding));
}

bool button(const UiState& ui, const ButtonSpec& wanted) {
  ButtonSpec spec = wanted;
  spec.is_enabled = spec.is_enabled && is_next_item_enabled();  // whoever draws it may disable a whole row
  const ImVec2 size(button_width(ui, spec), spec.height > 0 ? spec.height : ui.look.px(32));
  if (!spec.is_enabled) ImGui::BeginDisabled();
  bool is_pressed = ImGui::InvisibleButton(spec.name.c_str(), size);
  draw_button(ui, spec, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  note_widget(ui, spec.name);
  is_pressed = pressed_by_key(ui, spec.name) || is_pressed;
  if (!spec.is_enabled) ImGui::EndDisabled();
  tooltip(ui, spec.tip);
  return is_pressed && spec.is_enabled;
}

bool section_header(const UiState& ui, const std::string& title, const std::string& summary, bool is_open) {
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, look.px(36));
  bool is_clicked = ImGui::InvisibleButton(("section/" + title).c_str(), size);
  note_widget(ui, "section/" + title);
  is_clicked = pressed_by_key(ui, "section/" + title) || is_clicked;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  if (ImGui::IsItemHovered()) draw.AddRectFilled(min, max, look.colours.hover);
  const float y = std::floor(min.y + (size.y - ImGui::GetTextLineHeight()) / 2);
  draw.AddText(ImVec2(min.x + look.px(8), y), look.colours.muted,
               is_open ? icon::kChevronDown : icon::kChevronRight);
  draw.AddText(look.fonts.bold, look.fonts.bold->FontSize, ImVec2(min.x + look.px(32), y), look.colours.text,
               title.c_str());
  const float title_width = text_size(look.fonts.bold, title).x;
  const std::string fitting = shortened(summary, size.x - look.px(64) - title_width);
  const ImVec2 extent = text_size(look.fonts.small, fitting);
  draw.AddText(look.fonts.small, look.fonts.small->FontSize,
               ImVec2(max.x - look.px(16) - extent.x, std::floor(min.y + (size.y - extent.y) / 2)),
               look.colours.muted, fitting.c_str());
  return is_clicked;
}

float row(const UiState& ui, const char* label) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  ImGui::SameLine(ui.look.px(120));
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::SetNextItemWidth(width);
  return width;
}

bool slim_slider(const UiState& ui, const std::string& name, float width, float& t, const std::string& tip,
                 bool is_enabled) {
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  if (!is_enabled) ImGui::BeginDisabled();
  ImGui::InvisibleButton(name.c_str(), ImVec2(width, look.px(32)));
  note_widget(ui, name);
  if (!is_enabled) ImGui::EndDisabled();
  const float radius = look.px(7);
  const float left = min.x + radius;
  const float length = width - 2 * radius;
  bool is_changed = false;
  if (ImGui::IsItemActive()) {
    const float wanted = std::clamp((ImGui::GetIO().MousePos.x - left) / length, 0.0F, 1.0F);
    is_changed = wanted != t;
    t = wanted;
  }
  if (focus_last_item(ui, name, KeyFocus::Kind::Slide)) {
    constexpr float kStep = 0.05F;
    const float wanted = std::clamp(t + kStep * static_cast<float>(ui.focus->take_steps(name)), 0.0F, 1.0F);
    is_changed = is_changed || wanted != t;
    t = wanted;
  }
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float y = std::floor(min.y + look.px(16));
  const float x = left + t * length;
  const float thick = look.px(2);
  const Colours& c = look.colours;
  draw.AddRectFilled(ImVec2(left, y - thick), ImVec2(left + length, y + thick), c.border, thick);
  draw.AddRectFilled(ImVec2(left, y - thick), ImVec2(x, y + thick), is_enabled ? c.accent : c.border, thick);
  const bool is_hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
  const ImU32 knob = is_hot ? c.accent_hover : c.accent;
  draw.AddCircleFilled(ImVec2(x, y), radius, is_enabled ? knob : c.faint, 24);
  draw.AddCircle(ImVec2(x, y), radius - look.px(2), c.bar, 24, look.px(1.5F));
  tooltip(ui, tip);
  return is_changed;
}

bool checkbox(const UiState& ui, const std::string& name, const std::string& label, bool& is_on,
              const std::string& tip) {
  const Look& look = ui.look;
  const Colours& c = look.colours;
  const float side = look.px(18);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float text_left = side + look.px(8);
  const ImVec2 size(text_left + ImGui::CalcTextSize(label.c_str()).x, look.px(28));
  bool is_clicked = ImGui::InvisibleButton(name.c_str(), size);
  note_widget(ui, name);
  is_clicked = pressed_by_key(ui, name) || is_clicked;
  tooltip(ui, tip);
  if (is_clicked) is_on = !is_on;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 box(min.x, std::floor(min.y + (size.y - side) / 2));
  const ImVec2 end(box.x + side, box.y + side);
  const bool is_hot = ImGui::IsItemHovered();
  draw.AddRectFilled(box, end, is_on ? (is_hot ? c.accent_hover : c.accent) : c.field, look.px(4));
  if (!is_on) draw.AddRect(box, end, is_hot ? c.accent : c.muted, look.px(4));
  if (is_on) {
    const ImVec2 sign = ImGui::CalcTextSize(icon::kDone);
    draw.AddText(ImVec2(std::floor(box.x + (side - sign.x) / 2), std::floor(box.y + (side - sign.y) / 2)),
                 c.on_accent, icon::kDone);
  }
  const float y = std::floor(min.y + (size.y - ImGui::GetTextLineHeight()) / 2);
  draw.AddText(ImVec2(min.x + text_left, y), c.text, label.c_str());
  return is_clicked;
}

void bar_background(const UiState& ui, const char* icon, const std::string& text, float wrap_width) {
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  const float top = min.y + look.px(kBarPadding);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, look.colours.tint);
  draw.AddRectFilled(min, ImVec2(min.x + look.px(4), max.y), look.colours.accent);
  draw.AddText(ImVec2(min.x + look.px(16), top), look.colours.on_tint, icon);
  draw.AddText(nullptr, 0, ImVec2(min.x + look.px(kBarTextLeft), top), look.colours.text, text.c_str(),
               nullptr, wrap_width);
}

void progress_line(const UiState& ui, float width, double fraction) {
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float thick = look.px(4);
  const float at = width * static_cast<float>(std::clamp(fraction, 0.0, 1.0));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, ImVec2(min.x + width, min.y + thick), look.colours.border, thick / 2);
  draw.AddRectFilled(min, ImVec2(min.x + at, min.y + thick), look.colours.accent, thick / 2);
  ImGui::Dummy(ImVec2(width, thick));
}

bool segments(const UiState& ui, const std::string& name, float width, const std::vector<std::string>& labels,
              int& chosen) {
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float height = ui.look.px(30);
  const float each = std::floor(width / static_cast<float>(labels.size()));
  bool is_changed = false;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(start, ImVec2(start.x + width, start.y + height), ui.look.colours.field, ui.look.px(4));
  for (int i = 0; i < static_cast<int>(labels.size()); ++i) {
    const std::string& label = labels[static_cast<std::size_t>(i)];
    if (i > 0) ImGui::SameLine(0, 0);
    ButtonSpec spec{name, label};
    spec.name.append("/").append(label);
    spec.kind = i == chosen ? ButtonKind::On : ButtonKind::Plain;
    spec.width = i + 1 == static_cast<int>(labels.size()) ? width - each * static_cast<float>(i) : each;
    spec.height = height;
    if (button(ui, spec) && i != chosen) {
      chosen = i;
      is_changed = true;
    }
  }
  draw.AddRect(start, ImVec2(start.x + width, start.y + height), ui.look.colours.border, ui.look.px(4));
  return is_changed;
}

bool number_field(UiState& ui, const std::string& name, double& value, const char* format) {
  return scalar_field(ui, name, ImGuiDataType_Double, value, format);
}

bool number_field(UiState& ui, const std::string& name, std::uint64_t& value) {
  return scalar_field(ui, name, ImGuiDataType_U64, value, nullptr);
}

bool length_field(UiState& ui, const std::string& name, double& millimetres) {
  const double unit = in_millimetres(ui.settings.unit);
  double shown = millimetres / unit;
  if (!number_field(ui, name, shown, field_format(ui.settings.unit))) return false;
  millimetres = shown * unit;
  return true;
}

bool text_field(UiState& ui, const std::string& name, std::string& words, const char* hint) {
  const bool is_focused = ui.focus != nullptr &&
                          ui.focus->offer(name, KeyFocus::Kind::Type, is_next_item_enabled(), is_in_dialog());
  if (is_focused && ui.focus->has_arrived(name)) {
    ImGui::SetScrollHereY();
    ImGui::SetKeyboardFocusHere();
  }
  std::string typed = words;
  ImGui::InputTextWithHint(("##" + name).c_str(), hint, &typed);
  note_widget(ui, name);
  if (ImGui::IsItemActive()) ui.draft_words = typed;
  if (!ImGui::IsItemDeactivatedAfterEdit()) return false;
  if (typed == words) typed = ui.draft_words;
  const bool is_new = typed != words;
  words = typed;
  return is_new;
}

bool more_header(const UiState& ui, const std::string& name, bool& is_open) {
  ButtonSpec spec{name, is_open ? "Less" : "More", is_open ? icon::kChevronUp : icon::kChevronDown};
  spec.height = ui.look.px(28);
  if (button(ui, spec)) is_open = !is_open;
  return is_open;
}

bool begin_combo(const UiState& ui, const std::string& name, const std::string& shown) {
  const float room = ImGui::CalcItemWidth() - ImGui::GetStyle().FramePadding.x - ui.look.px(30);
  const bool is_open = ImGui::BeginCombo(("##" + name).c_str(), shortened(shown, room).c_str(),
                                         ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLargest);
  note_widget(ui, name);
  if (is_open) return true;
  if (pressed_by_key(ui, name)) ImGui::OpenPopupEx(ImHashStr("##ComboPopup", 0, ImGui::GetItemID()));
  // Over the right end, lighter than ImGui's own triangle.
  const ImVec2 max = ImGui::GetItemRectMax();
  const float y = (ImGui::GetItemRectMin().y + max.y - ImGui::GetTextLineHeight()) / 2;
  ImGui::GetWindowDrawList()->AddText(ImVec2(max.x - ui.look.px(28), y), ui.look.colours.muted,
                                      icon::kChevronDown);
  return false;
}

void text_muted(const UiState& ui, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ui.look.colours.muted);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

void text_small(const UiState& ui, const std::string& text) {
  ImGui::PushFont(ui.look.fonts.small);
  text_muted(ui, text);
  ImGui::PopFont();
}

std::string shortened(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  std::string cut = text;
  while (!cut.empty() && ImGui::CalcTextSize((cut + "…").c_str()).x > width) {
    // Whole characters: continuation bytes of UTF-8 go with their first byte.
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0U) == 0x80U) cut.pop_back();
    if (!cut.empty()) cut.pop_back();
  }
  return cut + "…";
}

}  // namespace netwright
