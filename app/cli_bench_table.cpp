// Grouping, figures in words, columns and growth.
#include "app/cli_bench_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
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

double percent(const BenchFigures& figures) {
  return figures.n == 0 ? 0 : std::floor(10000.0 * figures.n_proved / figures.n) / 100;
}

/// Of how many faces the models of one folder may differ, and the means of folders of one size.
constexpr double kSameSize = 0.1;
constexpr double kSameMean = 0.05;

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

/// Numbers of one group of rows, to be worked out together.
struct Values {
  std::vector<double> times;
  std::vector<double> faces;
  std::vector<double> iterations;
};

/// Figures of rows that share the text that `key` gives them, in the order of first appearance.
template <class Key>
std::vector<BenchFigures> figures_by(const std::vector<BenchRow>& rows, double BenchRow::*times,
                                     const Key& key) {
  std::vector<BenchFigures> figures;
  std::vector<Values> values;
  for (const BenchRow& row : rows) {
    const std::string name = key(row);
    if (name.empty()) continue;
    auto found =
        std::find_if(figures.begin(), figures.end(), [&](const BenchFigures& f) { return f.folder == name; });
    if (found == figures.end()) {
      found = figures.insert(figures.end(), BenchFigures{name, 0, 0, 0, {}, {}, {}});
      values.emplace_back();
    }
    ++found->n;
    if (row.is_verified) ++found->n_proved;
    if (!row.was_searched()) ++found->n_refused;
    if (!row.was_searched()) continue;
    Values& group = values[static_cast<std::size_t>(found - figures.begin())];
    group.times.push_back(row.*times);
    group.faces.push_back(static_cast<double>(row.faces));
    group.iterations.push_back(static_cast<double>(row.iterations));
  }
  for (std::size_t i = 0; i < figures.size(); ++i) {
    figures[i].times = bench_stats(std::move(values[i].times));
    figures[i].faces = bench_stats(std::move(values[i].faces));
    figures[i].iterations = bench_stats(std::move(values[i].iterations));
  }
  return figures;
}

/// By folder, the mean number of faces of its size; folders without one size are not in it.
std::map<std::string, std::string> sizes_of_folders(std::vector<BenchFigures> folders) {
  std::erase_if(folders, [](const BenchFigures& f) {
    return f.faces.n == 0 || f.faces.max - f.faces.min > kSameSize * f.faces.mean;
  });
  std::ranges::stable_sort(folders, {}, [](const BenchFigures& f) { return f.faces.mean; });
  std::map<std::string, std::string> sizes;
  double mean = 0;
  for (const BenchFigures& f : folders) {
    if (f.faces.mean > mean * (1 + kSameMean)) mean = f.faces.mean;
    sizes[f.folder] = std::to_string(std::lround(mean));
  }
  return sizes;
}

}  // namespace

std::string duration_words(double seconds) {
  const bool is_short = seconds < 0.9995;
  const double value = is_short ? seconds * 1000 : seconds;
  const int decimals = value < 0.9995 ? 3 : value < 9.995 ? 2 : value < 99.95 ? 1 : 0;
  return format("%.*f %s", decimals, value, is_short ? "ms" : "s");
}

std::string count_words(double count) {
  if (count == std::floor(count)) return format("%.0f", count);
  return format("%.*f", count < 9.995 ? 2 : count < 99.95 ? 1 : 0, count);
}

std::string success_words(const BenchFigures& figures) { return format("%.4g %%", percent(figures)); }

std::vector<std::string> folder_names(const std::vector<BenchFigures>& figures) {
  std::set<std::string> names;
  for (const BenchFigures& f : figures) names.insert(last_name(f.folder));
  const bool are_unlike = names.size() == figures.size();
  std::vector<std::string> found;
  for (const BenchFigures& f : figures) found.push_back(are_unlike ? last_name(f.folder) : f.folder);
  return found;
}

std::vector<BenchFigures> bench_figures(const std::vector<BenchRow>& rows, double BenchRow::*times) {
  return figures_by(rows, times, [](const BenchRow& row) { return row.folder; });
}

std::vector<BenchFigures> bench_sizes(const std::vector<BenchRow>& rows, double BenchRow::*times) {
  const std::map<std::string, std::string> sizes = sizes_of_folders(bench_figures(rows, times));
  std::vector<BenchFigures> figures = figures_by(rows, times, [&](const BenchRow& row) {
    const auto found = sizes.find(row.folder);
    return found == sizes.end() ? std::string() : found->second;
  });
  std::ranges::stable_sort(figures, {}, [](const BenchFigures& f) { return f.faces.mean; });
  for (BenchFigures& f : figures) f.folder = std::to_string(std::lround(f.faces.mean));
  return figures;
}

BenchGrowth bench_growth(const std::vector<BenchFigures>& sizes) {
  BenchGrowth growth;
  if (sizes.empty()) return growth;
  growth.least_faces = sizes.front().faces.mean;
  growth.most_faces = sizes.back().faces.mean;
  growth.n_sizes = static_cast<int>(sizes.size());
  std::vector<double> faces;
  std::vector<double> medians;
  std::vector<double> means;
  std::vector<double> iterations;
  for (const BenchFigures& f : sizes) {
    faces.push_back(f.faces.mean);
    medians.push_back(f.times.median);
    means.push_back(f.times.mean);
    iterations.push_back(f.iterations.mean);
  }
  growth.median_time = power_fit(faces, medians);
  growth.mean_time = power_fit(faces, means);
  growth.mean_iterations = power_fit(faces, iterations);
  return growth;
}

std::string growth_sentence(const BenchGrowth& growth) {
  std::string laws;
  const auto add = [&](const char* name, const std::optional<PowerLaw>& law) {
    if (law) laws += (laws.empty() ? "" : ", ") + std::string(name) + format(" |F|^%.2f", law->exponent);
  };
  add("median time", growth.median_time);
  add("mean time", growth.mean_time);
  add("mean iterations", growth.mean_iterations);
  if (laws.empty()) return {};
  return format("Growth with the number of faces |F|, %.0f to %.0f", growth.least_faces, growth.most_faces) +
         format(" (%d sizes): ", growth.n_sizes) + laws;
}

std::string bench_table(const std::vector<BenchFigures>& figures) {
  const std::vector<std::string> names = folder_names(figures);
  std::vector<Line> lines{
      {"folder", "n", "success", "refused", "min", "mean", "filtered", "median", "p95", "p99", "max"}};
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const BenchFigures& f = figures[i];
    Line line{names[i], std::to_string(f.n), success_words(f), std::to_string(f.n_refused)};
    for (const double time : in_order(f.times)) line.push_back(f.times.n == 0 ? "–" : duration_words(time));
    lines.push_back(std::move(line));
  }
  return aligned(lines);
}

std::string iterations_table(const std::vector<BenchFigures>& figures) {
  const std::vector<std::string> names = folder_names(figures);
  std::vector<Line> lines{{"folder", "faces", "min", "mean", "filtered", "median", "p95", "p99", "max"}};
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const BenchFigures& f = figures[i];
    Line line{names[i], f.faces.n == 0 ? "–" : count_words(f.faces.mean)};
    for (const double count : in_order(f.iterations))
      line.push_back(f.iterations.n == 0 ? "–" : count_words(count));
    lines.push_back(std::move(line));
  }
  return aligned(lines);
}

std::vector<std::string> bench_summary(const std::vector<BenchFigures>& figures) {
  std::vector<std::string> lines{
      "folder\tn\tsuccess_percent\trefused\tmin\tmean\tfiltered_mean\tmedian\tp95\tp99\tmax\tfaces_mean\t"
      "iterations_mean\titerations_filtered_mean\titerations_median"};
  for (const BenchFigures& f : figures) {
    std::string line = f.folder + "\t" + std::to_string(f.n) + "\t" + format("%.2f", percent(f)) + "\t" +
                       std::to_string(f.n_refused);
    for (const double time : in_order(f.times)) line += f.times.n == 0 ? "\t" : format("\t%.9f", time);
    for (const double count :
         {f.faces.mean, f.iterations.mean, f.iterations.filtered_mean, f.iterations.median})
      line += f.times.n == 0 ? "\t" : format("\t%.9g", count);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace netwright
