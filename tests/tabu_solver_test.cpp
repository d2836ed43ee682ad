// The search: it solves the zoo, in the fast and in the paper's setting, repeats for a seed, and its
// shortcuts change nothing but the time.
#include "core/solve/tabu_solver.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/predicates.h"
#include "core/solve/showing.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_dual;
using testing::zoo;

TEST(TabuSolver, SolvesTheZoo) {
  for (const auto& shape : zoo()) {
    const auto dual = make_dual(shape.soup);
    for (const SearchModel& model : search_models(*dual))
      for (std::uint64_t seed = 0; seed < 3; ++seed) {
        TabuSolver solver(*dual, model, SearchSettings::fast(), seed, 0);
        while (!solver.is_solved() && solver.iterations() < 20000) solver.step();
        EXPECT_TRUE(solver.is_solved()) << shape.soup.name << " seed " << seed;
      }
  }
}

// Closed shapes only: strict about nearly flat saddle points, the paper's unbounded search stays a few
// overlaps short of a net on the bumpy patch, which is what the bound on worsening moves is for.
TEST(TabuSolver, ThePapersOwnSettingSolvesTheClosedZooToo) {
  for (const auto& shape : zoo()) {
    if (!shape.is_closed) continue;
    const auto dual = make_dual(shape.soup);
    for (const SearchModel& model : search_models(*dual)) {
      TabuSolver solver(*dual, model, SearchSettings::paper(), 1, 0);
      while (!solver.is_solved() && solver.iterations() < 50000) solver.step();
      EXPECT_TRUE(solver.is_solved()) << shape.soup.name;
    }
  }
}

std::vector<SearchEpisode> run(const SearchSettings& settings, int steps) {
  const auto dual = make_dual(shapes::bumpy_patch(10, 10));
  const SearchModel model = search_models(*dual).front();
  TabuSolver solver(*dual, model, settings, 7, 1);
  for (int k = 0; k < steps; ++k) solver.step();
  return solver.episodes();
}

void expect_same(const std::vector<SearchEpisode>& a, const std::vector<SearchEpisode>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t e = 0; e < a.size(); ++e) {
    EXPECT_EQ(a[e].start_folds, b[e].start_folds);
    ASSERT_EQ(a[e].moves.size(), b[e].moves.size());
    for (std::size_t i = 0; i < a[e].moves.size(); ++i) {
      EXPECT_EQ(a[e].moves[i].inserted, b[e].moves[i].inserted);
      EXPECT_EQ(a[e].moves[i].overlaps_after, b[e].moves[i].overlaps_after);
    }
  }
}

TEST(TabuSolver, RepeatsItselfForOneSeed) {
  expect_same(run(SearchSettings::fast(), 200), run(SearchSettings::fast(), 200));
}

TEST(TabuSolver, CountingOnlyAsFarAsNeededChangesNoMove) {
  SearchSettings full = SearchSettings::fast();
  full.counts_bounded = false;
  expect_same(run(SearchSettings::fast(), 200), run(full, 200));
  SearchSettings bounded_paper = SearchSettings::paper();
  bounded_paper.counts_as_paper = false;
  bounded_paper.counts_bounded = true;
  expect_same(run(bounded_paper, 60), run(SearchSettings::paper(), 60));
}

TEST(TabuSolver, AskingKillersFirstChangesNoMove) {
  for (SearchSettings settings : {SearchSettings::fast(), SearchSettings::paper()}) {
    settings.counts_as_paper = false;
    settings.counts_bounded = true;
    SearchSettings without = settings;
    without.uses_killers = false;
    expect_same(run(settings, 150), run(without, 150));
  }
}

TEST(TabuSolver, LogReplaysToTheSolverState) {
  const auto dual = make_dual(shapes::torus(12, 8));
  const SearchModel model = search_models(*dual).front();
  TabuSolver solver(*dual, model, SearchSettings::paper(), 3, 0);
  for (int k = 0; k < 40; ++k) solver.step();
  WholeTree replayed(dual, FaceId());
  replayed.set(model, solver.episodes().back().start_folds);
  for (const auto& move : solver.episodes().back().moves)
    replayed.exchange(model, move.removed, move.inserted);
  WholeTree expected(dual, FaceId());
  expected.set(model, solver.state().folds());
  EXPECT_EQ(replayed.tree(), expected.tree());
}

TEST(TabuSolver, KeepsTheBestTreeItHasSeen) {
  const auto dual = make_dual(shapes::bumpy_patch(10, 10));
  const SearchModel model = search_models(*dual).front();
  TabuSolver solver(*dual, model, SearchSettings::paper(), 2, 0);
  int fewest = solver.state().overlaps();
  for (int k = 0; k < 30; ++k) {
    solver.step();
    fewest = std::min(fewest, solver.state().overlaps());
    EXPECT_EQ(solver.best_overlaps(), fewest);
  }
  SearchState best(model, kSolveDepth);
  best.set_tree(solver.best_folds());
  EXPECT_EQ(best.overlaps(), fewest);
}

// Each notch of this star is narrower than a right angle, so a side standing in it always cuts into the next
// point and the caps cannot be joined to anything: no net in one piece exists.
PolygonSoup spiky_star() {
  std::vector<glm::dvec2> outline;
  for (int i = 0; i < 14; ++i) {
    const double r = i % 2 == 0 ? 3 : 1.2;
    outline.emplace_back(r * std::cos(i * M_PI / 7), r * std::sin(i * M_PI / 7));
  }
  return shapes::prism(outline, 1);
}

TEST(TabuSolver, RestartsWhenNothingImprovesAndNeverClaimsTheImpossible) {
  const auto dual = make_dual(spiky_star());
  const SearchModel model = search_models(*dual).front();
  for (const SearchSettings& settings : {SearchSettings::fast(), SearchSettings::paper()}) {
    TabuSolver solver(*dual, model, settings, 0, 0);
    for (int k = 0; k < 5000; ++k) solver.step();
    EXPECT_FALSE(solver.is_solved());
    EXPECT_GE(solver.best_overlaps(), 1);
    EXPECT_GT(solver.restarts(), 2);
  }
}

TEST(TabuSolver, HasMorePatienceWithEveryNewTree) {
  const auto dual = make_dual(spiky_star());
  const SearchModel model = search_models(*dual).front();
  SearchSettings settings;
  TabuSolver solver(*dual, model, settings, 0, 0);
  std::int64_t begin = 0;
  std::int64_t patience = static_cast<std::int64_t>(settings.restart_after) * model.n_faces;
  for (int n = 0; n < 5; ++n) {
    while (solver.restarts() == n) solver.step();
    EXPECT_GT(solver.iterations() - begin, patience);
    begin = solver.iterations();
    patience *= 2;
  }
  settings.cooling_restarts = 0;
  TabuSolver same(*dual, model, settings, 0, 0);
  for (int k = 0; k < begin; ++k) same.step();
  EXPECT_GT(same.restarts(), 8);
}

TEST(TabuSolver, NeverClaimsANetOfAModelWithHats) {
  for (const PolygonSoup& base : {shapes::tetrahedron(), shapes::octahedron(), shapes::icosahedron()}) {
    const auto dual = make_dual(testing::with_hats(base));
    const SearchModel model = search_models(*dual).front();
    for (const SearchSettings& settings : {SearchSettings::fast(), SearchSettings::paper()})
      for (std::uint64_t seed = 0; seed < 2; ++seed) {
        TabuSolver solver(*dual, model, settings, seed, 0);
        for (int k = 0; k < 2000; ++k) solver.step();
        EXPECT_FALSE(solver.is_solved()) << base.name;
        EXPECT_GE(solver.best_overlaps(), 1) << base.name;
      }
  }
}

TEST(TabuSolver, ASingleFaceNeedsNoSearch) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.add_face(std::vector<int>{0, 1, 2});
  const auto dual = make_dual(soup);
  const SearchModel model = search_models(*dual).front();
  EXPECT_TRUE(TabuSolver(*dual, model, SearchSettings::fast(), 0, 0).is_solved());
}

}  // namespace
}  // namespace netwright
