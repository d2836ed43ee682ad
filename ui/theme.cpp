// The two palettes, the fonts with their icons, and ImGui's style variables made from them.
#include "ui/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "assets/assets.h"
#include "assets/icons.h"

namespace netwright {
namespace {

constexpr ImU32 opaque(unsigned hex) {
  return IM_COL32((hex >> 16) & 255U, (hex >> 8) & 255U, hex & 255U, 255U);
}

/// Latin with its extensions, Greek, Cyrillic, punctuation with dashes and thin spaces, arrows, mathematics.
constexpr std::array<ImWchar, 13> kTextRange{0x20,   0x24F,  0x370,  0x3FF,  0x400,  0x4FF, 0x2000,
                                             0x206F, 0x2190, 0x21FF, 0x2200, 0x22FF, 0};

/// Dear ImGui measures a font from ascender to descender; designers mean the em. Inter's ratio, from its
/// metrics.
constexpr float kInterHeightPerEm = 1.21F;

void add_icons(float size_px) {
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.MergeMode = true;
  config.OversampleH = 2;
  config.PixelSnapH = true;
  config.GlyphOffset.y = std::floor(size_px * 0.14F + 0.5F);
  config.GlyphMinAdvanceX = size_px * 1.2F;
  const auto bytes = asset(icon::kFontAsset);
  void* data = const_cast<std::byte*>(bytes.data());  // the atlas only reads it: FontDataOwnedByAtlas is off
  ImGui::GetIO().Fonts->AddFontFromMemoryTTF(data, static_cast<int>(bytes.size()), size_px * 1.2F, &config,
                                             icon::kFontRange.data());
}

ImFont* add_font(const char* name, float em_px) {
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 3;
  const auto bytes = asset(name);
  void* data = const_cast<std::byte*>(bytes.data());
  return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(data, static_cast<int>(bytes.size()),
                                                    std::round(em_px * kInterHeightPerEm), &config,
                                                    kTextRange.data());
}

/// Inter's figures have widths of their own; in a status bar that counts they would make the words dance.
void make_figures_tabular(ImFont& font) {
  float widest = 0;
  for (ImWchar c = '0'; c <= '9'; ++c) widest = std::max(widest, font.FindGlyph(c)->AdvanceX);
  for (ImFontGlyph& glyph : font.Glyphs) {
    if (glyph.Codepoint < '0' || glyph.Codepoint > '9') continue;
    const float shift = std::floor((widest - glyph.AdvanceX) / 2);
    glyph.X0 += shift;
    glyph.X1 += shift;
    glyph.AdvanceX = widest;
  }
  font.BuildLookupTable();
}

ImVec4 vec(ImU32 colour) { return ImGui::ColorConvertU32ToFloat4(colour); }

ImVec4 with_alpha(ImU32 colour, float alpha) {
  ImVec4 v = vec(colour);
  v.w = alpha;
  return v;
}

void set_text_and_fields(ImVec4* c, const Colours& look) {
  c[ImGuiCol_Text] = vec(look.text);
  c[ImGuiCol_TextDisabled] = vec(look.faint);
  c[ImGuiCol_TextSelectedBg] = with_alpha(look.accent, 0.35F);
  c[ImGuiCol_WindowBg] = vec(look.bar);
  c[ImGuiCol_MenuBarBg] = vec(look.bar);
  c[ImGuiCol_ChildBg] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_PopupBg] = vec(look.field);
  c[ImGuiCol_Border] = vec(look.border);
  c[ImGuiCol_BorderShadow] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_FrameBg] = vec(look.field);
  c[ImGuiCol_FrameBgHovered] = vec(look.hover);
  c[ImGuiCol_FrameBgActive] = vec(look.hover);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = vec(look.bar);
  c[ImGuiCol_ScrollbarBg] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_ScrollbarGrab] = vec(look.border);
  c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = vec(look.muted);
}

void set_controls(ImVec4* c, const Colours& look) {
  c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrab] = vec(look.accent);
  c[ImGuiCol_SliderGrabActive] = vec(look.accent_hover);
  c[ImGuiCol_Button] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_ButtonHovered] = vec(look.hover);
  c[ImGuiCol_ButtonActive] = vec(look.tint);
  c[ImGuiCol_Header] = vec(look.tint);
  c[ImGuiCol_HeaderHovered] = vec(look.hover);
  c[ImGuiCol_HeaderActive] = vec(look.tint);
  c[ImGuiCol_Separator] = c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = vec(look.border);
  c[ImGuiCol_NavHighlight] = vec(look.accent);
  c[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, look.is_dark ? 0.5F : 0.25F);
}

/// Lines without blanks, in small letters.
std::vector<std::string> plain_lines(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    std::transform(line.begin(), line.end(), line.begin(),
                   [](unsigned char ch) { return static_cast<char>(std::tolower(ch)); });
    line.erase(std::remove(line.begin(), line.end(), ' '), line.end());
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Of GTK 4 and GTK 3.
std::vector<std::string> desktop_settings() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  std::filesystem::path folder;
  if (config != nullptr && *config != 0) {
    folder = config;
  } else if (home != nullptr) {
    folder = std::filesystem::path(home) / ".config";
  }
  std::vector<std::string> lines = plain_lines(folder / "gtk-4.0/settings.ini");
  std::ranges::copy(plain_lines(folder / "gtk-3.0/settings.ini"), std::back_inserter(lines));
  return lines;
}

}  // namespace

Colours colours_of(bool is_dark) {
  Colours c;
  c.is_dark = is_dark;
  c.bar = opaque(is_dark ? 0x24272C : 0xF8F9FB);
  c.field = opaque(is_dark ? 0x2D3137 : 0xFFFFFF);
  c.border = opaque(is_dark ? 0x41464E : 0xCDD2D9);
  c.text = opaque(is_dark ? 0xE6E8EB : 0x1B1E23);
  c.muted = opaque(is_dark ? 0xA3A9B2 : 0x4B535D);
  c.faint = opaque(is_dark ? 0x6D737C : 0xA0A6AF);
  c.hover = opaque(is_dark ? 0x33383F : 0xE9ECF1);
  c.accent = opaque(is_dark ? 0x4C72E6 : 0x3355C8);
  c.accent_hover = opaque(is_dark ? 0x5F83F0 : 0x2846AE);
  c.on_accent = opaque(0xFFFFFF);
  c.tint = opaque(is_dark ? 0x2C3861 : 0xDFE5FA);
  c.on_tint = opaque(is_dark ? 0xAFC2FF : 0x2744AB);
  c.good = opaque(is_dark ? 0x58C98A : 0x16763F);
  c.bad = opaque(is_dark ? 0xFF7B7B : 0xB3202C);
  c.bad_back = opaque(is_dark ? 0x472A2D : 0xFBE6E6);
  return c;
}

bool desktop_prefers_dark() {
  const char* forced = std::getenv("GTK_THEME");
  if (forced != nullptr && *forced != 0) return std::string_view(forced).ends_with("dark");
  return std::ranges::any_of(desktop_settings(), [](const std::string& line) {
    return line == "gtk-application-prefer-dark-theme=1" ||
           line == "gtk-application-prefer-dark-theme=true" ||
           (line.starts_with("gtk-theme-name=") && line.ends_with("dark"));
  });
}

bool desktop_reduces_motion() {
  return std::ranges::any_of(desktop_settings(), [](const std::string& line) {
    return line == "gtk-enable-animations=0" || line == "gtk-enable-animations=false";
  });
}

Fonts load_fonts(float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  Fonts fonts;
  fonts.text = add_font("assets/fonts/Inter-Regular.otf", 15 * scale);
  add_icons(15 * scale);
  fonts.bold = add_font("assets/fonts/Inter-SemiBold.otf", 15 * scale);
  fonts.small = add_font("assets/fonts/Inter-Regular.otf", 13 * scale);
  fonts.title = add_font("assets/fonts/Inter-SemiBold.otf", 20 * scale);
  atlas.Build();
  for (ImFont* font : {fonts.text, fonts.bold, fonts.small, fonts.title}) make_figures_tabular(*font);
  return fonts;
}

void apply_style(const Look& look) {
  ImGuiStyle style;
  style.WindowPadding = ImVec2(look.px(12), look.px(8));
  style.FramePadding = ImVec2(look.px(8), look.px(6));
  style.ItemSpacing = ImVec2(look.px(8), look.px(8));
  style.ItemInnerSpacing = ImVec2(look.px(8), look.px(4));
  style.ScrollbarSize = look.px(12);
  style.GrabMinSize = look.px(12);
  style.WindowRounding = 0;
  style.FrameRounding = style.PopupRounding = style.GrabRounding = look.px(4);
  style.ScrollbarRounding = look.px(6);
  style.WindowBorderSize = 0;
  style.FrameBorderSize = style.PopupBorderSize = 1;
  style.AntiAliasedLinesUseTex = true;
  set_text_and_fields(style.Colors, look.colours);
  set_controls(style.Colors, look.colours);
  style.DisabledAlpha = 0.45F;
  ImGui::GetStyle() = style;
}

}  // namespace netwright
