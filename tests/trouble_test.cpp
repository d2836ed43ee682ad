// Telling why there is no net: where the search collided, which corners have too much paper around them, and
// which pins stand in the way.
#include "core/solve/trouble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/hatted_shapes.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_dual;
using testing::one_hat;
using testing::with_hats;

EdgeId edge_between(const Mesh& mesh, int a, int b) {
  for (const HalfedgeId h : mesh.halfedges(FaceId(a)))
    if (mesh.neighbour(h) == FaceId(b)) return mesh.edge(h);
  return {};
}

SolveResult searched(const std::shared_ptr<const DualGraph>& dual, const SolveOptions& options) {
  Progress progress;
  return solve(dual, options, progress);
}

// Folds around the brim that leave a way for cuts from one corner of the hat only.
SolveOptions with_brim_pinned(const DualGraph& dual) {
  SolveOptions options;
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 6}, {6, 7}, {7, 3}, {3, 4}})
    set_pin(options.pins, edge_between(dual.mesh(), a, b), EdgePin::MustFold);
  options.max_iterations = 3000;
  return options;
}

TEST(Trouble, CountsTheIterationsOfAllStreams) {
  const auto dual = make_dual(with_hats(shapes::tetrahedron()));
  SolveOptions options;
  options.max_iterations = 500;
  options.streams = 2;
  const SolveResult result = searched(dual, options);
  ASSERT_FALSE(result.is_proved);
  std::int64_t sum = 0;
  for (const std::int64_t count : result.collisions) sum += count;
  EXPECT_EQ(sum, 2 * 500);
}

TEST(Trouble, IsHottestAtTheOnlyHat) {
  const auto dual = make_dual(one_hat());
  const SolveResult result = searched(dual, with_brim_pinned(*dual));
  ASSERT_FALSE(result.is_proved);
  const Trouble trouble = find_trouble(result);
  ASSERT_FALSE(trouble.hot.empty());
  EXPECT_EQ(trouble.heat[trouble.hot.front()], 1);
  EXPECT_LT(trouble.hot.front().value, 9) << "a face of the hat";
  for (std::size_t i = 1; i < trouble.hot.size(); ++i)
    EXPECT_GE(trouble.heat[trouble.hot[i - 1]], trouble.heat[trouble.hot[i]]);
}

TEST(Trouble, NamesTheCornersOfTheBrim) {
  const auto dual = make_dual(one_hat());
  const Mesh& mesh = dual->mesh();
  const Trouble trouble = find_trouble(searched(dual, with_brim_pinned(*dual)));
  ASSERT_FALSE(trouble.points.empty());
  for (const ExcessPoint& point : trouble.points) EXPECT_GT(point.angle_rad, 2 * std::numbers::pi);
  // The three corners of the brim have the tip's faces, the brim's and each other around them.
  std::vector<VertexId> brim;
  for (const int f : {2, 5, 8}) brim.push_back(mesh.from(mesh.first(FaceId(f))));
  EXPECT_NE(std::find(brim.begin(), brim.end(), trouble.points.front().vertex), brim.end());
}

TEST(Trouble, IsNothingWhereTheFirstNetWasFine) {
  const SolveResult result = searched(make_dual(shapes::cube()), {});
  ASSERT_TRUE(result.is_proved);
  const Trouble trouble = find_trouble(result);
  EXPECT_TRUE(trouble.hot.empty());
  EXPECT_TRUE(trouble.points.empty());
  EXPECT_EQ(trouble.heat.size(), 6U);
}

TEST(Trouble, ReleasesThePinThatIsInTheWay) {
  const auto dual = make_dual(one_hat());
  const SolveOptions options = with_brim_pinned(*dual);
  ASSERT_FALSE(find_contradiction(*dual, options.pins));
  const SolveResult result = searched(dual, options);
  ASSERT_FALSE(result.is_proved);
  Progress progress;
  const Releases found = find_releases(dual, options, find_trouble(result), progress);
  EXPECT_FALSE(found.are_innocent);
  ASSERT_FALSE(found.ways.empty());
  for (const std::vector<Pin>& way : found.ways) {
    SolveOptions freed = options;
    freed.pins = without(options.pins, way);
    EXPECT_LT(pins_in(freed.pins).size(), pins_in(options.pins).size());
    const SolveResult net = searched(dual, freed);
    EXPECT_TRUE(net.is_proved);
    EXPECT_TRUE(keeps_pins(dual->mesh(), net.net.tree, freed.pins));
  }
}

TEST(Trouble, ReleasesAGroupWhereNoSinglePinHelps) {
  // Two rings of must-folds around points of a cube: each has to be opened.
  const auto dual = make_dual(shapes::cube());
  const Mesh& mesh = dual->mesh();
  SolveOptions options;
  const VertexId corner = mesh.from(mesh.first(FaceId(0)));
  const auto far =
      std::max_element(mesh.vertices().begin(), mesh.vertices().end(), [&](VertexId a, VertexId b) {
        return glm::distance(mesh.position(a), mesh.position(corner)) <
               glm::distance(mesh.position(b), mesh.position(corner));
      });
  for (const HalfedgeId h : mesh.halfedges())
    if (mesh.from(h) == corner || mesh.from(h) == *far)
      set_pin(options.pins, mesh.edge(h), EdgePin::MustFold);
  ASSERT_TRUE(find_contradiction(*dual, options.pins));
  Progress progress;
  const Releases found = find_releases(dual, options, {}, progress);
  ASSERT_EQ(found.ways.size(), 1U);
  EXPECT_EQ(found.ways.front().size(), 2U);
}

TEST(Trouble, AcquitsPinsWhereThereIsNoNetAnyway) {
  const auto dual = make_dual(with_hats(shapes::tetrahedron()));
  SolveOptions options;
  set_pin(options.pins, edge_between(dual->mesh(), 0, 1), EdgePin::MustFold);
  Progress progress;
  const Releases found = find_releases(dual, options, {}, progress);
  EXPECT_TRUE(found.are_innocent);
  EXPECT_TRUE(found.ways.empty());
}

TEST(Trouble, StopsTryingWhenCancelled) {
  const auto dual = make_dual(one_hat());
  Progress progress;
  progress.cancel();
  const Releases found = find_releases(dual, with_brim_pinned(*dual), {}, progress);
  EXPECT_TRUE(found.was_cancelled);
  EXPECT_FALSE(found.are_innocent);
  EXPECT_TRUE(found.ways.empty());
}

TEST(Trouble, TellsPinsInWords) {
  const auto dual = make_dual(shapes::cube());
  const Mesh& mesh = dual->mesh();
  const HalfedgeId h = mesh.first(FaceId(2));
  const NumberOfFace number = [](FaceId f) { return f.value + 1; };
  const std::vector<Pin> pins{{Pin::Kind::MustFold, mesh.edge(h), {}},
                              {Pin::Kind::Patch, {}, {FaceId(3), FaceId(4)}}};
  const std::string words = pins_words(mesh, pins, number);
  EXPECT_NE(words.find("the must-fold between faces "), std::string::npos) << words;
  EXPECT_NE(words.find(" and the patch of 2 faces at face 4"), std::string::npos) << words;
}

}  // namespace
}  // namespace netwright
