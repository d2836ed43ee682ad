// How long nets are polished and what for: rows of the Solve section. They count from the next run on.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "assets/icons.h"
#include "ui/panels.h"
#include "ui/preferences.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr double kLongest = 600;  ///< seconds
constexpr int kMostWeight = 300;  ///< percent

struct Aim {
  const char* name;
  const char* label;
  int Settings::*weight;
  const char* tip;
};
constexpr std::array<Aim, 6> kAims{
    Aim{"cuts", "Short cuts", &Settings::aim_cuts, "Less to cut out and to glue; long folds are kept"},
    Aim{"compact", "Compact", &Settings::aim_compact, "No long thin arms; the net fills its outline"},
    Aim{"necks", "No necks", &Settings::aim_necks, "No bridges under 3 mm, where paper tears"},
    Aim{"page", "Fits one page", &Settings::aim_paper,
        "A net for one page of the chosen paper at the chosen size; \"Polish\" may take longer then"},
    Aim{"root", "Root in middle", &Settings::aim_root, "The pinned root in the middle of the net"},
    Aim{"hidden", "Hidden cuts", &Settings::aim_hidden,
        "Cuts along seams of the texture, at the bottom and in valleys"}};

bool seconds_row(UiContext& c) {
  UiState& ui = c.ui;
  ImGui::SetNextItemWidth(row(ui, "Polish") - ui.look.px(16) - ui.look.px(40));
  double seconds = ui.settings.polish_s;
  const bool is_changed = number_field(ui, "polish/seconds", seconds, seconds > 0 ? "%.0f s" : "off");
  if (is_changed) ui.settings.polish_s = static_cast<int>(std::lround(std::clamp(seconds, 0.0, kLongest)));
  tooltip(ui,
          "How long the first net is improved: fewer and shorter cuts, a compact net, no necks. 0 is not at "
          "all. Stop keeps the best so far");
  ImGui::SameLine();
  ButtonSpec weights{"polish/weights", "", icon::kTune, "What nets are improved for", ButtonKind::Outlined};
  weights.width = ui.look.px(32);
  weights.height = ImGui::GetFrameHeight();
  if (button(ui, weights)) ui.settings.shows_aims = !ui.settings.shows_aims;
  return is_changed;
}

bool weight_row(UiContext& c, const Aim& aim) {
  UiState& ui = c.ui;
  const float width = row(ui, aim.label) - ui.look.px(16) - ui.look.px(40);
  int& weight = ui.settings.*aim.weight;
  float t = static_cast<float>(weight) / kMostWeight;
  const bool is_changed = slim_slider(ui, std::string("polish/") + aim.name, width, t, aim.tip);
  if (is_changed) weight = static_cast<int>(std::lround(t * kMostWeight / 10)) * 10;
  ImGui::SameLine(0, ui.look.px(8));
  ImGui::AlignTextToFramePadding();
  text_muted(ui, weight == 0 ? "off" : std::to_string(weight) + " %");
  return is_changed;
}

}  // namespace

void panel_polish(UiContext& context) {
  UiState& ui = context.ui;
  bool is_changed = seconds_row(context);
  if (ui.settings.shows_aims && ui.settings.polish_s > 0)
    for (const Aim& aim : kAims) is_changed = weight_row(context, aim) || is_changed;
  if (is_changed) context.session.set_polish(polish_of(ui.settings));
}

}  // namespace netwright
