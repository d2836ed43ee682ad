// Everything is drawn in one coordinate system of kWidth × kHeight. The page's style cannot reach a picture
// that stands alone, so each one brings its own.
#include "app/cli_bench_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace netwright {
namespace {

constexpr double kWidth = 760;
constexpr double kHeight = 440;
constexpr double kLeft = 76;
constexpr double kRight = 178;  // room for the labels at the curves' ends
constexpr double kTop = 52;
constexpr double kBottom = 58;
constexpr double kLabelHeight = 16;
constexpr double kLabelWidth = 170;
constexpr double kMark = 4.5;

constexpr const char* kStyle = R"(<style>
.chart { font: 13px "Inter", "Helvetica Neue", Arial, sans-serif; }
.chart .ground { fill: #ffffff; }
.chart text { fill: #4a5058; }
.chart .title { fill: #1c2126; font-size: 16px; font-weight: 600; }
.chart .grid { stroke: #e3e6ea; stroke-width: 1; }
.chart .axis { stroke: #9aa2ab; stroke-width: 1; }
.chart .own { stroke: #0b62a8; fill: #0b62a8; }
.chart .tabu { stroke: #c4500a; fill: #c4500a; }
.chart .ots { stroke: #2c7a51; fill: #2c7a51; }
.chart .sa { stroke: #8a4f9e; fill: #8a4f9e; }
.chart .curve { fill: none; stroke-width: 2.2; stroke-linejoin: round; }
.chart .thin { stroke-width: 1.2; }
.chart .dashed { stroke-width: 1.4; stroke-dasharray: 6 4; }
.chart .band { stroke: none; fill-opacity: 0.14; }
.chart .mark { stroke-width: 1.4; }
.chart .ring { fill: #ffffff; }
.chart .label { stroke: none; font-weight: 500; }
@media screen and (prefers-color-scheme: dark) {
.chart .ground { fill: #1d2126; }
.chart text { fill: #a9b1ba; }
.chart .title { fill: #eceff2; }
.chart .grid { stroke: #30363d; }
.chart .axis { stroke: #6a737d; }
.chart .own { stroke: #63b3f2; fill: #63b3f2; }
.chart .tabu { stroke: #f28a4b; fill: #f28a4b; }
.chart .ots { stroke: #5cc48f; fill: #5cc48f; }
.chart .sa { stroke: #c792dc; fill: #c792dc; }
.chart .curve { fill: none; }
.chart .band { stroke: none; fill-opacity: 0.2; }
.chart .ring { fill: #1d2126; }
.chart .label { stroke: none; }
}
</style>
)";

template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), pattern, values...);
  return text.data();
}

std::string text_at(glm::dvec2 at, const std::string& attributes, const std::string& words) {
  return format("<text x=\"%.1f\" y=\"%.1f\" ", at.x, at.y) + attributes + ">" + words + "</text>\n";
}

std::string line(const char* kind, glm::dvec2 a, glm::dvec2 b) {
  return format("<line class=\"%s\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>\n", kind, a.x, a.y, b.x,
                b.y);
}

std::string mark_at(glm::dvec2 p, ChartMark mark) {
  const double r = kMark;
  switch (mark) {
    case ChartMark::Circle:
    case ChartMark::Ring:
      return format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>\n", p.x, p.y, r);
    case ChartMark::Square:
      return format("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>\n", p.x - 0.85 * r,
                    p.y - 0.85 * r, 1.7 * r, 1.7 * r);
    case ChartMark::Triangle:
      return format("<path d=\"M%.1f %.1fl%.1f %.1fh%.1fz\"/>\n", p.x, p.y - 1.15 * r, 1.1 * r, 1.9 * r,
                    -2.2 * r);
    case ChartMark::Diamond:
      return format("<path d=\"M%.1f %.1fl%.1f %.1fl%.1f %.1fl%.1f %.1fz\"/>\n", p.x, p.y - 1.2 * r, 1.2 * r,
                    1.2 * r, -1.2 * r, 1.2 * r, -1.2 * r, -1.2 * r);
  }
  return {};
}

}  // namespace

double ChartScale::share(double value) const {
  if (is_log) return std::log(value / low) / std::log(high / low);
  return (value - low) / (high - low);
}

Chart::Chart(const Words& words, const ChartScale& x, const ChartScale& y) : x_(x), y_(y) { add_grid(words); }

glm::dvec2 Chart::place(glm::dvec2 point) const {
  return {kLeft + x_.share(point.x) * (kWidth - kLeft - kRight),
          kHeight - kBottom - y_.share(point.y) * (kHeight - kTop - kBottom)};
}

void Chart::add_grid(const Words& words) {
  const double end = kWidth - kRight;
  const double foot = kHeight - kBottom;
  for (const ChartScale::Tick& tick : y_.ticks) {
    const double at = place({x_.low, tick.value}).y;
    back_ += line("grid", {kLeft, at}, {end, at});
    back_ += text_at({kLeft - 9, at + 4.5}, "text-anchor=\"end\"", tick.words);
  }
  for (const ChartScale::Tick& tick : x_.ticks) {
    const double at = place({tick.value, y_.low}).x;
    back_ += line("axis", {at, foot}, {at, foot + 5});
    back_ += text_at({at, foot + 20}, "text-anchor=\"middle\"", tick.words);
  }
  back_ += line("axis", {kLeft, foot}, {end, foot});
  back_ += text_at({(kLeft + end) / 2, kHeight - 14}, "text-anchor=\"middle\"", words.x);
  back_ += text_at(
      {0, 0},
      format("text-anchor=\"middle\" transform=\"translate(18 %.1f) rotate(-90)\"", (kTop + foot) / 2),
      words.y);
  back_ += text_at({kLeft, 30}, "class=\"title\"", words.title);
}

std::string Chart::path(const std::vector<glm::dvec2>& points) const {
  std::string steps;
  for (const glm::dvec2 point : points) {
    const glm::dvec2 at = place(point);
    steps += format("%c%.1f %.1f", steps.empty() ? 'M' : 'L', at.x, at.y);
  }
  return steps;
}

void Chart::band(const std::vector<glm::dvec2>& low, const std::vector<glm::dvec2>& high,
                 const std::string& series) {
  std::vector<glm::dvec2> around = low;
  around.insert(around.end(), high.rbegin(), high.rend());
  back_ += "<path class=\"" + series + " band\" d=\"" + path(around) + "Z\"/>\n";
}

void Chart::curve(const std::vector<glm::dvec2>& points, const std::string& series, ChartStroke stroke) {
  const char* kind = stroke == ChartStroke::Solid ? "" : stroke == ChartStroke::Thin ? " thin" : " dashed";
  front_ += "<path class=\"" + series + " curve" + kind + "\" d=\"" + path(points) + "\"/>\n";
}

void Chart::marks(const std::vector<glm::dvec2>& points, const std::string& series, ChartMark mark) {
  front_ += "<g class=\"" + series + " mark" + (mark == ChartMark::Ring ? " ring" : "") + "\">\n";
  for (const glm::dvec2 point : points) front_ += mark_at(place(point), mark);
  front_ += "</g>\n";
}

void Chart::label(glm::dvec2 point, const std::string& words, const std::string& series) {
  labels_.push_back({place(point) + glm::dvec2(11, 4.5), words, series});
}

void Chart::spread_labels() {
  std::ranges::stable_sort(labels_, {}, [](const Label& label) { return label.at.y; });
  for (std::size_t i = 1; i < labels_.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const glm::dvec2 apart = labels_[i].at - labels_[k].at;
      if (std::abs(apart.x) < kLabelWidth && apart.y < kLabelHeight)
        labels_[i].at.y = labels_[k].at.y + kLabelHeight;
    }
  }
}

std::string Chart::svg() && {
  spread_labels();
  std::string text =
      format("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" viewBox=\"0 0 %.0f %.0f\" ", kWidth,
             kHeight) +
      format("width=\"%.0f\" height=\"%.0f\" role=\"img\">\n", kWidth, kHeight) + kStyle +
      format("<rect class=\"ground\" width=\"%.0f\" height=\"%.0f\" rx=\"8\"/>\n", kWidth, kHeight) + back_ +
      front_;
  for (const Label& label : labels_)
    text += text_at(label.at, "class=\"" + label.series + " label\"", label.words);
  return text + "</svg>\n";
}

std::vector<ChartScale::Tick> decade_ticks(double low, double high, std::string (*words)(double)) {
  std::vector<ChartScale::Tick> ticks;
  const int first = static_cast<int>(std::ceil(std::log10(low) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
  for (int power = first; power <= last; ++power) {
    const double value = std::pow(10.0, power);
    ticks.push_back({value, words(value)});
  }
  return ticks;
}

std::vector<ChartScale::Tick> round_ticks(double high) {
  const double decade = std::pow(10.0, std::floor(std::log10(high / 4)));
  const double rest = high / 4 / decade;
  const double step = decade * (rest >= 5 ? 5 : rest >= 2 ? 2 : 1);
  std::vector<ChartScale::Tick> ticks;
  for (int i = 0; i * step <= high * (1 + 1e-9); ++i) ticks.push_back({i * step, format("%.4g", i * step)});
  return ticks;
}

}  // namespace netwright
