// The search's three settings and the chart of what it does.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "assets/icons.h"
#include "ui/actions.h"
#include "ui/panels.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr int kMaxStreams = 16;
constexpr double kLongestLimit = 86400;  ///< seconds: a day

void seed_row(UiContext& c) {
  UiState& ui = c.ui;
  const float width = row(ui, "Seed") - ui.look.px(16);
  ImGui::SetNextItemWidth(width - ui.look.px(40));
  std::uint64_t seed = c.session.project().seed;
  if (number_field(ui, "solve/seed", seed)) c.session.set_seed(seed);
  tooltip(ui, "The same model and seed give the same net on every machine");
  ImGui::SameLine();
  ButtonSpec dice{"solve/dice", "", icon::kSeed};
  const Action& next = action(ActionId::NewSeed);
  dice.tip = tip_of(c, next);
  dice.is_enabled = is_possible(c, ActionId::NewSeed);
  dice.kind = ButtonKind::Outlined;
  dice.width = ui.look.px(32);
  dice.height = ImGui::GetFrameHeight();
  if (button(ui, dice)) run_action(c, ActionId::NewSeed);
}

bool small_button(const UiState& ui, const char* name, const char* sign, bool is_enabled) {
  ButtonSpec spec{name, "", sign};
  spec.kind = ButtonKind::Outlined;
  spec.width = ui.look.px(32);
  spec.height = ImGui::GetFrameHeight();
  spec.is_enabled = is_enabled;
  if (!is_enabled) spec.tip = "Between 1 and " + std::to_string(kMaxStreams) + " streams";
  return button(ui, spec);
}

void streams_row(UiContext& c) {
  UiState& ui = c.ui;
  const float width = row(ui, "Streams") - ui.look.px(16);
  ImGui::SetNextItemWidth(width - 2 * ui.look.px(40));
  auto streams = static_cast<std::uint64_t>(c.session.streams());
  const bool is_typed = number_field(ui, "solve/streams", streams);
  tooltip(ui, "Independent searches side by side; the first net found wins. Counts from the next run on");
  ImGui::SameLine();
  const bool is_less = small_button(ui, "solve/streams-less", icon::kRemove, c.session.streams() > 1);
  ImGui::SameLine();
  const bool is_more = small_button(ui, "solve/streams-more", icon::kAdd, c.session.streams() < kMaxStreams);
  if (is_less) --streams;
  if (is_more) ++streams;
  if (!is_typed && !is_less && !is_more) return;
  c.session.set_streams(static_cast<int>(std::clamp<std::uint64_t>(streams, 1, kMaxStreams)));
  ui.settings.streams = c.session.streams();
}

void time_limit_row(UiContext& c) {
  UiState& ui = c.ui;
  ImGui::SetNextItemWidth(row(ui, "Time limit") - ui.look.px(16));
  double seconds = c.session.time_limit();
  const char* format = seconds > 0 ? "%.0f s" : "none";
  if (number_field(ui, "solve/limit", seconds, format)) {
    c.session.set_time_limit(std::clamp(seconds, 0.0, kLongestLimit));
    ui.settings.time_limit_s = static_cast<int>(std::ceil(c.session.time_limit()));
  }
  tooltip(ui, "When it is over, the search ends with the best net so far. 0 means no limit");
}

std::string chart_summary(const RunFigures& figures) {
  if (figures.history.empty()) return {};
  return grouped(figures.overlaps_at_start) + " → " + grouped(figures.overlaps) + " in " +
         counted(figures.moves, "move", "moves");
}

void chart_header(const UiState& ui, const char* title, const std::string& summary) {
  ImGui::TextUnformatted(title);
  ImGui::PushFont(ui.look.fonts.small);
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ui.look.px(16) -
                  ImGui::CalcTextSize(summary.c_str()).x);
  text_muted(ui, summary);
  ImGui::PopFont();
}

void unmet_line(const UiState& ui, const std::vector<std::string>& wishes) {
  if (wishes.empty()) return;
  std::string unmet;
  for (const std::string& wish : wishes) unmet += (unmet.empty() ? "" : ", ") + wish;
  ImGui::PushTextWrapPos(ImGui::GetWindowContentRegionMax().x - ui.look.px(16));
  text_muted(ui, "Not met: " + unmet + ".");
  ImGui::PopTextWrapPos();
}

}  // namespace

void panel_solve(UiContext& context) {
  UiState& ui = context.ui;
  seed_row(context);
  streams_row(context);
  time_limit_row(context);
  panel_polish(context);
  panel_pins(context);
  const RunFigures figures = context.session.figures();
  if (figures.history.empty()) return;
  const RunState state = context.session.state();
  const bool is_running =
      state == RunState::Running || state == RunState::Replaying || state == RunState::Paused;
  ImGui::Dummy(ImVec2(0, ui.look.px(4)));
  if (figures.moves == 0 && figures.overlaps == 0) {
    text_muted(ui, "The first net had no overlaps.");
  } else {
    chart_header(ui, "Overlaps", chart_summary(figures));
    overlap_chart(ui, figures, is_running);
  }
  if (figures.polish_stations.empty()) return;
  chart_header(ui, "Polish", "% of the first net");
  polish_chart(ui, figures, is_running);
  if (!is_running) unmet_line(ui, figures.unmet_wishes);
}

}  // namespace netwright
