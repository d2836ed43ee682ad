// The session's finished runs: keeping them, looking at one without touching the project, playing its moves
// back and forth, taking its net. Pictures of what is looked at are made as chores, the latest wish first.
#include <algorithm>
#include <cmath>

#include "core/base/predicates.h"
#include "core/project/commands.h"
#include "core/project/session_impl.h"

namespace netwright {

namespace {

constexpr double kSlowest = 0.1;
constexpr double kFastest = 1e6;  ///< moves a second

/// Up to this many moves a second a person can follow a single move: its climb is shown.
constexpr double kFollowable = 5;

ShownNet picture_of(const FinishedRun& run) {
  return make_shown_net(layout(run.dual, *run.tree), run.overlaps, run.summary.is_proved);
}

ShownNet picture_of_moment(Replay& replay, int position, bool is_traced) {
  replay.seek(position);
  Net net = replay.net();
  std::vector<Overlap> overlaps = find_overlaps(net, kShownDepth);
  ShownNet shown = make_shown_net(std::move(net), std::move(overlaps), false);
  shown.last_move = replay.log().move(position);
  if (is_traced && shown.last_move) trace_move(shown, *shown.last_move);
  return shown;
}

}  // namespace

void Session::Impl::keep_run(const SearchRun::Outcome& outcome, const RunSummary& summary) {
  FinishedRun finished;
  finished.dual = project().dual;
  finished.tree = std::make_shared<const UnfoldTree>(outcome.result->net.tree);
  finished.summary = summary;
  finished.figures = *last_figures;
  finished.overlaps = outcome.result->overlaps;
  finished.measures = outcome.measures;
  finished.picture = outcome.picture;
  finished.log = outcome.log;
  runs.add(std::move(finished));
}

RunList::Entry Session::Impl::accepted_run() const {
  if (!project().run || is_unfinished) return nullptr;
  for (const RunList::Entry& entry : runs.of(project().dual))
    if (entry->summary == *project().run) return entry;
  return nullptr;
}

Session::Impl::Viewing::Viewing() = default;

void Session::Impl::view_run(int number) {
  const RunList::Entry wanted = runs.find(number);
  if (!wanted || wanted->dual != project().dual || run) return;
  if (viewing && viewing->run == wanted) return;
  end_replay();
  leave_view();
  viewing.emplace();
  viewing->run = wanted;
  if (wanted->log && wanted->log->n_steps() > 1) {
    viewing->replay = std::make_shared<Replay>(wanted->log);
    viewing->home = wanted->summary.is_proved ? wanted->log->n_steps() - 1 : wanted->log->best_position();
  }
  viewing->position = viewing->home;
  show_view();
}

void Session::Impl::leave_view() {
  if (viewing && viewing->chore) viewing->chore->progress->cancel();
  viewing.reset();
}

void Session::Impl::ask_for_view() {
  Viewing& view = *viewing;
  view.asked = view.at();
  view.chore = std::make_shared<Chore<ShownNet>>(bell);
  const bool is_traced = !view.is_playing || view.speed <= kFollowable;
  view.chore->progress =
      worker.submit(Worker::Lane::Chores, [chore = view.chore, entry = view.run, replay = view.replay,
                                           at = view.asked, is_own_net = view.asked == view.home, is_traced,
                                           version = ++n_versions](Progress& progress) {
        if (progress.is_cancelled()) return;
        ShownNet shown = is_own_net ? picture_of(*entry) : picture_of_moment(*replay, at, is_traced);
        shown.version = version;
        chore->result.post(std::make_shared<const ShownNet>(std::move(shown)));
      });
}

bool Session::Impl::show_view() {
  Viewing& view = *viewing;
  if (view.chore || view.asked == view.at()) return false;
  const bool is_projects_own = accepted_run() == view.run && view.at() == view.home && settled;
  if (!is_projects_own) {
    ask_for_view();
    return false;
  }
  view.asked = view.at();
  view.picture = settled;
  return true;
}

bool Session::Impl::take_view() {
  if (!viewing) return false;
  Viewing& view = *viewing;
  const double now = clock();
  const double elapsed = now - std::exchange(view.last_tick, now);
  bool has_changed = view.is_playing;
  if (view.is_playing) {
    const double last = view.run->log->n_steps() - 1;
    view.position = std::min(view.position + elapsed * view.speed, last);
    view.is_playing = view.position < last;
  }
  if (view.chore) {
    if (const std::shared_ptr<const ShownNet> picture = view.chore->result.take()) {
      view.picture = picture;
      view.chore = nullptr;
      has_changed = true;
    }
  }
  return show_view() || has_changed;
}

RunFigures Session::Impl::view_figures() const {
  RunFigures figures = viewing->run->figures;
  const int at = viewing->at();
  if (!viewing->replay || at == viewing->home) return figures;
  const RunLog& log = *viewing->run->log;
  figures.overlaps = log.overlaps(at);
  figures.best_overlaps = log.fewest_overlaps(at);
  figures.moves = log.moves(at);
  figures.restarts = log.restarts(at);
  figures.at_polish = log.polish_fraction(at);
  if (figures.at_polish < 0) figures.at_move = log.moves(at) - log.moves(0);
  return figures;
}

std::vector<RunList::Entry> Session::runs() const { return impl_->runs.of(project().dual); }

int Session::best_run() const {
  const RunList::Entry best = impl_->runs.best_of(project().dual);
  return best ? best->number : 0;
}

int Session::accepted_run() const {
  const RunList::Entry accepted = impl_->accepted_run();
  return accepted ? accepted->number : 0;
}

int Session::viewed_run() const { return impl_->viewing ? impl_->viewing->run->number : 0; }

void Session::view_run(int number) {
  if (number == 0) {
    impl_->leave_view();
  } else {
    impl_->view_run(number);
  }
}

std::string Session::why_not_accept(int number) const {
  const RunList::Entry entry = impl_->runs.find(number);
  if (!entry || entry->dual != project().dual) return "There is no such run of this model.";
  if (!entry->summary.is_proved) return "This run ended with overlaps; only a proved net can be accepted.";
  if (entry == impl_->accepted_run()) return "This run's net is the present one.";
  return netwright::keeps_pins(entry->dual->mesh(), *entry->tree, project().pins)
             ? ""
             : "This run's net does not keep all pins that are set now.";
}

void Session::accept_run(int number) {
  const RunList::Entry entry = impl_->runs.find(number);
  if (entry && entry == impl_->accepted_run()) impl_->leave_view();
  if (!why_not_accept(number).empty()) return;
  impl_->end_replay();
  impl_->discard_run();
  impl_->is_unfinished = false;
  impl_->settled = impl_->stamp(std::make_shared<ShownNet>(picture_of(*entry)));
  impl_->last_figures = entry->figures;
  Project next = accept_tree(project(), *entry->tree, entry->summary);
  impl_->edit("accept run " + std::to_string(number),
              netwright::pin_root(std::move(next), project().pins.root));
}

void Session::delete_run(int number) {
  if (viewed_run() == number) impl_->leave_view();
  impl_->runs.erase(number);
}

void Session::export_run(int number, const std::filesystem::path& path) {
  const RunList::Entry entry = impl_->runs.find(number);
  if (!entry || entry->dual != project().dual || !entry->summary.is_proved) return;
  impl_->export_to(path, accept_tree(project(), *entry->tree, entry->summary), nullptr);
}

std::optional<Session::Timeline> Session::timeline() const {
  if (!impl_->viewing || !impl_->viewing->replay) return std::nullopt;
  const Impl::Viewing& view = *impl_->viewing;
  return Timeline{view.at(), view.run->log->n_steps(), view.home, view.is_playing, view.speed};
}

void Session::seek(int position) {
  const auto line = timeline();
  if (!line) return;
  impl_->viewing->position = std::clamp(position, 0, line->n_steps - 1);
  impl_->show_view();
}

void Session::play() {
  const auto line = timeline();
  if (!line) return;
  Impl::Viewing& view = *impl_->viewing;
  if (line->position == line->n_steps - 1) view.position = 0;
  view.is_playing = true;
  view.last_tick = impl_->clock();
}

void Session::hold() {
  if (impl_->viewing) impl_->viewing->is_playing = false;
}

void Session::set_play_speed(double moves_per_second) {
  if (impl_->viewing && std::isfinite(moves_per_second))
    impl_->viewing->speed = std::clamp(moves_per_second, kSlowest, kFastest);
}

}  // namespace netwright
