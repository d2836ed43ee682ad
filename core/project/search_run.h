// One run of the search, seen from the main thread: starts the job on the worker, holds, steps and ends it,
// takes its snapshots in and keeps the figures. The job ends when this object goes.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/mailbox.h"
#include "core/base/worker.h"
#include "core/project/bell.h"
#include "core/project/net_measures.h"
#include "core/project/pace_gate.h"
#include "core/project/run_figures.h"
#include "core/project/run_log.h"
#include "core/project/shown_net.h"
#include "core/solve/solve.h"

namespace netwright {

class SearchRun {
 public:
  struct Outcome {
    std::optional<SolveResult> result;  ///< its log has moved to `log`
    std::shared_ptr<const RunLog> log;  ///< null when the search ended before it had a start tree
    NetMeasures measures;
    Image picture;
    std::string fault;  ///< a sentence when there is no result
  };
  enum class Start { Running, Paused };

  /// Queues the job; `now` is the session's clock and `speed` the moves a second it starts with.
  SearchRun(Worker& worker, std::shared_ptr<const DualGraph> dual, const SolveOptions& options,
            const std::shared_ptr<const Bell>& bell, Start start, double speed, double now);
  ~SearchRun();
  SearchRun(const SearchRun&) = delete;
  SearchRun& operator=(const SearchRun&) = delete;

  void pause(double now);
  void resume(double now);
  void step(double now);
  void cancel();  ///< the outcome, with the best so far, comes soon
  void set_speed(double moves_per_second);

  [[nodiscard]] bool is_paused() const { return is_paused_; }
  [[nodiscard]] const SolveOptions& options() const { return options_; }
  /// Was it ever held back for the eyes?
  [[nodiscard]] bool was_slowed() const { return was_slowed_; }
  [[nodiscard]] int n_pictures() const { return n_pictures_; }
  /// Seconds of running, pauses left out.
  [[nodiscard]] double seconds() const { return seconds_; }
  void tick(double now);

  /// The newest snapshot as a picture, null when nothing came since the last call.
  std::shared_ptr<ShownNet> take_picture();
  /// Once, when the job is over; the last snapshot is in the figures then.
  std::shared_ptr<const Outcome> take_outcome();
  [[nodiscard]] const RunFigures& figures() const { return figures_; }

 private:
  /// What the job shares with this object; it outlives whichever goes first.
  struct Channel {
    explicit Channel(const std::shared_ptr<const Bell>& bell)
        : snapshots([bell] { bell->ring(); }), outcome([bell] { bell->ring(); }) {}
    Mailbox<Snapshot> snapshots;
    Mailbox<Outcome> outcome;
    PaceGate gate;
  };
  static void work(Channel& channel, std::shared_ptr<const DualGraph> dual, const SolveOptions& options,
                   Progress& progress);
  void take_figures(const Snapshot& snapshot);
  void take_rate(const Snapshot& snapshot);

  std::shared_ptr<const DualGraph> dual_;
  SolveOptions options_;
  std::shared_ptr<Channel> channel_;
  std::shared_ptr<Progress> progress_;
  std::vector<FaceId> roots_;  ///< of the first snapshot: all pictures are laid out from these
  RunFigures figures_;
  bool is_paused_;
  bool was_slowed_;
  double speed_;
  double seconds_ = 0;
  double last_tick_;
  double rate_seconds_ = 0;      ///< seconds() when the rate was last measured
  std::int64_t rate_moves_ = 0;  ///< and the moves made then
  int rate_stream_ = -2;         ///< whose moves they are: a stream, or all
  int n_pictures_ = 0;
};

}  // namespace netwright
