// Grouping, figures in words, and columns.
#include "app/cli_bench_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>

namespace netwright {
namespace {

using Line = std::vector<std::string>;

template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), pattern, values...);
  return text.data();
}

/// Three digits that count.
std::string duration(double seconds) {
  const bool is_short = seconds < 0.9995;
  const double value = is_short ? seconds * 1000 : seconds;
  const int decimals = value < 0.9995 ? 3 : value < 9.995 ? 2 : value < 99.95 ? 1 : 0;
  return format("%.*f %s", decimals, value, is_short ? "ms" : "s");
}

/// Rounded down, so that "100 %" means every single one.
double percent(const BenchFigures& figures) {
  return figures.n == 0 ? 0 : std::floor(10000.0 * figures.n_proved / figures.n) / 100;
}

std::array<double, 7> in_order(const BenchStats& s) {
  return {s.min, s.mean, s.filtered_mean, s.median, s.p95, s.p99, s.max};
}

std::string last_name(const std::string& folder) {
  const std::string name = std::filesystem::path(folder).filename().string();
  return name.empty() ? folder : name;
}

/// How wide a text is on the screen: bytes that go on a character of UTF-8 take no room.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The first column to the left, numbers to the right.
std::string aligned(const std::vector<Line>& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const Line& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width(line[i]));
  std::string text;
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string room(widths[i] - width(line[i]), ' ');
      text += i == 0 ? line[i] + room : "  " + room + line[i];
    }
    text += "\n";
  }
  text.pop_back();
  return text;
}

}  // namespace

std::vector<BenchFigures> bench_figures(const std::vector<BenchRow>& rows, double BenchRow::*times) {
  std::vector<BenchFigures> figures;
  std::vector<std::vector<double>> values;
  for (const BenchRow& row : rows) {
    auto found = std::find_if(figures.begin(), figures.end(),
                              [&](const BenchFigures& f) { return f.folder == row.folder; });
    if (found == figures.end()) {
      found = figures.insert(figures.end(), BenchFigures{row.folder, 0, 0, 0, {}});
      values.emplace_back();
    }
    ++found->n;
    if (row.is_verified) ++found->n_proved;
    if (row.was_searched()) {
      values[static_cast<std::size_t>(found - figures.begin())].push_back(row.*times);
    } else {
      ++found->n_refused;
    }
  }
  for (std::size_t i = 0; i < figures.size(); ++i) figures[i].times = bench_stats(std::move(values[i]));
  return figures;
}

std::string bench_table(const std::vector<BenchFigures>& figures) {
  std::set<std::string> names;
  for (const BenchFigures& f : figures) names.insert(last_name(f.folder));
  const bool are_unlike = names.size() == figures.size();
  std::vector<Line> lines{
      {"folder", "n", "success", "refused", "min", "mean", "filtered", "median", "p95", "p99", "max"}};
  for (const BenchFigures& f : figures) {
    Line line{are_unlike ? last_name(f.folder) : f.folder, std::to_string(f.n), format("%.4g %%", percent(f)),
              std::to_string(f.n_refused)};
    for (const double time : in_order(f.times)) line.push_back(f.times.n == 0 ? "–" : duration(time));
    lines.push_back(std::move(line));
  }
  return aligned(lines);
}

std::vector<std::string> bench_summary(const std::vector<BenchFigures>& figures) {
  std::vector<std::string> lines{
      "folder\tn\tsuccess_percent\trefused\tmin\tmean\tfiltered_mean\tmedian\tp95\tp99\tmax"};
  for (const BenchFigures& f : figures) {
    std::string line = f.folder + "\t" + std::to_string(f.n) + "\t" + format("%.2f", percent(f)) + "\t" +
                       std::to_string(f.n_refused);
    for (const double time : in_order(f.times)) line += f.times.n == 0 ? "\t" : format("\t%.9f", time);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace netwright
