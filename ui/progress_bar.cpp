// The slim bar under the toolbar: what is going on, how far it is, and the way out.
#include <algorithm>
#include <cmath>
#include <string>

#include "ui/actions.h"
#include "ui/frame_parts.h"
#include "ui/panels.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr double kSoonOver = 0.6;  ///< seconds; a bar that only flashes up would unsettle

struct Work {
  std::string what;
  std::string detail;
  std::string left;  ///< right of the bar
  double fraction = 0;
  bool can_stop = false;
};

Work search_work(const UiContext& c) {
  const RunFigures figures = c.session.figures();
  Work work{c.session.state() == RunState::Paused ? "Paused" : "Unfolding", "", "", 0, true};
  if (!figures.polish_costs.empty()) {
    if (c.session.state() != RunState::Paused) work.what = "Polishing";
    work.detail = polish_shares(figures);
    work.fraction = figures.polish_fraction;
    work.left = "Stop keeps the best net so far";
    return work;
  }
  work.detail = "move " + grouped(figures.moves);
  const int most = std::max(figures.overlaps_at_start, 1);
  const int gone = std::max(most - figures.overlaps, 0);
  work.fraction = static_cast<double>(gone) / most;
  work.left = grouped(gone) + " of " + counted(figures.overlaps_at_start, "overlap", "overlaps") + " gone";
  if (c.session.time_limit() > 0 && c.session.state() == RunState::Running) {
    const double seconds = std::max(c.session.time_limit() - figures.seconds, 0.0);
    work.left += " · at most " + duration_text(std::ceil(seconds)) + " left";
  }
  return work;
}

void watch_phase(UiContext& c) {
  const auto chore = c.session.chore();
  const std::string phase = chore == nullptr ? "" : chore->phase();
  if (phase == c.ui.chore_phase) return;
  c.ui.chore_phase = phase;
  c.ui.chore_phase_since = c.ui.now;
}

bool is_searching(const UiContext& c) {
  const RunState state = c.session.state();
  return state == RunState::Running || state == RunState::Paused;
}

}  // namespace

bool has_progress(const UiContext& context) {
  if (context.ui.is_dragging_faces) return false;  // the slider has a bar of its own
  if (is_searching(context)) {
    return context.session.state() == RunState::Paused || context.session.figures().seconds > kSoonOver;
  }
  return context.session.chore() != nullptr && context.ui.now - context.ui.chore_since > kSoonOver;
}

void draw_progress(UiContext& context) {
  watch_phase(context);
  const UiState& ui = context.ui;
  const Look& look = ui.look;
  Work work;
  if (is_searching(context)) {
    work = search_work(context);
  } else if (const auto chore = context.session.chore(); chore != nullptr) {
    std::string percent = std::to_string(std::lround(chore->fraction() * 100)) + " %";
    const double seconds = seconds_left(chore->fraction(), context.ui.now - context.ui.chore_phase_since);
    if (seconds > 0) percent += " · about " + duration_text(std::ceil(seconds)) + " left";
    const bool can_stop = context.session.state() == RunState::Opening || context.session.is_making() ||
                          context.session.is_replacing();
    work = {chore->phase(), "", percent, chore->fraction(), can_stop};
  }
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  const float middle = std::floor(min.y + size.y / 2);
  const float text_y = std::floor(middle - ImGui::GetTextLineHeight() / 2);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  float left = min.x + look.px(16);
  ImFont* bold = look.fonts.bold;
  draw.AddText(bold, bold->FontSize, ImVec2(left, text_y), look.colours.text, work.what.c_str());
  left += bold->CalcTextSizeA(bold->FontSize, FLT_MAX, 0, work.what.c_str()).x + look.px(8);
  draw.AddText(ImVec2(left, text_y), look.colours.muted, work.detail.c_str());
  left = std::max(left + ImGui::CalcTextSize(work.detail.c_str()).x + look.px(16), min.x + look.px(280));
  ButtonSpec stop{"progress/stop", is_searching(context) ? "Stop" : "Cancel"};
  stop.tip = is_searching(context) ? tip_of(context, action(ActionId::Stop)) : "Gives up; what is open stays";
  stop.kind = ButtonKind::Outlined;
  stop.width = look.px(80);
  stop.height = look.px(24);
  float right = min.x + size.x - look.px(12) - (work.can_stop ? stop.width + look.px(12) : 0);
  right -= ImGui::CalcTextSize(work.left.c_str()).x;
  draw.AddText(ImVec2(right, text_y), look.colours.muted, work.left.c_str());
  const float thick = look.px(2);
  const float end = right - look.px(16);
  if (end > left) {
    const float at = left + (end - left) * static_cast<float>(std::clamp(work.fraction, 0.0, 1.0));
    draw.AddRectFilled(ImVec2(left, middle - thick), ImVec2(end, middle + thick), look.colours.border, thick);
    draw.AddRectFilled(ImVec2(left, middle - thick), ImVec2(at, middle + thick), look.colours.accent, thick);
  }
  if (!work.can_stop) return;
  ImGui::SetCursorScreenPos(ImVec2(min.x + size.x - look.px(12) - stop.width, middle - look.px(12)));
  if (!button(ui, stop)) return;
  if (is_searching(context)) {
    run_action(context, ActionId::Stop);
  } else {
    context.session.cancel_opening();
  }
}

}  // namespace netwright
