// netwright-cli bench: every model with every seed, one after the other on the same threads, so that no run
// pays for new ones; each run leaves a row, and the rows of a folder come to one line of figures.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/cli_bench_log.h"
#include "app/cli_bench_place.h"
#include "app/cli_bench_plan.h"
#include "app/cli_bench_polish.h"
#include "app/cli_bench_report.h"
#include "app/cli_bench_table.h"
#include "app/cli_commands.h"
#include "app/cli_report.h"
#include "app/cli_watch.h"
#include "core/base/worker.h"
#include "core/mesh/read.h"
#include "core/mesh/repair.h"
#include "core/solve/prove_impossible.h"
#include "core/unfold/obstruction.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;

constexpr int kDone = 0;
constexpr int kCancelled = 130;

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

/// Everything that the figures of a run depend on, apart from its model and seed.
std::string settings_words(const BenchCommand& command) {
  return "streams " + std::to_string(command.streams) + ", threads " + std::to_string(command.threads) +
         ", search " + (command.search == SearchStyle::Paper ? "paper" : "fast") + ", time limit " +
         (command.time_limit_s > 0 ? number(command.time_limit_s) + " s" : "none");
}

/// A line on the terminal that tells which run it is; nothing when standard error is no terminal.
class RunLine {
 public:
  explicit RunLine(std::size_t n_runs) : is_shown_(isatty(STDERR_FILENO) == 1), n_runs_(n_runs) {}
  ~RunLine() {
    if (is_shown_) std::fputs("\r\x1b[K", stderr);
  }
  RunLine(const RunLine&) = delete;
  RunLine& operator=(const RunLine&) = delete;

  /// Many runs are over before anybody could read their names, so their lines are skipped.
  void begin(std::size_t run, const std::string& what) {
    words_ = "Run " + std::to_string(run) + " of " + std::to_string(n_runs_) + " · " + what;
    if (now_seconds() - shown_at_ >= kReadableSeconds) show(0);
  }
  void show(double seconds) {
    if (!is_shown_) return;
    shown_at_ = now_seconds();
    std::fprintf(stderr, "\r\x1b[K%s · %.1f s", words_.c_str(), seconds);
    std::fflush(stderr);
  }

 private:
  static constexpr double kReadableSeconds = 0.1;
  bool is_shown_;
  std::size_t n_runs_;
  double shown_at_ = 0;
  std::string words_;
};

/// A model as read: what can be searched, or why it cannot.
struct BenchModel {
  std::shared_ptr<const DualGraph> dual;
  std::int64_t n_faces = 0;
  std::string refusal;
};

BenchModel read_model(const fs::path& path) {
  BenchModel model;
  try {
    const PreparedModel prepared = prepare(read_soup(path));
    model.n_faces = prepared.report.n_faces;
    model.refusal = prepared.refusal;
    if (prepared.is_fit()) model.dual = std::make_shared<const DualGraph>(prepared.mesh);
  } catch (const std::exception& failure) {
    model.refusal = failure.what();
  }
  return model;
}

/// Which times tell most, and what they are called: the wall clock tells something of its own only when
/// several searches share it.
struct TimesShown {
  double BenchRow::*times;
  const char* words;
  const char* column;
};
constexpr TimesShown kCpuTimes{&BenchRow::cpu_seconds, "CPU time of the search", "cpu_seconds"};
constexpr TimesShown kWallTimes{&BenchRow::wall_seconds, "Wall-clock time of search and proof",
                                "wall_seconds"};

/// Prints the tables of these times; returns them as lines for the file of rows.
std::vector<std::string> tell_times(const BenchRecord& record, const TimesShown& shown) {
  const std::vector<BenchFigures> figures = bench_figures(record.rows, shown.times);
  print(std::string(shown.words) + " (" + record.options.substr(record.options.find(": ") + 2) + ")");
  print(bench_table(figures));
  std::vector<std::string> lines = bench_summary(figures);
  lines.insert(lines.begin(),
               std::string(shown.column) + " of all rows above that were searched, by folder:");
  const std::string growth = growth_sentence(bench_growth(bench_sizes(record.rows, shown.times)));
  if (!growth.empty()) {
    print(growth);
    lines.push_back(growth);
  }
  return lines;
}

std::vector<std::string> tell_figures(const BenchRecord& record, int streams) {
  std::vector<std::string> lines = tell_times(record, kCpuTimes);
  if (streams > 1) {
    const std::vector<std::string> more = tell_times(record, kWallTimes);
    lines.insert(lines.end(), more.begin(), more.end());
  }
  print("Iterations of the search");
  print(iterations_table(bench_figures(record.rows, kCpuTimes.times)));
  return lines;
}

void report(const fs::path& folder, const BenchRecord& record, int streams) {
  if (folder.empty()) return;
  const TimesShown& shown = streams > 1 ? kWallTimes : kCpuTimes;
  write_report(folder, record, shown.times, shown.words);
  print("Report: " + (folder / "index.html").string());
}

/// The figures of a table that is there already.
int report_table(const BenchCommand& command) {
  const BenchRecord record = read_bench(command.tsv);
  const int streams = record.options.find(": streams 1,") == std::string::npos ? 2 : 1;
  tell_figures(record, streams);
  report(command.report, record, streams);
  return kDone;
}

class Bench {
 public:
  explicit Bench(const BenchCommand& command)
      : command_(command), groups_(bench_plan(command.paths)), n_runs_(count_runs()) {
    if (!command.report.empty()) make_report_folder(command.report);
    log_ = command.tsv.empty() ? std::make_unique<BenchLog>(options_line(), bench_place())
                               : std::make_unique<BenchLog>(command.tsv, options_line(), bench_place());
  }

  int run() {
    tell_what_is_there();
    {
      RunLine line(n_runs_);
      for (const BenchGroup& group : groups_)
        for (const fs::path& model : group.models)
          if (!run_model(group, model, line)) break;
    }
    if (was_interrupted_) return tell_stop();
    log_->finish(tell_figures(log_->record(), command_.streams));
    if (const std::string table = polish_.text(); !table.empty()) print(table);
    report(command_.report, log_->record(), command_.streams);
    return kDone;
  }

 private:
  [[nodiscard]] std::size_t count_runs() const {
    std::size_t n = 0;
    for (const BenchGroup& group : groups_)
      n += group.models.size() * static_cast<std::size_t>(command_.seeds);
    return n;
  }

  [[nodiscard]] std::string options_line() const {
    return "netwright-cli bench " NETWRIGHT_VERSION ": " + settings_words(command_);
  }

  [[nodiscard]] bool is_done(const BenchGroup& group, const fs::path& model, std::int64_t seed) const {
    return log_->has(group.name, model.filename().string(), seed);
  }

  void tell_what_is_there() {
    std::size_t n = 0;
    for (const BenchGroup& group : groups_)
      for (const fs::path& model : group.models)
        for (std::int64_t seed = 0; seed < command_.seeds; ++seed)
          if (is_done(group, model, seed)) ++n;
    if (n == 0) return;
    complain("note: " + std::to_string(n) + " of " + std::to_string(n_runs_) + " runs are in " +
             command_.tsv.string() + " already and are not repeated.");
  }

  /// All seeds that are not done. False when the user stopped it.
  bool run_model(const BenchGroup& group, const fs::path& path, RunLine& line) {
    std::optional<BenchModel> model;
    for (std::int64_t seed = 0; seed < command_.seeds && !was_interrupted_; ++seed) {
      ++run_;
      if (is_done(group, path, seed)) continue;
      line.begin(run_, path.string() + " · seed " + std::to_string(seed));
      if (!model) {
        model.emplace();
        watch(line, {}, [&](Progress&) { *model = read_model(path); });
      }
      BenchRow row;
      row.folder = group.name;
      row.model = path.filename().string();
      row.faces = model->n_faces;
      row.seed = seed;
      row.note = model->refusal;
      if (!was_interrupted_ && model->dual != nullptr) search(*model, row, line);
      if (!was_interrupted_) log_->add(row);
    }
    return !was_interrupted_;
  }

  void search(const BenchModel& model, BenchRow& row, RunLine& line) {
    SolveOptions options;
    options.seed = static_cast<std::uint64_t>(row.seed);
    options.streams = command_.streams;
    options.threads = command_.threads;
    options.search = command_.search;
    if (command_.polish > 0) options.polish = bench_polish(model.dual->mesh(), command_.polish);
    if (!pool_) pool_ = std::make_unique<ThreadPool>(n_threads(options));
    SolveHooks hooks;
    hooks.pool = pool_.get();
    const auto limit = command_.time_limit_s > 0 ? std::optional(command_.time_limit_s) : std::nullopt;
    try {
      const Watched watched = watch(line, limit, [&](Progress& progress) {
        const double start = now_seconds();
        const SolveResult result = solve(model.dual, options, progress, hooks);
        row.wall_seconds = now_seconds() - start - result.finish_seconds;
        enter(result, row);
        polish_.add(row.folder, result);
      });
      if (!row.is_solved && row.note.empty())
        row.note =
            watched.was_out_of_time ? "the time was up" : "the final check refused what the search had found";
    } catch (const std::exception& failure) {
      row.note = failure.what();
    }
  }

  static void enter(const SolveResult& result, BenchRow& row) {
    row.is_solved = result.overlaps.empty();
    row.is_verified = result.is_proved;
    row.overlaps = static_cast<std::int64_t>(result.overlaps.size());
    row.iterations = result.iterations;
    row.moves = result.moves;
    row.restarts = result.restarts;
    row.cpu_seconds = result.cpu_seconds;
    row.verify_seconds = result.verify_seconds;
    if (!result.proof.faults.empty()) row.note = result.proof.faults.front();
    if (result.impossible != nullptr) row.note = impossible_sentence(result.net.mesh());
    if (result.isolated_face.is_valid())
      row.note = isolated_face_sentence(result.net.mesh(), result.isolated_face);
  }

  Watched watch(RunLine& line, std::optional<double> limit, const std::function<void(Progress&)>& job) {
    const Watched watched =
        run_watched(worker_, interrupts_, job, limit, [&line](double seconds) { line.show(seconds); });
    was_interrupted_ = was_interrupted_ || watched.was_interrupted;
    return watched;
  }

  int tell_stop() const {
    std::string words = "Stopped after " + std::to_string(log_->record().rows.size()) + " of " +
                        std::to_string(n_runs_) + " runs";
    if (!command_.tsv.empty())
      words += "; the same command goes on behind the last row in " + command_.tsv.string();
    complain(words + ".");
    return kCancelled;
  }

  const BenchCommand& command_;
  std::vector<BenchGroup> groups_;
  std::size_t n_runs_;
  std::size_t run_ = 0;  // the one that is on, counted from 1
  bool was_interrupted_ = false;
  std::unique_ptr<BenchLog> log_;
  PolishTable polish_;
  Interrupts interrupts_;  // before the worker, whose threads have to hold Ctrl-C back as well
  Worker worker_;
  std::unique_ptr<ThreadPool> pool_;  // made with the first run
};

}  // namespace

int run_bench(const BenchCommand& command) {
  return command.paths.empty() ? report_table(command) : Bench(command).run();
}

}  // namespace netwright
