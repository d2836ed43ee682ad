// The job: start tree, tabu search on several streams, final re-detection, proof. Window and command line
// call this one function, so the same model, seed and options give the same net in both, on any number of
// threads.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/mailbox.h"
#include "core/base/progress.h"
#include "core/base/worker.h"
#include "core/solve/aims.h"
#include "core/solve/constraints.h"
#include "core/solve/snapshot.h"
#include "core/unfold/glue_tabs.h"
#include "core/unfold/impossibility.h"
#include "core/unfold/verify.h"

namespace netwright {

/// Which search unfolds. Both end in nets that pass the same proof.
enum class SearchStyle {
  Fast,   ///< greedy start, two-sided moves, bounded worsening (the default)
  Paper,  ///< as the paper has it: steepest-edge start, random roots, every worsening move taken
};

/// Glue tabs counted in the search: once there is a net, folds are exchanged until every cut has room for a
/// tab on one side at least, or as many as can be.
struct TabAim {
  TabSettings settings;
  /// mm per model unit at which a net would be printed: it may depend on the net.
  std::function<double(const Net&)> scale;
  int looks_per_face = 30;  ///< how long to try: nets judged, per face of the component
};

struct SolveOptions {
  std::uint64_t seed = 0;
  SearchStyle search = SearchStyle::Fast;
  int streams = 2;     ///< independent searches; part of what decides the answer
  int threads = 0;     ///< how many run them (0: as many as streams and cores); never decides it
  Constraints pins{};  ///< what every result keeps, also one that is not a net yet
  /// The tree to start from instead of a new one, mended where it breaks pins; may be any forest.
  std::shared_ptr<const UnfoldTree> from{};
  bool stays_near = false;            ///< change as little of `from` as overlaps and pins allow
  std::optional<PolishAim> polish{};  ///< what else a net should be; decides the answer, like tabs. Not done
                                      ///< to one that stays near
  std::optional<TabAim> tabs{};       ///< what else it should have
  std::int64_t max_iterations = 0;    ///< per stream, 0 = no limit; decides the answer, unlike a time limit
};

/// How the watcher wants the next move of the shown stream.
enum class Pace {
  Full,  ///< don't wait, skip to the latest state
  Move,  ///< show this one move
  Stop,  ///< cancelled while waiting
};

/// What a watcher hands in. Both may be left empty.
struct SolveHooks {
  Mailbox<Snapshot>* snapshots = nullptr;
  /// Called before each move is shown, on the solver's thread; blocks while paused or until the next move is
  /// due. The search itself stays ahead by at most one round, so pausing never changes the answer.
  std::function<Pace()> pace;
  /// Threads kept between jobs, used instead of new ones; then `threads` of the options is not asked.
  /// Starting a thread can cost more than a small model's whole search.
  ThreadPool* pool = nullptr;
};

/// How many threads these options ask for: at most one per stream.
int n_threads(const SolveOptions& options);

struct SolveResult {
  Net net;  ///< the best found; a proved net when is_proved
  bool is_proved = false;
  bool was_cancelled = false;
  FaceId isolated_face;  ///< proves, where it is valid, that no net exists (see unfold/obstruction.h): no
                         ///< search is made
  /// Proves, where it is there, that no net exists: tried once when a search has taken long, and there at
  /// once with an isolated face whose overlaps are deep enough.
  std::shared_ptr<const ImpossibilityProof> impossible;
  VerifyReport proof;
  std::vector<Overlap> overlaps;         ///< what is left, deeper than kShownDepth
  std::optional<PolishReport> polished;  ///< when that was asked for and there was a net
  int tabless_before = 0;                ///< with a TabAim: cuts without room for a tab before exchanges,
  int tabless_after = 0;                 ///< and in this one
  int stream = 0;                        ///< which one found it
  std::int64_t iterations = 0;           ///< of the stream that found it
  std::int64_t moves = 0;
  int restarts = 0;
  /// Of all streams: in how many iterations each face was the one to be cleared of overlaps.
  IdVector<FaceId, std::int64_t> collisions;
  double cpu_seconds = 0;     ///< start trees + search + re-detection, all threads
  double finish_seconds = 0;  ///< of polish and room for tabs, with their proofs
  double verify_seconds = 0;
  std::vector<Episode> log;  ///< what the replay plays: start trees and moves of the winning stream
};

/// Unfolds every component of the mesh into one piece each. Ends when all are proved nets, when
/// `progress` is cancelled (the best so far is returned), or at max_iterations. Throws Error(Unfit) when the
/// pins contradict each other.
SolveResult solve(std::shared_ptr<const DualGraph> dual, const SolveOptions& options, Progress& progress,
                  const SolveHooks& hooks = {});

}  // namespace netwright
