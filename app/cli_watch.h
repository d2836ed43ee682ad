// Waiting for a job on the worker while looking after the outside world: Ctrl-C, the time limit and the line
// that shows how far the search is.
#pragma once

#include <functional>
#include <optional>

#include "core/base/mailbox.h"
#include "core/base/progress.h"
#include "core/solve/snapshot.h"

namespace netwright {

class Worker;

/// Holds Ctrl-C back from the moment it is made, so that whoever asks decides what it means. Make it before
/// any thread.
class Interrupts {
 public:
  Interrupts();
  /// True once Ctrl-C was pressed.
  [[nodiscard]] bool has_come() const;
};

/// One line on the terminal that is written over and over and wiped when the search is over; nothing at all
/// when standard error is not a terminal.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  /// Null when nobody looks, so that the search need not make any pictures.
  Mailbox<Snapshot>* snapshots() { return is_shown_ ? &snapshots_ : nullptr; }
  void show(double seconds);

 private:
  bool is_shown_;
  Mailbox<Snapshot> snapshots_;
};

struct Watched {
  bool was_interrupted = false;
  bool was_out_of_time = false;
};

/// Runs `job` on a worker and returns when it ends; its exception is thrown again here. Ctrl-C and the end of
/// `time_limit_s` (when there is one) cancel it. A job that goes on for two seconds after Ctrl-C, or a second
/// Ctrl-C, ends the program on the spot with status 130; nothing is being written then.
Watched run_watched(const Interrupts& interrupts, const std::function<void(Progress&)>& job,
                    std::optional<double> time_limit_s = {}, ProgressLine* line = nullptr);

/// The same on a worker that is there already, for many short jobs. `glance`, when there is one, is called
/// about ten times a second with the seconds since the job began.
Watched run_watched(Worker& worker, const Interrupts& interrupts, const std::function<void(Progress&)>& job,
                    std::optional<double> time_limit_s, const std::function<void(double)>& glance);

/// Seconds on a steady clock.
double now_seconds();

}  // namespace netwright
