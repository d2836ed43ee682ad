// The main thread's half of a search. All that crosses threads is in Channel; the rest belongs to the main
// thread.
#include "core/project/search_run.h"

#include <algorithm>
#include <cmath>

#include "core/project/open_model.h"
#include "core/project/run_list.h"

namespace netwright {

namespace {

/// Up to this many moves a second a person can follow a single move: its climb is shown.
constexpr double kFollowable = 5;

/// The rate is measured over at least this time, then blended in, so that the number can be read.
constexpr double kRateSeconds = 0.25;
constexpr double kRateBlend = 0.4;

/// Stands for no stream of its own: the moves of all of them count.
constexpr int kAllStreams = -1;

}  // namespace

SearchRun::SearchRun(Worker& worker, std::shared_ptr<const DualGraph> dual, const SolveOptions& options,
                     const std::shared_ptr<const Bell>& bell, Start start, double speed, double now)
    : dual_(std::move(dual)),
      options_(options),
      channel_(std::make_shared<Channel>(bell)),
      is_paused_(start == Start::Paused),
      was_slowed_(is_paused_ || std::isfinite(speed)),
      speed_(speed),
      last_tick_(now) {
  if (is_paused_) channel_->gate.pause();
  channel_->gate.set_speed(speed);
  figures_.faces = static_cast<int>(dual_->mesh().n_faces());
  figures_.seed = options.seed;
  progress_ = worker.submit(Worker::Lane::Search,
                            [channel = channel_, shared_dual = dual_, options](Progress& progress) {
                              work(*channel, shared_dual, options, progress);
                            });
}

SearchRun::~SearchRun() { cancel(); }

void SearchRun::work(Channel& channel, std::shared_ptr<const DualGraph> dual, const SolveOptions& options,
                     Progress& progress) {
  auto outcome = std::make_shared<Outcome>();
  try {
    SolveHooks hooks;
    hooks.snapshots = &channel.snapshots;
    hooks.pace = [&channel] { return channel.gate.wait(); };
    outcome->result = solve(std::move(dual), options, progress, hooks);
    if (!outcome->result->net.placement.empty()) {
      outcome->measures = measure(outcome->result->net);
      outcome->picture = net_picture(outcome->result->net, kRunPictureWidth, kRunPictureHeight);
    }
    if (!outcome->result->log.empty()) outcome->log = std::make_shared<const RunLog>(*outcome->result);
  } catch (...) {
    outcome->fault = sentence_for_current_exception("The search");
  }
  channel.outcome.post(std::move(outcome));
}

void SearchRun::tick(double now) {
  if (!is_paused_) seconds_ += std::max(0.0, now - last_tick_);
  last_tick_ = now;
  figures_.seconds = seconds_;
}

void SearchRun::pause(double now) {
  tick(now);
  is_paused_ = was_slowed_ = true;
  channel_->gate.pause();
}

void SearchRun::resume(double now) {
  tick(now);
  is_paused_ = false;
  channel_->gate.resume();
}

void SearchRun::step(double now) {
  tick(now);
  is_paused_ = was_slowed_ = true;
  channel_->gate.step();
}

void SearchRun::cancel() {
  progress_->cancel();
  channel_->gate.stop();
}

void SearchRun::set_speed(double moves_per_second) {
  speed_ = moves_per_second;
  was_slowed_ = was_slowed_ || std::isfinite(moves_per_second);
  channel_->gate.set_speed(moves_per_second);
}

void SearchRun::take_figures(const Snapshot& snapshot) {
  figures_.overlaps = static_cast<int>(snapshot.overlaps.size());
  // The history is that of the part being worked on; one with several parts starts with the overlaps of all.
  if (n_pictures_ == 0) figures_.overlaps_at_start = figures_.overlaps;
  if (!snapshot.history.empty() && dual_->mesh().n_components() == 1)
    figures_.overlaps_at_start = snapshot.history.front();
  figures_.best_overlaps = snapshot.best_overlaps;
  figures_.moves = snapshot.moves;
  figures_.restarts = snapshot.restarts;
  figures_.history = snapshot.history;
  figures_.history_stride = snapshot.history_stride;
  if (snapshot.polish) {
    figures_.polish_fraction = snapshot.polish->fraction;
    figures_.polish_costs = snapshot.polish->costs;
    figures_.polish_stations = snapshot.polish->stations;
  }
  take_rate(snapshot);
}

// At full speed the pace is that of all streams, between which the picture may jump; move by move it is the
// picture's.
void SearchRun::take_rate(const Snapshot& snapshot) {
  const int counted = is_paused_ || std::isfinite(speed_) ? snapshot.stream : kAllStreams;
  const std::int64_t moves = counted == kAllStreams ? snapshot.moves_of_all : snapshot.moves;
  if (counted != rate_stream_ || moves < rate_moves_) {
    rate_stream_ = counted;
    rate_moves_ = moves;
    rate_seconds_ = seconds_;
  }
  const double elapsed = seconds_ - rate_seconds_;
  if (elapsed < kRateSeconds) return;
  const double rate = static_cast<double>(moves - rate_moves_) / elapsed;
  double& shown = figures_.moves_per_second;
  shown = shown > 0 ? shown + kRateBlend * (rate - shown) : rate;
  rate_moves_ = moves;
  rate_seconds_ = seconds_;
}

std::shared_ptr<ShownNet> SearchRun::take_picture() {
  const std::shared_ptr<const Snapshot> snapshot = channel_->snapshots.take();
  if (!snapshot) return nullptr;
  take_figures(*snapshot);
  if (n_pictures_++ == 0) roots_ = snapshot->net.tree.roots();
  auto shown = std::make_shared<ShownNet>(
      make_shown_net(layout_from(dual_, snapshot->net.tree, roots_), snapshot->overlaps, false));
  if (snapshot->last_move && (is_paused_ || speed_ <= kFollowable)) trace_move(*shown, *snapshot->last_move);
  return shown;
}

std::shared_ptr<const SearchRun::Outcome> SearchRun::take_outcome() { return channel_->outcome.take(); }

}  // namespace netwright
