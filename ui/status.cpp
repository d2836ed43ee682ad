// Puts figures into words. A number always comes with what it counts, and nothing is said that is not known.
#include "ui/status.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace netwright {
namespace {

constexpr double kFastestShown = 1000;   ///< moves a second just before full speed
constexpr double kFullSpeedFrom = 0.97;  ///< share of the slider's way

std::string number_text(const char* format, double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}

void add(std::string& text, const std::string& part) {
  if (!text.empty()) text += " · ";
  text += part;
}

std::string overlaps_text(int n) { return counted(n, "overlap", "overlaps"); }

std::string pieces_text(const ShownNet& shown) {
  return shown.net.n_pieces == 1 ? "one piece" : counted(shown.net.n_pieces, "piece", "pieces");
}

void add_run(std::string& text, const RunFigures& figures, bool is_running) {
  add(text, counted(figures.moves, "move", "moves"));
  if (is_running && figures.moves_per_second >= 1) {
    add(text, grouped(std::llround(figures.moves_per_second)) + " moves/s");
  }
  if (figures.restarts > 0) add(text, counted(figures.restarts, "restart", "restarts"));
  add(text, "seed " + std::to_string(figures.seed));
  // The clock stands still while a person steps from move to move.
  if (figures.seconds > 0) add(text, duration_text(figures.seconds));
}

Status running_status(const RunFigures& figures, const char* verb) {
  Status status{Tone::Working, "", std::string(verb)};
  status.in_short += " " + overlaps_text(figures.overlaps);
  status.text = status.in_short;
  add(status.text, counted(figures.faces, "face", "faces"));
  add_run(status.text, figures, true);
  return status;
}

Status idle_status(const Session& session) {
  const RunFigures figures = session.figures();
  const auto shown = session.shown();
  Status status;
  if (shown == nullptr) {
    status.in_short = "ready to unfold";
    status.text = counted(figures.faces, "face", "faces");
    add(status.text, status.in_short);
    return status;
  }
  const bool is_misplaced = session.misplaced() != nullptr;
  if (shown->is_proved) {
    status.tone = is_misplaced ? Tone::Bad : Tone::Good;
    status.in_short = pieces_text(*shown) + (is_misplaced ? ", misplaced" : ", proved");
  } else {
    status.tone = Tone::Bad;
    const bool is_apart = shown->net.n_pieces > static_cast<int>(shown->net.mesh().n_components());
    if (is_apart) status.in_short = counted(shown->net.n_pieces, "piece", "pieces");
    if (!shown->overlaps.empty()) {
      add(status.in_short, overlaps_text(static_cast<int>(shown->overlaps.size())) + " left");
    } else if (!is_apart) {
      status.in_short = "not proved";
    }
  }
  if (session.viewed_run() != 0) {
    const bool is_found = !session.timeline() || session.timeline()->position == session.timeline()->home;
    if (!is_found)
      status.in_short = overlaps_text(figures.overlaps) + " at " + counted(figures.moves, "move", "moves");
    if (!is_found) status.tone = Tone::Quiet;
    status.in_short = "run " + std::to_string(session.viewed_run()) + ": " + status.in_short;
  }
  status.text = status.in_short;
  add(status.text, counted(figures.faces, "face", "faces"));
  add_run(status.text, figures, false);
  return status;
}

}  // namespace

Status status_of(const Session& session) {
  switch (session.state()) {
    case RunState::Empty:
      return {Tone::Quiet, "no model", "no model"};
    case RunState::Opening:
      return {Tone::Working, "opening…", "opening…"};
    case RunState::Running:
      return running_status(session.figures(),
                            session.figures().polish_costs.empty() ? "unfolding…" : "polishing…");
    case RunState::Paused:
      return running_status(session.figures(), "paused at");
    case RunState::Replaying:
      return running_status(session.figures(), "replay…");
    case RunState::Idle:
      break;
  }
  return idle_status(session);
}

std::string duration_text(double seconds) {
  if (seconds > 0 && seconds < 5e-5) return "under 0.1 ms";
  if (seconds < 0.1) return number_text("%.1f ms", seconds * 1000);
  if (seconds < 10) return number_text("%.1f s", seconds);
  if (seconds < 120) return number_text("%.0f s", seconds);
  const auto whole = static_cast<int>(seconds);
  return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

double seconds_left(double fraction, double elapsed) {
  constexpr double kLeastShare = 0.05;
  constexpr double kLeastSeconds = 0.5;
  if (fraction < kLeastShare || fraction >= 1 || elapsed < kLeastSeconds) return 0;
  return elapsed * (1 - fraction) / fraction;
}

std::string difficulty_text(double moves) {
  // In words that fit what people see: over in a blink, worth watching, worth a cup of tea.
  constexpr double kEasy = 100;
  constexpr double kMedium = 2000;
  const std::string word = moves < kEasy ? "easy" : (moves < kMedium ? "medium" : "hard");
  if (moves < 1) return word + ", hardly a move";
  // Two digits are more than the guess is worth already.
  const double step = std::pow(10, std::max(0.0, std::floor(std::log10(moves)) - 1));
  return word + ", about " + counted(std::llround(std::round(moves / step) * step), "move", "moves");
}

std::string faces_text(std::int64_t faces, std::int64_t all) {
  return faces == all ? counted(all, "face", "faces")
                      : grouped(faces) + " of " + counted(all, "face", "faces");
}

int faces_of_slider(double t, int fewest, int all) {
  if (t >= 1 || fewest >= all) return all;
  return static_cast<int>(
      std::lround(fewest * std::pow(static_cast<double>(all) / fewest, std::clamp(t, 0.0, 1.0))));
}

double slider_of_faces(int faces, int fewest, int all) {
  if (fewest >= all) return 1;
  const double share = std::log(static_cast<double>(std::max(faces, 1)) / fewest) /
                       std::log(static_cast<double>(all) / fewest);
  return std::clamp(share, 0.0, 1.0);
}

std::string speed_text(double moves_per_second) {
  if (std::isinf(moves_per_second)) return "full speed";
  if (moves_per_second < 1.5) return "one move a second";
  return grouped(std::llround(moves_per_second)) + " moves a second";
}

double speed_of_slider(double t) {
  if (t >= kFullSpeedFrom) return std::numeric_limits<double>::infinity();
  return std::pow(kFastestShown, std::max(t, 0.0) / kFullSpeedFrom);
}

double slider_of_speed(double moves_per_second) {
  if (std::isinf(moves_per_second)) return 1;
  const double share = std::log(std::max(moves_per_second, 1.0)) / std::log(kFastestShown);
  return std::clamp(share, 0.0, 0.999) * kFullSpeedFrom;
}

}  // namespace netwright
