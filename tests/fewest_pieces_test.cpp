// Nets of several pieces: as few as there can be, proved, with pins kept and cuts where they are cheap.
#include "core/solve/fewest_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/predicates.h"
#include "core/base/random.h"
#include "core/solve/solve.h"
#include "core/unfold/overlap.h"
#include "tests/hatted_shapes.h"
#include "tests/support.h"

namespace netwright {
namespace {

/// Where a notch is narrow, its walls must be pieces of their own.
constexpr testing::CupRange kFlatCups{1.2, 2, 0.1, 0.5, 0.3, 1, 0, 0.12, 0.2};

using testing::make_dual;
using testing::with_hats;

PiecesResult pieces_of(const PolygonSoup& soup, const PiecesOptions& options = {}) {
  const Progress progress;
  return fewest_pieces(make_dual(soup), options, progress);
}

double length_of_cuts(const Net& net) {
  double sum = 0;
  for (const EdgeId e : net.mesh().edges())
    if (!net.mesh().is_border(e) && !net.tree.is_fold(net.mesh(), e)) sum += net.mesh().length(e);
  return sum;
}

/// Everything that is promised of every result.
void expect_sound(const PiecesResult& result) {
  ASSERT_FALSE(result.choices.empty());
  EXPECT_GE(result.choices.front().net.n_pieces, result.at_least);
  int before = 0;
  for (const PiecesChoice& choice : result.choices) {
    EXPECT_GT(choice.net.n_pieces, before);
    before = choice.net.n_pieces;
    const VerifyReport report = verify(to_flat_net(choice.net, 1), choice.net.n_pieces);
    EXPECT_TRUE(report.is_net) << (report.faults.empty() ? "" : report.faults.front());
    EXPECT_NEAR(choice.cut_length, length_of_cuts(choice.net), 1e-9);
  }
}

/// Tries all ways to choose so many folds.
bool has_net_of(const std::shared_ptr<const DualGraph>& dual, const std::vector<EdgeId>& hinges,
                IdVector<EdgeId, char>& is_fold, std::size_t next, std::size_t n_folds) {
  if (n_folds == 0) {
    try {
      return find_overlaps(layout(dual, tree_from_folds(dual->mesh(), is_fold)), kProofDepth).empty();
    } catch (const std::logic_error&) {
      return false;  // a loop of folds
    }
  }
  if (hinges.size() - next < n_folds) return false;
  is_fold[hinges[next]] = 1;
  const bool is_found = has_net_of(dual, hinges, is_fold, next + 1, n_folds - 1);
  is_fold[hinges[next]] = 0;
  return is_found || has_net_of(dual, hinges, is_fold, next + 1, n_folds);
}

int fewest_by_trying_all(const std::shared_ptr<const DualGraph>& dual) {
  const Mesh& mesh = dual->mesh();
  std::vector<EdgeId> hinges;
  for (const EdgeId e : mesh.edges())
    if (!mesh.is_border(e)) hinges.push_back(e);
  IdVector<EdgeId, char> is_fold(mesh.n_edges(), 0);
  std::size_t n_pieces = 1;
  while (!has_net_of(dual, hinges, is_fold, 0, mesh.n_faces() - n_pieces)) ++n_pieces;
  return static_cast<int>(n_pieces);
}

TEST(FewestPieces, AreAsFewAsTryingEverythingFinds) {
  Random random(11);
  std::vector<int> seen;
  for (int k = 0; k < 14; ++k) {
    const PolygonSoup cup = testing::random_cup(random, kFlatCups);
    const PiecesResult result = pieces_of(cup);
    expect_sound(result);
    const int fewest = fewest_by_trying_all(make_dual(cup));
    EXPECT_EQ(result.choices.front().net.n_pieces, fewest) << k;
    EXPECT_EQ(result.at_least, fewest) << k;
    seen.push_back(fewest);
  }
  EXPECT_GE(std::count(seen.begin(), seen.end(), 1), 1);
  EXPECT_GE(std::count_if(seen.begin(), seen.end(), [](int n) { return n > 1; }), 3);
}

TEST(FewestPieces, HatsFallIntoAsManyPiecesAsTheyMust) {
  // As many paths of cuts from corner to corner as there are hats; each that closes a loop makes a piece.
  struct Case {
    PolygonSoup base;
    int fewest;
  };
  for (const Case& one : {Case{shapes::tetrahedron(), 2}, Case{shapes::octahedron(), 4},
                          Case{shapes::bipyramid(3), 3}, Case{shapes::bipyramid(5), 5}}) {
    PiecesOptions options;
    options.n_choices = 2;
    options.tries_per_face = 25;
    const PiecesResult result = pieces_of(with_hats(one.base), options);
    expect_sound(result);
    EXPECT_EQ(result.at_least, one.fewest) << one.base.name;
    EXPECT_EQ(result.choices.front().net.n_pieces, one.fewest) << one.base.name;
    EXPECT_EQ(result.choices.size(), 2U);
  }
}

TEST(FewestPieces, AConvexModelIsOnePieceAndMoreWhenAskedFor) {
  const PiecesResult result = pieces_of(shapes::cube());
  expect_sound(result);
  ASSERT_EQ(result.choices.size(), 3U);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(result.choices[static_cast<std::size_t>(k)].net.n_pieces, k + 1);
    EXPECT_NEAR(result.choices[static_cast<std::size_t>(k)].cut_length, 7 + k, 1e-9);
  }
}

TEST(FewestPieces, EveryComponentIsAPieceAtLeast) {
  const PiecesResult result =
      pieces_of(shapes::combined(shapes::cube(), with_hats(shapes::tetrahedron()), {9, 0, 0}));
  expect_sound(result);
  EXPECT_EQ(result.choices.front().net.n_pieces, 3);
  EXPECT_EQ(result.at_least, 3);
}

TEST(FewestPieces, KeepEveryPin) {
  const auto dual = make_dual(with_hats(shapes::octahedron()));
  const Mesh& mesh = dual->mesh();
  SolveOptions search;
  search.max_iterations = 300;
  search.pins.root = FaceId(5);
  search.pins.must_cut = {EdgeId(3), EdgeId(20)};
  search.pins.must_fold = {EdgeId(7), EdgeId(40)};
  search.pins.together = {{mesh.face(mesh.halfedge(EdgeId(60))), mesh.neighbour(mesh.halfedge(EdgeId(60)))}};
  std::sort(search.pins.together[0].begin(), search.pins.together[0].end());
  Progress progress;
  PiecesOptions options;
  options.pins = search.pins;
  options.from = std::make_shared<const UnfoldTree>(solve(dual, search, progress).net.tree);
  const PiecesResult result = fewest_pieces(dual, options, progress);
  expect_sound(result);
  for (const PiecesChoice& choice : result.choices) {
    EXPECT_TRUE(keeps_pins(mesh, choice.net.tree, search.pins));
    EXPECT_TRUE(choice.net.tree.is_root(FaceId(5)));
  }
}

TEST(FewestPieces, BeginFromATreeThatIsANetAndStayOnePiece) {
  const auto dual = make_dual(shapes::sand_clock());
  Progress progress;
  PiecesOptions options;
  options.from = std::make_shared<const UnfoldTree>(solve(dual, {}, progress).net.tree);
  const PiecesResult result = fewest_pieces(dual, options, progress);
  expect_sound(result);
  EXPECT_EQ(result.choices.front().net.n_pieces, 1);
}

TEST(FewestPieces, CutsAreCheaperWhereTheyAreHardlySeen) {
  const auto gable = make_dual(shapes::cuboid({1, 1, 1}));
  const Mesh& mesh = gable->mesh();
  double top = 0;
  double bottom = 0;
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    const double height = mesh.position(h).y + mesh.position(mesh.to(h)).y;
    if (height > mesh.box().max.y + mesh.box().max.y - 1e-9) top = cut_cost(*gable, e);
    if (height < mesh.box().min.y + mesh.box().min.y + 1e-9) bottom = cut_cost(*gable, e);
  }
  EXPECT_GT(top, 0);
  EXPECT_LT(bottom, top);
  const auto flat = make_dual(shapes::grid_patch(2, 2));
  for (const EdgeId e : flat->mesh().edges()) {
    if (!flat->mesh().is_border(e)) {
      EXPECT_DOUBLE_EQ(cut_cost(*flat, e), flat->mesh().length(e));
    }
  }
}

TEST(FewestPieces, TheSameSeedGivesTheSamePieces) {
  const PolygonSoup soup = with_hats(shapes::bipyramid(3));
  PiecesOptions options;
  options.seed = 4;
  options.tries_per_face = 15;
  const PiecesResult one = pieces_of(soup, options);
  const PiecesResult two = pieces_of(soup, options);
  ASSERT_EQ(one.choices.size(), two.choices.size());
  for (std::size_t k = 0; k < one.choices.size(); ++k)
    EXPECT_EQ(one.choices[k].net.tree, two.choices[k].net.tree);
}

TEST(FewestPieces, CancellingKeepsWhatThereIs) {
  Progress progress;
  progress.cancel();
  const PiecesResult result = fewest_pieces(make_dual(with_hats(shapes::octahedron())), {}, progress);
  EXPECT_TRUE(result.was_cancelled);
  expect_sound(result);
}

}  // namespace
}  // namespace netwright
