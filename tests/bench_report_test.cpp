// What a bench's report tells: sizes and growth out of rows, the chart's scales, and the page with its plots.
#include <gtest/gtest.h>

#include <cmath>

#include "app/cli_bench_chart.h"
#include "app/cli_bench_plots.h"
#include "app/cli_bench_report.h"
#include "app/cli_bench_table.h"

namespace netwright {
namespace {

BenchRow row(const std::string& folder, const std::string& model, int faces, double seconds, int iterations) {
  BenchRow made;
  made.folder = folder;
  made.model = model;
  made.faces = faces;
  made.is_solved = true;
  made.is_verified = true;
  made.iterations = iterations;
  made.cpu_seconds = seconds;
  made.wall_seconds = 2 * seconds;
  return made;
}

/// Two sizes whose times grow with the square of the faces and whose iterations grow with them, a folder of
/// all sizes, and a model that was refused.
BenchRecord record() {
  BenchRecord made{"netwright-cli bench: streams 1", {"a <fast> processor"}, {}};
  made.rows = {row("m/0100", "a.obj", 100, 0.001, 10), row("m/0100", "b.obj", 102, 0.001, 10),
               row("m/0200", "a.obj", 202, 0.004, 20), row("m/mixed", "a.obj", 12, 0.1, 1),
               row("m/mixed", "b.obj", 500, 0.1, 1)};
  BenchRow failed = row("m/0200", "b & c.obj", 202, 0.004, 20);
  failed.is_solved = failed.is_verified = false;
  failed.overlaps = 3;
  failed.note = "the time was up";
  made.rows.push_back(failed);
  BenchRow refused;
  refused.folder = "m/0200";
  refused.model = "broken.obj";
  refused.note = "it has no faces";
  made.rows.push_back(refused);
  return made;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(BenchSizes, AreFoldersWhoseModelsHaveNearlyTheSameNumberOfFaces) {
  BenchRecord with_more = record();
  with_more.rows.push_back(row("other/0100", "c.obj", 104, 0.001, 10));
  const std::vector<BenchFigures> sizes = bench_sizes(with_more.rows, &BenchRow::cpu_seconds);
  ASSERT_EQ(sizes.size(), 2U);
  EXPECT_EQ(sizes[0].folder, "102");
  EXPECT_EQ(sizes[0].n, 3);
  EXPECT_EQ(sizes[1].folder, "202");
  EXPECT_EQ(sizes[1].n, 3);
  EXPECT_EQ(sizes[1].n_proved, 1);
  EXPECT_EQ(sizes[1].n_refused, 1);
  EXPECT_EQ(sizes[1].times.n, 2);
}

TEST(BenchGrowth, IsFittedOverTheSizes) {
  const std::vector<BenchFigures> sizes = bench_sizes(record().rows, &BenchRow::cpu_seconds);
  const BenchGrowth growth = bench_growth(sizes);
  EXPECT_EQ(growth.n_sizes, 2);
  ASSERT_TRUE(growth.median_time && growth.mean_time && growth.mean_iterations);
  EXPECT_NEAR(growth.median_time->exponent, 2, 1e-9);
  EXPECT_NEAR(growth.mean_iterations->exponent, 1, 1e-9);
  EXPECT_EQ(
      growth_sentence(growth),
      "Growth with the number of faces |F|, 101 to 202 (2 sizes): median time |F|^2.00, mean time |F|^2.00, "
      "mean iterations |F|^1.00");
  EXPECT_EQ(growth_sentence(bench_growth({})), "");
}

TEST(Chart, ScalesTellWhereNumbersLie) {
  const ChartScale linear{10, 30, false};
  EXPECT_DOUBLE_EQ(linear.share(10), 0);
  EXPECT_DOUBLE_EQ(linear.share(25), 0.75);
  const ChartScale log{1e-3, 10, true};
  EXPECT_DOUBLE_EQ(log.share(0.1), 0.5);
}

TEST(Chart, TicksAreRoundNumbers) {
  const auto values = [](const std::vector<ChartScale::Tick>& ticks) {
    std::vector<double> found;
    for (const auto& tick : ticks) found.push_back(tick.value);
    return found;
  };
  EXPECT_EQ(values(round_ticks(86)), (std::vector<double>{0, 20, 40, 60, 80}));
  EXPECT_EQ(values(round_ticks(1)), (std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1}));
  const auto decades =
      decade_ticks(0.05, 100, [](double value) { return std::to_string(std::lround(value * 10)); });
  ASSERT_EQ(decades.size(), 4U);
  EXPECT_EQ(decades.front().words, "1");
  EXPECT_EQ(decades.back().words, "1000");
}

TEST(Chart, LabelsThatWouldCoverEachOtherAreMovedApart) {
  Chart chart({"t", "x", "y"}, {0, 1}, {0, 1});
  chart.label({1, 0.5}, "first", "own");
  chart.label({1, 0.501}, "second", "own");
  chart.label({0, 0.5}, "far", "own");
  const std::string svg = std::move(chart).svg();
  const auto height = [&](const std::string& words) {
    const std::size_t end = svg.find(">" + words + "<");
    return std::stod(svg.substr(svg.rfind("y=\"", end) + 3));
  };
  EXPECT_GE(std::abs(height("first") - height("second")), 16);
  EXPECT_NEAR(height("far"), height("second"), 1);
}

TEST(BenchPlots, ShowOurFiguresBesideThePapers) {
  const std::vector<BenchFigures> sizes = bench_sizes(record().rows, &BenchRow::cpu_seconds);
  const BenchPlots plots = bench_plots(sizes, "CPU time");
  for (const std::string* svg : {&plots.time, &plots.success, &plots.iterations}) {
    EXPECT_TRUE(svg->starts_with("<svg ")) << *svg;
    EXPECT_TRUE(svg->ends_with("</svg>\n"));
    EXPECT_EQ(count(*svg, "nan"), 0U);
    EXPECT_EQ(count(*svg, "inf"), 0U);
    EXPECT_EQ(count(*svg, "<g "), count(*svg, "</g>"));
    EXPECT_EQ(count(*svg, "<text "), count(*svg, "</text>"));
  }
  for (const char* name : {">OTS<", ">SA<", ">Authors' tabu<", ">Netwright, mean<", ">2.00<"})
    EXPECT_EQ(count(plots.time, name), 1U) << name;
  EXPECT_EQ(count(plots.success, "Netwright, 33.33 %"), 1U);
  EXPECT_EQ(count(plots.success, "OTS, 88.44 %"), 1U);
  EXPECT_TRUE(bench_plots({}, "CPU time").time.empty());
}

TEST(BenchPage, TellsWhatWasMeasuredWithWhatAndWhatFailed) {
  const std::string page = bench_page(record(), &BenchRow::cpu_seconds, "CPU time");
  EXPECT_EQ(count(page, "a &lt;fast&gt; processor"), 1U);
  EXPECT_EQ(count(page, "streams 1"), 1U);
  EXPECT_EQ(count(page, "6, 7 runs"), 0U);
  EXPECT_EQ(count(page, "7, 7 runs"), 1U);
  EXPECT_EQ(count(page, "|F|<sup>2.00</sup>"), 2U);
  EXPECT_EQ(count(page, "m/0200/b &amp; c.obj"), 1U);
  EXPECT_EQ(count(page, "the time was up"), 1U);
  EXPECT_EQ(count(page, "it has no faces"), 1U);
  EXPECT_EQ(count(page, "6694.813 s"), 1U);
  EXPECT_EQ(count(page, "<svg "), 3U);
  EXPECT_EQ(count(page, "<table"), count(page, "</table>"));
  EXPECT_EQ(count(page, "http://www.w3.org/2000/svg"), count(page, "http"));
}

TEST(BenchPage, PutsOurFiguresBesideThoseOfTheSameSize) {
  BenchRecord made = record();
  EXPECT_EQ(count(bench_page(made, &BenchRow::cpu_seconds, "t"), "class=\"own\""), 0U);
  made.rows = {row("a", "a.obj", 400, 0.001, 10)};
  const std::string page = bench_page(made, &BenchRow::cpu_seconds, "t");
  EXPECT_EQ(count(page, "class=\"own\""), 1U);
  EXPECT_LT(page.find("400 faces"), page.find("class=\"own\""));
  EXPECT_LT(page.find("class=\"own\""), page.find("600 faces"));
  EXPECT_EQ(count(page, "every run ended with a proved net"), 1U);
}

TEST(BenchPage, SaysWhenThereIsNothingToPlot) {
  BenchRecord made = record();
  std::erase_if(made.rows, [](const BenchRow& r) { return r.folder != "m/mixed"; });
  const std::string page = bench_page(made, &BenchRow::cpu_seconds, "t");
  EXPECT_EQ(count(page, "<svg "), 0U);
  EXPECT_EQ(count(page, "nothing to plot"), 1U);
}

}  // namespace
}  // namespace netwright
