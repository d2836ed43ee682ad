// Three buttons, a slider over all moves, where one is, and how fast it plays.
#include "ui/timeline.h"

#include <algorithm>
#include <cmath>

#include "assets/icons.h"
#include "ui/actions.h"
#include "ui/run_actions.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kHeight = 40;
constexpr float kSpeedWidth = 72;
constexpr float kNarrow = 460;  ///< without the speed slider

double fastest(int n_steps) { return std::max(30.0, n_steps / 2.0); }

void icon_button(UiContext& c, ActionId id, const char* name, const char* sign) {
  const Action& wanted = action(id);
  ButtonSpec spec{name, "", sign, label_of(c, wanted) + ": " + tip_of(c, wanted)};
  spec.is_enabled = is_possible(c, id);
  if (button(c.ui, spec)) run_action(c, id);
  ImGui::SameLine(0, 0);
}

/// The words about the position, and the widest they can get, so that the slider keeps its length.
struct Words {
  std::string text;
  float room = 0;
};

/// As much as leaves the slider some room; the overlaps stand in the view's header, too.
Words words_for(const UiContext& c, const Session::Timeline& line, float room) {
  const std::string last = grouped(line.n_steps - 1);
  const std::string overlaps = counted(c.session.figures().overlaps, "overlap", "overlaps");
  const std::string at = grouped(line.position) + " of " + last;
  const float gap = c.ui.look.px(16);
  const float least = c.ui.look.px(120);
  const float all = ImGui::CalcTextSize((last + " of " + last + " · 8 888 overlaps").c_str()).x + gap;
  if (room - all >= least) return {at + " · " + overlaps, all};
  const float some = ImGui::CalcTextSize((last + " of " + last).c_str()).x + gap;
  return room - some >= least ? Words{at, some} : Words{};
}

void speed_slider(UiContext& c, const Session::Timeline& line, ImVec2 at) {
  ImGui::SetCursorScreenPos(at);
  auto t = static_cast<float>(slider_of_play_speed(line.speed, line.n_steps));
  const std::string tip = "How fast the moves play: " + speed_text(line.speed);
  if (slim_slider(c.ui, "timeline/speed", c.ui.look.px(kSpeedWidth), t, tip))
    c.session.set_play_speed(play_speed_of_slider(t, line.n_steps));
}

}  // namespace

double play_speed_of_slider(double t, int n_steps) {
  return std::pow(fastest(n_steps), std::clamp(t, 0.0, 1.0));
}

double slider_of_play_speed(double moves_per_second, int n_steps) {
  return std::clamp(std::log(std::max(moves_per_second, 1.0)) / std::log(fastest(n_steps)), 0.0, 1.0);
}

float timeline_height(const UiContext& context) {
  return context.session.timeline() ? context.ui.look.px(kHeight) : 0;
}

void draw_timeline(UiContext& context) {
  const auto line = context.session.timeline();
  if (!line) return;
  UiState& ui = context.ui;
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, look.px(kHeight));
  const ImVec2 max(min.x + size.x, min.y + size.y);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, look.colours.bar);
  draw.AddLine(min, ImVec2(max.x, min.y), look.colours.border);
  ImGui::SetCursorScreenPos(ImVec2(min.x + look.px(8), min.y + look.px(4)));
  icon_button(context, ActionId::MoveBack, "timeline/back", icon::kStepBack);
  icon_button(context, ActionId::PlayMoves, "timeline/play", line->is_playing ? icon::kPause : icon::kPlay);
  icon_button(context, ActionId::MoveOn, "timeline/on", icon::kStep);
  const float left = min.x + look.px(8) + 3 * look.px(32) + look.px(8);
  const bool has_speed = size.x >= look.px(kNarrow);
  const float speed_room = has_speed ? look.px(kSpeedWidth + 32) + look.px(8) : 0;
  const float room = max.x - look.px(12) - speed_room - left;
  const Words words = words_for(context, *line, room);
  const float width = room - words.room;
  ImGui::SetCursorScreenPos(ImVec2(left, min.y + look.px(4)));
  auto t = static_cast<float>(line->position) / static_cast<float>(std::max(line->n_steps - 1, 1));
  if (width > look.px(40) && slim_slider(ui, "timeline/slider", width, t, "")) {
    context.session.hold();
    context.session.seek(static_cast<int>(std::lround(t * static_cast<float>(line->n_steps - 1))));
  }
  const float y = std::floor((min.y + max.y - ImGui::GetTextLineHeight()) / 2);
  draw.AddText(ImVec2(left + width + look.px(12), y), look.colours.muted, words.text.c_str());
  if (!has_speed) return;
  const float speed_left = max.x - look.px(12) - look.px(kSpeedWidth);
  draw.AddText(ImVec2(speed_left - look.px(24), y), look.colours.muted, icon::kSpeed);
  speed_slider(context, *line, ImVec2(speed_left, min.y + look.px(4)));
}

}  // namespace netwright
