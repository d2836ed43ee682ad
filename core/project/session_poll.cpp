// What comes back to the session: opened models, derived data, exports, and the search with its replay. All
// of it is taken in by poll(), once per frame, on the main thread.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/base/predicates.h"
#include "core/project/commands.h"
#include "core/project/session_impl.h"
#include "core/sheet/write.h"
#include "core/solve/prove_impossible.h"
#include "core/unfold/obstruction.h"

namespace netwright {

namespace {

/// A run that gave the eye at most this many pictures, or was over in this time, is played back.
constexpr int kFewPictures = 3;
constexpr double kShortRun = 0.1;

constexpr std::size_t kMostChartValues = 2000;

/// Seconds between two pictures of a replay, per face: what making one costs, with room to spare.
constexpr double kPictureSecondsPerFace = 2e-5;

std::string duration_text(double seconds) {
  if (seconds < 0.001) return "under 1 ms";
  char text[32];
  if (seconds < 1) {
    std::snprintf(text, sizeof text, "%.0f ms", seconds * 1000);
  } else {
    std::snprintf(text, sizeof text, "%.*f s", seconds < 10 ? 1 : 0, seconds);
  }
  return text;
}

std::string good_news_of(const Mesh& mesh, const RunSummary& run) {
  const std::string parts = mesh.n_components() == 1
                                ? std::string("one piece")
                                : counted(static_cast<std::int64_t>(mesh.n_components()), "piece", "pieces");
  return counted(static_cast<std::int64_t>(mesh.n_faces()), "face", "faces") + " in " + parts +
         ", proved free of overlaps (seed " + std::to_string(run.seed) + ", " + duration_text(run.seconds) +
         ").";
}

std::string unfinished_news(const SolveResult& result, const RunFigures& figures, bool is_timed_out) {
  if (result.isolated_face.is_valid()) return isolated_face_sentence(result.net.mesh(), result.isolated_face);
  if (result.impossible != nullptr) return impossible_sentence(result.net.mesh());
  if (result.overlaps.empty() && !result.proof.faults.empty())
    return "The search ended, but its net failed the proof: " + result.proof.faults.front() +
           " Try a new seed.";
  return counted(static_cast<std::int64_t>(result.overlaps.size()), "overlap", "overlaps") + " left " +
         (is_timed_out ? "at the time limit" : "when the search was stopped") + ", after " +
         duration_text(figures.seconds) + ": let it run longer or try a new seed.";
}

std::string export_news(const WrittenDrawing& written) {
  const auto& files = written.files;
  std::string news = "Saved " + files.front().filename().string();
  if (files.size() > 1)
    news += " to " + files.back().filename().string() + ", " +
            grouped(static_cast<std::int64_t>(files.size())) + " files";
  const bool says_pages = written.n_backs > 0 || written.has_instructions || files.size() == 1;
  return written.n_pages > 0 && says_pages ? news + ", " + pages_text(written) : news;
}

/// Leaves of the chart of polish what had come by this fraction; nothing where that is negative.
void show_polish_until(RunFigures& figures, double fraction) {
  figures.polish_costs.clear();
  figures.polish_fraction = std::max(fraction, 0.0);
  std::erase_if(figures.polish_stations,
                [&](const PolishStation& station) { return station.fraction > fraction; });
}

std::string why_no_sheets(const Derived& derived) {
  if (!derived.fault.empty()) return derived.fault;
  if (!derived.misplaced.is_nothing()) return misplaced_sentence(derived.misplaced);
  return "The net is not one proved piece yet: join its pieces or solve the rest, then save.";
}

}  // namespace

void Session::Impl::derive_again() {
  if (deriving) deriving->progress->cancel();
  deriving = nullptr;
  if (!project().tree) {
    derived = nullptr;
    return;
  }
  deriving = std::make_shared<Deriving>(bell);
  deriving->progress = worker.submit(
      Worker::Lane::Chores,
      [chore = deriving, source = project(), before = derived, version = ++n_versions](Progress& progress) {
        std::shared_ptr<const Derived> made;
        try {
          made = derive(source, before, version, progress, [&](std::shared_ptr<const ShownNet> net) {
            if (!progress.is_cancelled()) chore->net.post(std::move(net));
          });
        } catch (...) {
          auto failed = std::make_shared<Derived>();
          failed->fault = sentence_for_current_exception("Drawing the sheets");
          made = std::move(failed);
        }
        if (!progress.is_cancelled()) chore->result.post(std::move(made));
      });
}

void Session::Impl::settle_on(std::shared_ptr<const ShownNet> net) {
  const bool is_viewed = viewing && viewing->picture && viewing->picture == settled;
  if (!is_unfinished) settled = std::move(net);
  if (is_viewed) viewing->picture = settled;
}

bool Session::Impl::take_derived() {
  const std::shared_ptr<const Derived> made = deriving ? deriving->result.take() : nullptr;
  if (!made) {
    std::shared_ptr<const ShownNet> net = deriving ? deriving->net.take() : nullptr;
    if (!net) return false;
    settle_on(std::move(net));
    return true;
  }
  deriving = nullptr;
  if (!made->fault.empty() && !(derived && derived->fault == made->fault))
    say(Message::Kind::Error, made->fault);
  derived = made;
  const bool is_newly_proved = derived->shown && derived->shown->is_proved && project().run &&
                               !project().run->is_proved && derived->source.tree == project().tree;
  if (is_newly_proved) {  // a net made by hand has passed its proof
    Project proved = project();
    proved.run->is_proved = true;
    proved.run->overlaps = 0;
    derived = std::make_shared<const Derived>([&] {
      Derived same = *derived;
      same.source = proved;
      return same;
    }());
    history.amend(std::move(proved));
  }
  if (derived->shown) settle_on(derived->shown);
  return true;
}

void Session::Impl::export_to(const std::filesystem::path& path, const Project& source,
                              std::shared_ptr<const Derived> before) {
  export_by(path.filename().string(), source, std::move(before), [path](const Derived& now) {
    const Project& printed = now.source;
    return export_news(write_drawing(path, now.shown->net, *now.pages, sheet_info(printed, now.is_sound),
                                     printed.sheet, printed.exports));
  });
}

void Session::Impl::export_for_cutter(const std::filesystem::path& folder, CutterPreset preset) {
  export_by(folder.filename().string(), project(), derived, [folder, preset](const Derived& now) {
    const Project& printed = now.source;
    const Net& net = now.shown->net;
    const PaperSetup paper = cutter_paper(printed.paper, preset);
    const PageLayout layout =
        paper == printed.paper ? *now.pages : arrange(net, paper, printed.size, printed.tabs);
    const CutterPackage package = write_cutter_package(folder, net, layout, sheet_info(printed, now.is_sound),
                                                       printed.sheet, printed.exports, preset);
    std::string news = "Saved " + counted(static_cast<std::int64_t>(package.files.size()), "file", "files") +
                       " for the cutter into " + folder.filename().string();
    for (const std::string& note : package.notes) news += ". " + note;
    return news;
  });
}

void Session::Impl::export_by(const std::string& name, const Project& source,
                              std::shared_ptr<const Derived> before,
                              std::function<std::string(const Derived&)> write) {
  auto chore = std::make_shared<Chore<Message>>(bell);
  chore->progress = worker.submit(Worker::Lane::Chores, [chore, name, source, before = std::move(before),
                                                         write = std::move(write)](Progress& progress) {
    progress.set_phase("Saving " + name);
    auto news = std::make_shared<Message>();
    try {
      const std::shared_ptr<const Derived> now = derive(source, before, 0, progress);
      if (!now->sheets) throw Error(ErrorKind::Usage, why_no_sheets(*now));
      *news = {Message::Kind::Good, write(*now), 0};
    } catch (...) {
      *news = {Message::Kind::Error, sentence_for_current_exception("Saving " + name), 0};
    }
    chore->result.post(std::move(news));
  });
  exports.push_back(std::move(chore));
}

bool Session::Impl::take_exports() {
  const auto is_done = [this](const std::shared_ptr<Chore<Message>>& chore) {
    const std::shared_ptr<const Message> news = chore->result.take();
    if (news) say(news->kind, news->text);
    return news != nullptr;
  };
  return std::erase_if(exports, is_done) > 0;
}

bool Session::Impl::take_split() {
  const std::shared_ptr<const Split> split = splitting ? splitting->result.take() : nullptr;
  if (!split) return false;
  splitting = nullptr;
  if (!split->fault.empty()) say(Message::Kind::Error, split->fault);
  const bool is_of_this = split->of == project().tree && !run;
  if (split->fault.empty() && is_of_this && split->edit.cut.empty())
    say(Message::Kind::Notice, "Every piece fits the paper already.");
  if (split->fault.empty() && is_of_this && !split->edit.cut.empty()) {
    const HandEdit edit = split->edit;
    Project next = netwright::edit_by_hand(project(), edit);
    next.placed = {};  // what is smaller now is laid out anew
    settled = stamp(std::make_shared<ShownNet>(*split->shown));
    is_unfinished = false;
    this->edit("split to fit", std::move(next));
  }
  return true;
}

bool Session::Impl::take_run() {
  if (!run) return false;
  run->tick(clock());
  // The outcome first: once it is there, the last snapshot is, too.
  const std::shared_ptr<const SearchRun::Outcome> outcome = run->take_outcome();
  const std::shared_ptr<ShownNet> picture = run->take_picture();
  if (picture) moving = stamp(picture);
  if (outcome) finish_run(*outcome);
  return picture || outcome;
}

void Session::Impl::watch_clock() {
  if (!run || time_limit_s <= 0 || is_timed_out || run->seconds() < time_limit_s) return;
  is_timed_out = true;
  run->cancel();
}

void Session::Impl::finish_run(const SearchRun::Outcome& outcome) {
  const std::unique_ptr<SearchRun> ended = std::move(run);
  discard_run();
  if (!outcome.result || outcome.result->net.placement.empty()) {
    if (!outcome.result) say(Message::Kind::Error, outcome.fault);
    return;
  }
  const SolveResult& result = *outcome.result;
  RunSummary summary;
  summary.seed = ended->options().seed;
  summary.moves = result.moves;
  summary.restarts = result.restarts;
  // A short run ends between two looks at the clock: its own count is nearer to the truth then.
  summary.seconds = ended->was_slowed() ? ended->seconds() : std::min(ended->seconds(), result.cpu_seconds);
  summary.overlaps = static_cast<int>(result.overlaps.size());
  summary.is_proved = result.is_proved;

  last_figures = ended->figures();
  last_figures->overlaps = last_figures->best_overlaps = summary.overlaps;
  last_figures->moves = summary.moves;
  last_figures->restarts = summary.restarts;
  last_figures->seconds = summary.seconds;
  if (summary.seconds > 0)
    last_figures->moves_per_second = static_cast<double>(summary.moves) / summary.seconds;
  if (result.polished && ended->options().polish)
    last_figures->unmet_wishes = unmet_wishes(*result.polished, ended->options().polish->settings);
  // A search that was told to stop while it waited had not shown its last moves: the log has them all.
  if (outcome.log) {
    last_figures->history = outcome.log->history(kMostChartValues, last_figures->history_stride);
    last_figures->overlaps_at_start = last_figures->history.front();
  }
  keep_run(outcome, summary);
  if (!result.is_proved) {
    show_unfinished(result, ended->options());
    return;
  }
  accept(result, summary);
  const bool was_unseen = ended->n_pictures() <= kFewPictures || ended->seconds() < kShortRun;
  if (!ended->was_slowed() && was_unseen) start_replay(outcome);
  if (!playing) say(Message::Kind::Good, std::exchange(good_news, {}));
}

void Session::Impl::accept(const SolveResult& result, const RunSummary& summary) {
  good_news = good_news_of(project().dual->mesh(), summary);
  is_unfinished = false;
  if (project().tree && *project().tree == result.net.tree) {  // the same seed again: nothing to undo
    settled = derived ? derived->shown : settled;
    return;
  }
  settled = stamp(std::make_shared<ShownNet>(
      make_shown_net(layout(project().dual, result.net.tree), result.overlaps, true)));
  Project next = accept_tree(project(), result.net.tree, summary);
  const bool is_of_drag = making.continues_step && (is_dragging || chore_making);
  if (is_of_drag || step_of_run == history.position()) {
    has_net_in_step = is_of_drag;
    history.amend(std::move(next));
    derive_again();
  } else {
    edit("unfold", std::move(next));
  }
  keeper.hurry();
}

void Session::Impl::show_unfinished(const SolveResult& result, const SolveOptions& options) {
  is_unfinished = true;
  failed_run = Failed{project().dual,
                      project().pins,
                      project().edits,
                      options,
                      std::make_shared<const Trouble>(find_trouble(result)),
                      nullptr,
                      nullptr,
                      result.isolated_face.is_valid() || result.impossible != nullptr};
  settled = stamp(std::make_shared<ShownNet>(
      make_shown_net(layout(project().dual, result.net.tree), result.overlaps, false)));
  say(Message::Kind::Notice, unfinished_news(result, *last_figures, is_timed_out));
}

void Session::Impl::start_replay(const SearchRun::Outcome& outcome) {
  if (!outcome.log || outcome.log->n_moves() == 0) return;
  const double now = clock();
  auto log = std::make_shared<const RunLog>(*outcome.log, RunLog::Extent::Followable);
  playing.emplace(Playing{Replay(std::move(log)), now, -1});
  show_replay();
}

bool Session::Impl::show_replay() {
  if (!playing) return false;
  Replay& replay = playing->replay;
  const double now = clock();
  const double share = (now - playing->started) / replay.seconds();
  if (share >= 1) {
    end_replay();
    return true;
  }
  const auto goal = static_cast<int>(share * replay.log().n_steps());
  const double gap = kPictureSecondsPerFace * static_cast<double>(project().dual->mesh().n_faces());
  if (moving && (goal <= replay.position() || now - playing->last_picture < gap)) return false;
  replay.seek(goal);
  playing->last_picture = now;
  Net net = replay.net();
  std::vector<Overlap> overlaps = find_overlaps(net, kShownDepth);
  auto shown = std::make_shared<ShownNet>(make_shown_net(std::move(net), std::move(overlaps), false));
  shown->last_move = replay.log().move(replay.position());
  moving = stamp(std::move(shown));
  return true;
}

void Session::Impl::end_replay() {
  if (!playing) return;
  playing.reset();
  moving = nullptr;
  say(Message::Kind::Good, std::exchange(good_news, {}));
}

RunFigures Session::Impl::replay_figures() const {
  RunFigures figures = settled_figures();
  const RunLog& log = playing->replay.log();
  const int at = playing->replay.position();
  figures.overlaps = static_cast<int>(moving->overlaps.size());
  figures.overlaps_at_start = log.overlaps(0);
  figures.best_overlaps = log.fewest_overlaps(at);
  figures.moves = log.moves(at);
  figures.restarts = log.restarts(at);
  figures.history.clear();
  for (int i = 0; i <= std::min(at, log.n_searched_steps() - 1); ++i)
    figures.history.push_back(log.overlaps(i));
  figures.history_stride = 1;
  show_polish_until(figures, log.polish_fraction(at));
  return figures;
}

RunFigures Session::Impl::settled_figures() const {
  if (last_figures) return *last_figures;
  if (const RunList::Entry accepted = accepted_run()) return accepted->figures;
  RunFigures figures;
  figures.seed = project().seed;
  if (project().dual) figures.faces = static_cast<int>(project().dual->mesh().n_faces());
  if (project().run) {
    const RunSummary& summary = *project().run;
    figures.seed = summary.seed;
    figures.moves = summary.moves;
    figures.restarts = summary.restarts;
    figures.seconds = summary.seconds;
    if (summary.seconds > 0) figures.moves_per_second = static_cast<double>(summary.moves) / summary.seconds;
  }
  return figures;
}

bool Session::Impl::poll() {
  const std::size_t n_told = messages.size();
  bool has_changed = take_opened();
  has_changed |= take_replaced();
  has_changed |= take_made();
  has_changed |= take_measured();
  has_changed |= take_derived();
  has_changed |= take_exports();
  has_changed |= take_split();
  has_changed |= take_releases();
  has_changed |= take_found_pieces();
  has_changed |= measure_pieces();
  has_changed |= take_found_softening();
  has_changed |= take_printers();
  has_changed |= take_leftovers();
  has_changed |= watch_files();
  has_changed |= take_view();
  has_changed |= show_replay();
  has_changed |= take_run();
  measure_when_idle();
  watch_clock();
  const int tenths = run ? static_cast<int>(run->seconds() * 10) : -1;
  has_changed |= std::exchange(shown_tenths, tenths) != tenths;
  return has_changed || messages.size() != n_told;
}

}  // namespace netwright
