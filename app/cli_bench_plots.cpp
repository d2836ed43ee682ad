// What goes into which picture. Both axes of times are logarithmic, so that growth by a power of the faces is
// a straight line; means are those without outliers, as in the paper's figures.
#include "app/cli_bench_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/vec2.hpp>

#include "app/cli_bench_chart.h"
#include "app/cli_bench_paper.h"

namespace netwright {
namespace {

using Points = std::vector<glm::dvec2>;
using Sizes = std::vector<BenchFigures>;

constexpr const char* kOwn = "own";
constexpr std::array<const char*, 3> kSeries{"tabu", "ots", "sa"};
constexpr std::array<ChartMark, 3> kMarks{ChartMark::Square, ChartMark::Triangle, ChartMark::Diamond};
/// A time shorter than this was not measured but rounded to 0.
constexpr double kLeastSeconds = 1e-6;

std::string format(const char* pattern, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), pattern, value);
  return text.data();
}

std::string tick_words(double seconds) {
  if (seconds < 0.9e-3) return format("%.3g µs", seconds * 1e6);
  return seconds < 0.9 ? format("%.3g ms", seconds * 1e3) : format("%.0f s", seconds);
}

template <class Value>
Points points_of(const Sizes& sizes, const Value& value) {
  Points points;
  for (const BenchFigures& f : sizes) points.emplace_back(f.faces.mean, value(f));
  return points;
}

template <class Value>
Points points_of(const PaperProgram& program, const Value& value) {
  Points points;
  for (std::size_t i = 0; i < kPaperFaces.size(); ++i)
    if (program.figures[i]) points.emplace_back(kPaperFaces[i], value(*program.figures[i]));
  return points;
}

/// From the smallest to the largest model, the paper's among them where the axis is logarithmic, with ticks
/// at the sizes themselves as far as there is room.
ChartScale faces_scale(const Sizes& sizes, bool is_log) {
  std::vector<double> faces;
  if (is_log) faces.assign(kPaperFaces.begin(), kPaperFaces.end());
  for (const BenchFigures& f : sizes) faces.push_back(f.faces.mean);
  std::ranges::sort(faces);
  ChartScale scale{faces.front(), faces.back(), is_log};
  scale.low = is_log ? faces.front() / 1.12 : 0;
  scale.high = is_log ? faces.back() * 1.04 : faces.back() * 1.03;
  double last = -1;
  for (const double value : faces) {
    const double share = scale.share(value);
    if (share - last < 0.055) continue;
    scale.ticks.push_back({value, format("%.0f", value)});
    last = share;
  }
  return scale;
}

/// The law from the first to the last of these places, in steps that look round on any scale.
template <class Law>
Points law_points(double from, double to, const Law& law) {
  Points points;
  constexpr int kSteps = 40;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = from * std::pow(to / from, static_cast<double>(i) / kSteps);
    points.emplace_back(x, law(x));
  }
  return points;
}

std::string power_words(const char* what, double exponent) {
  return std::string(what) + R"( ∝ |F|<tspan dy="-5" font-size="10">)" + format("%.2f", exponent) +
         "</tspan>";
}

/// c |F|³ log |F|, the authors' estimate of their own program's growth, through their figures.
Points paper_estimate(const PaperProgram& program) {
  const auto law = [](double faces) { return faces * faces * faces * std::log(faces); };
  double logs = 0;
  const Points points = points_of(program, [](const PaperFigures& f) { return f.filtered_mean; });
  for (const glm::dvec2 p : points) logs += std::log(p.y / law(p.x)) / static_cast<double>(points.size());
  return law_points(points.front().x, points.back().x, [&](double x) { return std::exp(logs) * law(x); });
}

void add_paper_times(Chart& chart) {
  for (std::size_t i = 0; i < kPaperPrograms.size(); ++i) {
    const Points points = points_of(kPaperPrograms[i], [](const PaperFigures& f) { return f.filtered_mean; });
    chart.curve(points, kSeries[i]);
    chart.marks(points, kSeries[i], kMarks[i]);
    chart.label(points.back(), std::string(kPaperPrograms[i].label), kSeries[i]);
  }
  const Points estimate = paper_estimate(kPaperPrograms[0]);
  chart.curve(estimate, kSeries[0], ChartStroke::Dashed);
  chart.label(estimate.back(),
              R"(their c |F|<tspan dy="-5" font-size="10">3</tspan><tspan dy="5">&#160;log |F|</tspan>)",
              kSeries[0]);
}

void add_median_law(Chart& chart, const Sizes& sizes) {
  const BenchGrowth growth = bench_growth(sizes);
  if (!growth.median_time) return;
  const PowerLaw law = *growth.median_time;
  chart.curve(law_points(growth.least_faces, growth.most_faces, [&](double x) { return law.at(x); }), kOwn,
              ChartStroke::Dashed);
  chart.label({growth.most_faces, law.at(growth.most_faces)}, power_words("median", law.exponent), kOwn);
}

std::string time_plot(const Sizes& sizes, const std::string& time_words) {
  const auto curve_of = [&](double BenchStats::*figure) {
    return points_of(sizes, [&](const BenchFigures& f) { return std::max(f.times.*figure, kLeastSeconds); });
  };
  const Points least = curve_of(&BenchStats::min);
  const Points mean = curve_of(&BenchStats::filtered_mean);
  const Points most = curve_of(&BenchStats::max);
  double low = 1e-3;
  double high = 1e3;
  for (const glm::dvec2 p : least) low = std::min(low, p.y);
  for (const glm::dvec2 p : most) high = std::max(high, p.y);
  ChartScale y{low / 1.5, high * 1.5, true};
  y.ticks = decade_ticks(y.low, y.high, tick_words);
  Chart chart({"Time to unfold one model", "Faces", time_words}, faces_scale(sizes, true), y);
  add_paper_times(chart);
  chart.band(least, most, kOwn);
  chart.curve(mean, kOwn);
  chart.marks(mean, kOwn, ChartMark::Circle);
  chart.label(mean.back(), "Netwright, mean", kOwn);
  chart.label(most.back(), "longest", kOwn);
  chart.label(least.back(), "shortest", kOwn);
  add_median_law(chart, sizes);
  chart.marks(curve_of(&BenchStats::median), kOwn, ChartMark::Ring);
  return std::move(chart).svg();
}

std::string success_plot(const Sizes& sizes) {
  ChartScale y{0, 104, false};
  for (const int percent : {0, 20, 40, 60, 80, 100})
    y.ticks.push_back({static_cast<double>(percent), std::to_string(percent) + " %"});
  Chart chart({"Models unfolded into one piece", "Faces", "Success"}, faces_scale(sizes, true), y);
  for (std::size_t i = 0; i < kPaperPrograms.size(); ++i) {
    const Points points =
        points_of(kPaperPrograms[i], [](const PaperFigures& f) { return f.success_percent; });
    chart.curve(points, kSeries[i]);
    chart.marks(points, kSeries[i], kMarks[i]);
    chart.label(points.back(), std::string(kPaperPrograms[i].label) + format(", %.4g %%", points.back().y),
                kSeries[i]);
  }
  const Points own = points_of(sizes, [](const BenchFigures& f) { return 100.0 * f.n_proved / f.n; });
  chart.curve(own, kOwn);
  chart.marks(own, kOwn, ChartMark::Circle);
  chart.label(own.back(), "Netwright, " + success_words(sizes.back()), kOwn);
  return std::move(chart).svg();
}

std::string iterations_plot(const Sizes& sizes) {
  const auto mean = [](const BenchFigures& f) { return f.iterations.filtered_mean; };
  const auto median = [](const BenchFigures& f) { return f.iterations.median; };
  double high = 1;
  std::vector<double> faces;
  std::vector<double> means;
  for (const BenchFigures& f : sizes) {
    high = std::max({high, mean(f), median(f)});
    faces.push_back(f.faces.mean);
    means.push_back(mean(f));
  }
  ChartScale y{0, high * 1.08};
  y.ticks = round_ticks(y.high);
  Chart chart({"Iterations of the search", "Faces", "Iterations"}, faces_scale(sizes, false), y);
  const double factor = proportional_fit(faces, means);
  const glm::dvec2 end(faces.back(), factor * faces.back());
  chart.curve({{0, 0}, end}, kOwn, ChartStroke::Dashed);
  chart.label(end, "line " + format("%.3g |F|", factor), kOwn);
  chart.curve(points_of(sizes, mean), kOwn);
  chart.marks(points_of(sizes, mean), kOwn, ChartMark::Circle);
  chart.label(points_of(sizes, mean).back(), "mean", kOwn);
  chart.curve(points_of(sizes, median), kOwn, ChartStroke::Thin);
  chart.marks(points_of(sizes, median), kOwn, ChartMark::Ring);
  chart.label(points_of(sizes, median).back(), "median", kOwn);
  return std::move(chart).svg();
}

}  // namespace

BenchPlots bench_plots(std::vector<BenchFigures> sizes, const std::string& time_words) {
  std::erase_if(sizes, [](const BenchFigures& f) { return f.times.n == 0; });
  if (sizes.empty()) return {};
  return {time_plot(sizes, time_words), success_plot(sizes), iterations_plot(sizes)};
}

}  // namespace netwright
