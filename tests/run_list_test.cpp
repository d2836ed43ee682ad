// The list of finished runs: numbers, order, what is the best, what is dropped when there are many; and the
// measures and pictures of nets that it shows.
#include "core/project/run_list.h"

#include <gtest/gtest.h>

#include "core/unfold/net.h"
#include "tests/support.h"

namespace netwright {
namespace {

using Dual = std::shared_ptr<const DualGraph>;

Net net_of(const Dual& dual, std::uint64_t seed) {
  Progress progress;
  SolveOptions options;
  options.seed = seed;
  return solve(dual, options, progress).net;
}

FinishedRun run_of(const Dual& dual, std::uint64_t seed, double fill, int overlaps = 0) {
  FinishedRun run;
  run.dual = dual;
  run.tree = std::make_shared<const UnfoldTree>(net_of(dual, seed).tree);
  run.summary.seed = seed;
  run.summary.overlaps = overlaps;
  run.summary.is_proved = overlaps == 0;
  run.measures.n_pieces = 1;
  run.measures.fill = fill;
  return run;
}

/// A log of about so many bytes.
std::shared_ptr<const RunLog> log_of(const Dual& dual, std::size_t bytes) {
  SolveResult result;
  result.net = net_of(dual, 0);
  result.log.push_back({result.net.tree, 0, std::vector<MoveRecord>(bytes / sizeof(MoveRecord))});
  return std::make_shared<const RunLog>(result);
}

TEST(RunList, NumbersRunsAndFindsThem) {
  const Dual cube = testing::make_dual(shapes::cube());
  const Dual ball = testing::make_dual(shapes::icosphere(1));
  RunList list;
  EXPECT_EQ(list.add(run_of(cube, 1, 0.5))->number, 1);
  EXPECT_EQ(list.add(run_of(ball, 1, 0.4))->number, 2);
  EXPECT_EQ(list.add(run_of(cube, 2, 0.6))->number, 3);
  ASSERT_EQ(list.of(cube).size(), 2U);
  EXPECT_EQ(list.of(cube).back()->number, 3);
  EXPECT_EQ(list.find(2)->dual, ball);
  list.erase(3);
  EXPECT_EQ(list.find(3), nullptr);
  EXPECT_EQ(list.add(run_of(cube, 3, 0.6))->number, 4) << "numbers are not used twice";
  list.keep([&](const Dual& dual) { return dual == ball; });
  EXPECT_TRUE(list.of(cube).empty());
  EXPECT_EQ(list.of(ball).size(), 1U);
}

TEST(RunList, TheSameSeedWithTheSameNetIsTheSameRun) {
  const Dual cube = testing::make_dual(shapes::cube());
  RunList list;
  list.add(run_of(cube, 1, 0.5));
  list.add(run_of(cube, 2, 0.5));
  EXPECT_EQ(list.add(run_of(cube, 1, 0.5))->number, 1);
  ASSERT_EQ(list.of(cube).size(), 2U);
  EXPECT_EQ(list.of(cube).back()->number, 1) << "it is the latest again";
}

TEST(RunList, TheBestIsProvedThenInFewPiecesThenCompact) {
  const Dual cube = testing::make_dual(shapes::cube());
  RunList list;
  EXPECT_EQ(list.best_of(cube), nullptr);
  list.add(run_of(cube, 1, 0.9, 3));
  list.add(run_of(cube, 2, 0.9, 2));
  EXPECT_EQ(list.best_of(cube)->number, 2);
  FinishedRun parted = run_of(cube, 3, 0.8);
  parted.measures.n_pieces = 2;
  list.add(parted);
  EXPECT_EQ(list.best_of(cube)->number, 3);
  list.add(run_of(cube, 4, 0.4));
  EXPECT_EQ(list.best_of(cube)->number, 4);
  list.add(run_of(cube, 5, 0.41));
  EXPECT_EQ(list.best_of(cube)->number, 5);
  EXPECT_EQ(list.best_of(cube)->score(), 41);
}

TEST(RunList, DropsTheOldestButNeverTheBest) {
  const Dual cube = testing::make_dual(shapes::cube());
  RunList list;
  list.add(run_of(cube, 1000, 0.3));
  list.add(run_of(cube, 1001, 0.9));
  for (std::uint64_t seed = 0; seed < RunList::kMostRuns; ++seed) list.add(run_of(cube, seed, 0.5));
  EXPECT_EQ(list.of(cube).size(), RunList::kMostRuns);
  EXPECT_EQ(list.find(1), nullptr);
  ASSERT_NE(list.find(2), nullptr);
  EXPECT_EQ(list.best_of(cube)->number, 2);
}

TEST(RunList, KeepsTheMovesOfTheLastRunsOnly) {
  const Dual cube = testing::make_dual(shapes::cube());
  constexpr std::size_t kRoom = 1U << 16U;
  RunList list(kRoom);
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    FinishedRun run = run_of(cube, seed, 0.5);
    run.log = log_of(cube, kRoom * 2 / 5);
    list.add(std::move(run));
  }
  EXPECT_EQ(list.find(1)->log, nullptr);
  EXPECT_EQ(list.find(2)->log, nullptr);
  EXPECT_NE(list.find(4)->log, nullptr);
  FinishedRun huge = run_of(cube, 9, 0.5);
  huge.log = log_of(cube, 2 * kRoom);
  EXPECT_NE(list.add(std::move(huge))->log, nullptr) << "those of the last run always";
  EXPECT_EQ(list.find(4)->log, nullptr);
}

TEST(NetMeasures, OfACrossOfSixSquares) {
  const Dual dual = testing::make_dual(shapes::cube());
  const Net net = net_of(dual, 0);
  const NetMeasures measures = measure(net);
  EXPECT_EQ(measures.n_pieces, 1);
  EXPECT_NEAR(measures.cut_length, 7 * dual->mesh().length(EdgeId(0)), 1e-9) << "12 edges, 5 of them folds";
  const Box2 box = net.box();
  EXPECT_GT(measures.fill, 0.3);
  EXPECT_LE(measures.fill, 1);
  // The hexominoes' boxes are 3 x 4 or 2 x 5 squares, unless a slanted box is smaller.
  EXPECT_GE(measures.fill, 6 * dual->mesh().length(EdgeId(0)) * dual->mesh().length(EdgeId(0)) /
                                   (box.size().x * box.size().y) -
                               1e-9);
}

TEST(NetMeasures, SayHowLargeANetIsOnPaper) {
  const Dual dual = testing::make_dual(shapes::cube());
  const Net net = net_of(dual, 0);
  const NetMeasures measures = measure(net);
  const auto high = size_on_paper(measures, {}, {PrintSize::Kind::Height, 30});
  const auto twice = size_on_paper(measures, {}, {PrintSize::Kind::Height, 60});
  ASSERT_TRUE(high && twice);
  EXPECT_GE(high->x, high->y);
  EXPECT_NEAR(high->x * high->y * measures.fill, 6 * 30 * 30, 1e-6) << "the paper of six squares";
  EXPECT_NEAR(twice->x, 2 * high->x, 1e-9);
  const PaperSetup paper{};
  const PageLayout pages = arrange(net, paper, {});
  const auto fitted = size_on_paper(measures, paper, {});
  ASSERT_TRUE(fitted);
  EXPECT_NEAR(fitted->x * fitted->y * measures.fill, 6 * std::pow(pages.model_height_mm, 2), 1)
      << "as large as the pages have it";
  EXPECT_FALSE(size_on_paper(measures, {.format = "A4", .margin_mm = 400}, {}));
}

TEST(NetPicture, ShowsThePaperAndNothingElse) {
  const Dual dual = testing::make_dual(shapes::cube());
  const Image picture = net_picture(net_of(dual, 0), 60, 60);
  ASSERT_EQ(picture.rgba.size(), 60U * 60U * 4U);
  double opacity = 0;
  int n_full = 0;
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) {
    opacity += picture.rgba[i] / 255.0;
    n_full += picture.rgba[i] == 255 ? 1 : 0;
  }
  // Six squares in a box of 3 x 4 or 2 x 5, drawn 58 pixels wide.
  EXPECT_GT(opacity, 58.0 * 58.0 * 6 / 25 * 0.97);
  EXPECT_LT(opacity, 58.0 * 58.0 * 6 / 16 * 1.03);
  EXPECT_GT(n_full, opacity * 0.8);
  EXPECT_EQ(picture.rgba[3], 0) << "the rim stays free";
}

}  // namespace
}  // namespace netwright
