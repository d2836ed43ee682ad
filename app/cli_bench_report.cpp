// The page is put together from the same figures as the terminal's tables. It has one style for light, dark
// and paper, and no script.
#include "app/cli_bench_report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <system_error>

#include "app/cli_bench_paper.h"
#include "app/cli_bench_plots.h"
#include "app/cli_bench_table.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace netwright {
namespace {

using Cells = std::vector<std::string>;

constexpr std::size_t kMostFailures = 100;

constexpr const char* kStyle = R"(<style>
:root { color-scheme: light dark; --ground: #f5f6f8; --card: #fff; --text: #1c2126; --soft: #5b636c; --line: #e3e6ea;
  --own: #0b62a8; --tint: #0b62a812; }
@media screen and (prefers-color-scheme: dark) { :root { --ground: #15181c; --card: #1d2126; --text: #e6e9ec;
  --soft: #a0a8b1; --line: #30363d; --own: #63b3f2; --tint: #63b3f21c; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 40px 20px 60px; max-width: 1020px; background: var(--ground); color: var(--text);
  font: 15px/1.5 "Inter", "Helvetica Neue", Arial, sans-serif; }
h1 { margin: 0 0 4px; font-size: 28px; }
h2 { margin: 40px 0 8px; font-size: 19px; }
p, dl { margin: 6px 0; max-width: 46em; }
.soft, dt, caption { color: var(--soft); }
caption { padding: 8px 8px 2px; text-align: left; }
.growth { font-size: 16px; max-width: none; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 2px 16px; max-width: none; }
dd { margin: 0; }
.card { margin: 14px 0; padding: 6px 16px; overflow-x: auto; background: var(--card); border: 1px solid var(--line);
  border-radius: 8px; }
table { width: 100%; border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 14px; }
th, td { padding: 6px 8px; text-align: right; white-space: nowrap; border-bottom: 1px solid var(--line); }
th:first-child, td:first-child, .words td { text-align: left; }
.words td { white-space: normal; }
th { font-weight: 600; color: var(--soft); }
tr:last-child td { border-bottom: 0; }
.own td { color: var(--own); background: var(--tint); font-weight: 600; }
.size td { padding-top: 14px; font-weight: 600; }
figure { margin: 14px 0; }
svg { display: block; width: 100%; max-width: 860px; height: auto; margin: 0 auto; }
figcaption { max-width: 60em; margin: 6px auto 0; color: var(--soft); font-size: 13.5px; }
@media print { body { padding: 0; background: #fff; font-size: 11px; } table { font-size: 10px; }
  th, td { padding: 3px 6px; } .size td { padding-top: 7px; } .growth { font-size: 13px; } svg { max-width: 560px; }
  tr, figure { break-inside: avoid; } h2, .size { break-after: avoid; } }
</style>
)";

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string row_of(const char* tag, const Cells& cells, const std::string& kind = "") {
  std::string row = kind.empty() ? "<tr>" : "<tr class=\"" + kind + "\">";
  for (const std::string& cell : cells) row += std::string("<") + tag + ">" + cell + "</" + tag + ">";
  return row + "</tr>\n";
}

std::string card(const std::string& rows, const std::string& kind = "") {
  return "<div class=\"card\"><table" + (kind.empty() ? "" : " class=\"" + kind + "\"") + ">\n" + rows +
         "</table></div>\n";
}

std::string heading(const std::string& words) { return "<h2>" + words + "</h2>\n"; }

Cells cells_of(const BenchStats& stats, std::string (*words)(double)) {
  Cells cells;
  for (const double value :
       {stats.min, stats.mean, stats.filtered_mean, stats.median, stats.p95, stats.p99, stats.max})
    cells.push_back(stats.n == 0 ? "–" : words(value));
  return cells;
}

std::string figures_cards(const std::vector<BenchFigures>& figures, const std::string& first,
                          const std::string& time_words) {
  const Cells stats{"min", "mean", "filtered mean", "median", "p95", "p99", "max"};
  Cells time_heads{first, "runs", "success", "refused"};
  time_heads.insert(time_heads.end(), stats.begin(), stats.end());
  // Where rows are sizes, the faces are told already.
  const bool are_folders = first == "folder";
  Cells iteration_heads{first, are_folders ? "faces" : "runs"};
  iteration_heads.insert(iteration_heads.end(), stats.begin(), stats.end());
  std::string times = "<caption>" + time_words + "</caption>\n" + row_of("th", time_heads);
  std::string iterations = "<caption>Iterations of the search</caption>\n" + row_of("th", iteration_heads);
  const std::vector<std::string> names = folder_names(figures);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const BenchFigures& f = figures[i];
    Cells cells{escaped(names[i]), std::to_string(f.n), success_words(f), std::to_string(f.n_refused)};
    Cells values = cells_of(f.times, duration_words);
    cells.insert(cells.end(), values.begin(), values.end());
    times += row_of("td", cells);
    const std::string faces = f.faces.n == 0 ? "–" : count_words(f.faces.mean);
    cells = {escaped(names[i]), are_folders ? faces : std::to_string(f.n)};
    values = cells_of(f.iterations, count_words);
    cells.insert(cells.end(), values.begin(), values.end());
    iterations += row_of("td", cells);
  }
  return card(times) + card(iterations);
}

std::string published(double seconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f s", seconds);
  return text.data();
}

Cells published_cells(const PaperProgram& program, const PaperFigures& f) {
  std::array<char, 32> success{};
  std::snprintf(success.data(), success.size(), "%.4g %%", f.success_percent);
  return {escaped(std::string(program.name)),
          f.min == 0 ? "under 0.5 ms" : published(f.min),
          published(f.mean),
          published(f.filtered_mean),
          published(f.max),
          success.data()};
}

std::string paper_card(const std::vector<BenchFigures>& sizes) {
  std::string rows = row_of("th", {"", "min", "mean", "filtered mean", "max", "success"});
  for (std::size_t i = 0; i < kPaperFaces.size(); ++i) {
    const std::string faces = std::to_string(kPaperFaces[i]);
    rows += "<tr class=\"size\"><td colspan=\"6\">" + faces + " faces</td></tr>\n";
    for (const BenchFigures& f : sizes) {
      if (f.folder != faces || f.times.n == 0) continue;
      rows += row_of("td",
                     {"Netwright", duration_words(f.times.min), duration_words(f.times.mean),
                      duration_words(f.times.filtered_mean), duration_words(f.times.max), success_words(f)},
                     "own");
    }
    for (const PaperProgram& program : kPaperPrograms)
      if (program.figures[i]) rows += row_of("td", published_cells(program, *program.figures[i]));
  }
  return card(rows);
}

std::string failures_card(const std::vector<BenchRow>& rows) {
  std::string lines = row_of("th", {"model", "faces", "seed", "overlaps left", "why"});
  std::size_t n = 0;
  for (const BenchRow& row : rows) {
    if (row.is_verified || ++n > kMostFailures) continue;
    const std::string overlaps = row.was_searched() ? std::to_string(row.overlaps) : "–";
    lines += row_of("td", {escaped(row.folder + "/" + row.model), std::to_string(row.faces),
                           std::to_string(row.seed), overlaps, escaped(row.note)});
  }
  if (n == 0) return heading("Without a net") + "<p>None: every run ended with a proved net.</p>\n";
  if (n > kMostFailures)
    lines += "<tr><td colspan=\"5\">and " + std::to_string(n - kMostFailures) + " more</td></tr>\n";
  return heading("Without a net") + card(lines, "words");
}

std::string facts(const BenchRecord& record) {
  std::set<std::string> models;
  std::set<std::int64_t> seeds;
  for (const BenchRow& row : record.rows) {
    models.insert(row.folder + "/" + row.model);
    seeds.insert(row.seed);
  }
  std::string seed_words;
  for (const std::int64_t seed : seeds) {
    if (seed_words.size() > 60) {
      seed_words += " … " + std::to_string(*seeds.rbegin());
      break;
    }
    seed_words += (seed_words.empty() ? "" : ", ") + std::to_string(seed);
  }
  std::string text = "<dl>\n";
  const auto add = [&](const std::string& what, const std::string& words) {
    text += "<dt>" + what + "</dt><dd>" + escaped(words) + "</dd>\n";
  };
  add("Search", record.options);
  for (const std::string& place : record.places) add("Measured with", place);
  add("Models", std::to_string(models.size()) + ", " + std::to_string(record.rows.size()) + " runs");
  add("Seeds", seed_words);
  return text + "</dl>\n";
}

std::string figure(const std::string& svg, const std::string& words) {
  return "<figure>" + svg + "<figcaption>" + words + "</figcaption></figure>\n";
}

/// "|F|^1.50, …" with the exponents raised.
std::string with_powers(const std::string& words) {
  std::string text;
  bool is_raised = false;
  for (const char c : words) {
    const bool is_number = (c >= '0' && c <= '9') || c == '.' || c == '-';
    if (is_raised && !is_number) text += "</sup>";
    is_raised = c == '^' || (is_raised && is_number);
    if (c == '^') {
      text += "<sup>";
    } else {
      text += c;
    }
  }
  return is_raised ? text + "</sup>" : text;
}

std::string plots_part(const BenchPlots& plots, const BenchGrowth& growth) {
  if (plots.time.empty()) {
    return "<p>There is nothing to plot: that takes folders whose models have all nearly the same number of "
           "faces.</p>\n";
  }
  const std::string words = growth_sentence(growth);
  return (words.empty() ? "" : "<p class=\"growth\">" + with_powers(words) + "</p>\n") +
         figure(
             plots.time,
             "As figure 6 of the paper: mean times without outliers. The band reaches from the shortest time "
             "to the longest; rings are medians, the dashed line through them is their fitted growth. The "
             "other programs' times are those the paper prints, from the authors' machine and models; the "
             "dashed line along theirs is the growth they estimate.") +
         figure(plots.success,
                "As figure 7: runs that end with a net in one piece. Netwright counts proved nets "
                "only; the paper's programs count their own nets.") +
         figure(plots.iterations,
                "As figure 8: iterations without outliers, with the line through the origin that "
                "comes nearest to the means; rings are medians.");
}

void write_if_any(const std::filesystem::path& path, const std::string& text) {
  if (!text.empty()) write_file(path, text);
}

}  // namespace

std::string bench_page(const BenchRecord& record, double BenchRow::*times, const std::string& time_words) {
  const std::vector<BenchFigures> sizes = bench_sizes(record.rows, times);
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Netwright "
      "bench</title>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
      std::string(kStyle) + "</head>\n<body>\n<h1>Netwright bench</h1>\n" +
      "<p class=\"soft\">Models unfolded into one piece each, one after the other; a net counts when it is "
      "proved.</p>\n" +
      facts(record);
  page += heading("By number of faces") + plots_part(bench_plots(sizes, time_words), bench_growth(sizes));
  if (!sizes.empty()) page += figures_cards(sizes, "faces", time_words);
  page +=
      heading("Beside the paper's Table 2") +
      "<p class=\"soft\">From section 5.1 of <em>Unfolding Polyhedra via Tabu Search</em>: 2800 models of "
      "Thingi10K, on the authors' machine. Other models and another machine: look at the order of magnitude. "
      "Filtered means leave out times above mean + 3 standard deviations.</p>\n" +
      paper_card(sizes);
  const std::vector<BenchFigures> folders = bench_figures(record.rows, times);
  if (folders.size() != sizes.size())
    page += heading("By folder") + figures_cards(folders, "folder", time_words);
  return page + failures_card(record.rows) + "</body>\n</html>\n";
}

void make_report_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure || !std::filesystem::is_directory(folder, failure)) {
    throw Error(ErrorKind::Write, "Cannot write a report into " + folder.string() +
                                      ": it is no folder and cannot be made one; choose another name.");
  }
}

void write_report(const std::filesystem::path& folder, const BenchRecord& record, double BenchRow::*times,
                  const std::string& time_words) {
  make_report_folder(folder);
  const BenchPlots plots = bench_plots(bench_sizes(record.rows, times), time_words);
  write_if_any(folder / "time.svg", plots.time);
  write_if_any(folder / "success.svg", plots.success);
  write_if_any(folder / "iterations.svg", plots.iterations);
  write_file(folder / "index.html", bench_page(record, times, time_words));
}

}  // namespace netwright
