// Going on after the first net: it stays a net, keeps its pins, and has room for more glue tabs.
#include "core/solve/refine.h"

#include <gtest/gtest.h>

#include "core/solve/solve.h"
#include "core/solve/tab_room.h"
#include "tests/pins.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_dual;
using testing::zoo;

constexpr double kMeanEdgeMm = 15;

SolveOptions with_aim(std::uint64_t seed = 1) {
  SolveOptions options{.seed = seed, .streams = 1, .threads = 1};
  options.tabs = TabAim{{}, [](const Net& net) { return kMeanEdgeMm / net.mesh().mean_edge(); }};
  return options;
}

SolveResult solved(const std::shared_ptr<const DualGraph>& dual, const SolveOptions& options) {
  Progress progress;
  return solve(dual, options, progress);
}

/// A cube whose sides are cut up: most of its points are flat, and no cut that ends in one opens.
std::shared_ptr<const DualGraph> flat_points() { return make_dual(shapes::grid_cube(4)); }

TEST(Refine, FindsRoomForTabsOnTheZoo) {
  int before = 0;
  int after = 0;
  for (const auto& shape : zoo()) {
    const SolveResult result = solved(make_dual(shape.soup), with_aim());
    EXPECT_TRUE(result.is_proved) << shape.soup.name;
    EXPECT_LE(result.tabless_after, result.tabless_before) << shape.soup.name;
    before += result.tabless_before;
    after += result.tabless_after;
  }
  EXPECT_GT(before, 10);
  EXPECT_LE(2 * after, before);
}

TEST(Refine, TellsWhatPlaceTabsFinds) {
  for (const auto& shape : zoo()) {
    const SolveResult result = solved(make_dual(shape.soup), with_aim());
    const GlueTabs tabs = place_tabs(result.net, kMeanEdgeMm / result.net.mesh().mean_edge(), {});
    EXPECT_EQ(static_cast<int>(tabs.n_hopeless), result.tabless_after) << shape.soup.name;
  }
}

TEST(Refine, GivesTheSameNetForTheSameSeed) {
  const auto dual = flat_points();
  const SolveResult one = solved(dual, with_aim(5));
  EXPECT_EQ(one.net.tree, solved(dual, with_aim(5)).net.tree);
  EXPECT_GT(one.tabless_before, one.tabless_after);
}

TEST(Refine, ChangesNothingUnlessAsked) {
  const auto dual = flat_points();
  SolveOptions options = with_aim();
  options.tabs->settings.is_on = false;
  SolveOptions plain = with_aim();
  plain.tabs.reset();
  EXPECT_EQ(solved(dual, options).net.tree, solved(dual, plain).net.tree);
  EXPECT_NE(solved(dual, with_aim()).net.tree, solved(dual, plain).net.tree);
}

TEST(Refine, KeepsPins) {
  const auto dual = flat_points();
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Random random(seed);
    SolveOptions options = with_aim(seed);
    options.pins = testing::random_pins(*dual, 3, random);
    const SolveResult result = solved(dual, options);
    EXPECT_TRUE(result.is_proved);
    EXPECT_TRUE(keeps_pins(dual->mesh(), result.net.tree, options.pins));
  }
}

TEST(Refine, LogsItsMovesSoThatTheyCanBePlayed) {
  const SolveResult result = solved(flat_points(), with_aim());
  const Mesh& mesh = result.net.mesh();
  ASSERT_FALSE(result.log.empty());
  IdVector<EdgeId, char> is_fold(mesh.n_edges(), 0);
  for (const EdgeId e : mesh.edges()) is_fold[e] = result.log.back().start.is_fold(mesh, e) ? 1 : 0;
  for (const MoveRecord& move : result.log.back().moves) {
    EXPECT_EQ(is_fold[mesh.edge(move.removed)], 1);
    EXPECT_EQ(is_fold[mesh.edge(move.inserted)], 0);
    is_fold[mesh.edge(move.removed)] = 0;
    is_fold[mesh.edge(move.inserted)] = 1;
  }
  for (const EdgeId e : mesh.edges()) EXPECT_EQ(is_fold[e] != 0, result.net.tree.is_fold(mesh, e));
}

TEST(Refine, EndsAtOnceWhenCancelled) {
  const auto dual = flat_points();
  const std::vector<SearchModel> models = search_models(*dual);
  SearchState state(models[0], 2e-11);
  const SolveResult result = solved(dual, {.seed = 1, .streams = 1, .threads = 1});
  std::vector<char> folds;
  for (const HalfedgeId h : models[0].mesh_halfedge)
    folds.push_back(result.net.tree.is_fold(dual->mesh(), dual->mesh().edge(h)) ? 1 : 0);
  state.set_tree(folds);
  Progress progress;
  progress.cancel();
  Random random(1);
  int n_looks = 0;
  const NetJudge judge = [&](const SearchState&) {
    ++n_looks;
    return Judgement{1, {0}};
  };
  refine(state, judge, 1000, random, &progress);
  EXPECT_EQ(n_looks, 1);
  EXPECT_EQ(state.folds(), folds);
}

}  // namespace
}  // namespace netwright
