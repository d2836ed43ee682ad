// Runs are chosen by looking at one: whatever is done, is done to the run that is looked at.
#include "ui/run_actions.h"

#include <algorithm>

namespace netwright {
namespace {

bool is_searching(const UiContext& c) {
  const RunState state = c.session.state();
  return state == RunState::Running || state == RunState::Paused;
}

RunList::Entry viewed_run(const UiContext& c) {
  for (const RunList::Entry& run : c.session.runs())
    if (run->number == c.session.viewed_run()) return run;
  return nullptr;
}

/// The run `steps` lines below the present one, null past the ends.
RunList::Entry neighbour(const UiContext& c, int steps) {
  const auto runs = c.session.runs();
  const int viewed = c.session.viewed_run();
  const int present = viewed != 0 ? viewed : c.session.accepted_run();
  const auto at = std::find_if(runs.begin(), runs.end(), [&](const auto& r) { return r->number == present; });
  if (at == runs.end()) return runs.empty() ? nullptr : runs.back();
  const auto index = at - runs.begin() - steps;
  const bool is_there = index >= 0 && index < static_cast<std::ptrdiff_t>(runs.size());
  return is_there ? runs[static_cast<std::size_t>(index)] : nullptr;
}

void view_neighbour(UiContext& c, int steps) {
  const RunList::Entry run = neighbour(c, steps);
  if (run != nullptr) c.session.view_run(run->number);
  c.ui.wants_run_in_view = true;
}

void step_by(UiContext& c, int moves) {
  const auto line = c.session.timeline();
  if (!line) return;
  c.session.hold();
  c.session.seek(line->position + moves);
}

}  // namespace

std::string needs_runs(const UiContext& c) {
  if (c.session.runs().empty()) return "No run has finished yet.";
  return is_searching(c) ? "The search is what is shown while it runs; stop it first (Esc)." : "";
}

std::string needs_viewed_run(const UiContext& c) {
  return c.session.viewed_run() != 0 ? "" : "Click a run in the list first.";
}

std::string needs_acceptable_run(const UiContext& c) {
  const int viewed = c.session.viewed_run();
  return viewed == 0 ? "Click a run in the list first." : c.session.why_not_accept(viewed);
}

std::string needs_proved_run(const UiContext& c) {
  const auto runs = c.session.runs();
  const bool has_one =
      std::any_of(runs.begin(), runs.end(), [](const auto& run) { return run->summary.is_proved; });
  return has_one ? "" : "No run has ended with a proved net yet.";
}

std::string needs_timeline(const UiContext& c) {
  if (c.session.timeline()) return "";
  const RunList::Entry run = viewed_run(c);
  if (run == nullptr) return "Click a run in the list first.";
  return run->log == nullptr ? "The moves of this run are kept no more, to save memory."
                             : "This run needed no moves.";
}

std::string needs_history(const UiContext& c) {
  return c.session.history().size() > 1 ? "" : "Nothing has been changed yet.";
}

void view_newer_run(UiContext& c) { view_neighbour(c, -1); }
void view_older_run(UiContext& c) { view_neighbour(c, 1); }
void leave_run(UiContext& c) { c.session.view_run(0); }
void accept_viewed_run(UiContext& c) { c.session.accept_run(c.session.viewed_run()); }

void delete_viewed_run(UiContext& c) {
  const int number = c.session.viewed_run();
  RunList::Entry next = neighbour(c, 1);
  if (next == nullptr) next = neighbour(c, -1);
  c.session.delete_run(number);
  if (next != nullptr) c.session.view_run(next->number);
}

void export_best_run(UiContext& c) {
  c.ui.export_run = c.session.best_run();
  c.ui.export_extension = "pdf";
  c.ui.dialog = Dialog::Export;
}

void play_or_hold(UiContext& c) {
  if (is_playing(c)) {
    c.session.hold();
  } else {
    c.session.play();
  }
}

bool is_playing(const UiContext& c) {
  const auto line = c.session.timeline();
  return line && line->is_playing;
}

std::string play_label(const UiContext& c) { return is_playing(c) ? "Hold the moves" : "Play the moves"; }
void move_back(UiContext& c) { step_by(c, -1); }
void move_on(UiContext& c) { step_by(c, 1); }

void show_history(UiContext& c) {
  c.ui.settings.is_side_open = true;
  c.ui.settings.is_open(Section::History) = true;
}

std::string run_name(int number) { return "run " + std::to_string(number); }

}  // namespace netwright
