// The least change of shape that gives a net: found, bounded, kept in the recipe and in the project's file.
#include "core/project/soften.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/project/project_file.h"
#include "tests/support.h"

namespace netwright {
namespace {

struct Stuck {
  std::shared_ptr<const PolygonSoup> source;
  std::shared_ptr<const MadeModel> made;
  SolveOptions options;
  Trouble trouble;
  double diagonal = 0;
};

/// A tetrahedron with a hat on every face: there is no net of it.
Stuck stuck() {
  Stuck stuck;
  stuck.source = std::make_shared<const PolygonSoup>(testing::with_hats(shapes::tetrahedron()));
  Progress progress;
  stuck.made = std::make_shared<const MadeModel>(make_model(stuck.source, {}, nullptr, progress));
  stuck.options.streams = 1;
  stuck.options.max_iterations = 1000;
  const SolveResult result = solve(stuck.made->dual, stuck.options, progress);
  EXPECT_FALSE(result.is_proved);
  stuck.trouble = find_trouble(result);
  stuck.diagonal = glm::length(stuck.made->dual->mesh().box().size());
  return stuck;
}

Softening softened(const Stuck& stuck, double most) {
  Progress progress;
  return soften(stuck.source, {}, *stuck.made, stuck.options, stuck.trouble, most, progress);
}

TEST(Soften, FindsAShapeNearbyThatHasANet) {
  const Stuck model = stuck();
  const Softening found = softened(model, 0.3 * model.diagonal);
  ASSERT_TRUE(found.is_found());
  EXPECT_GT(found.n_moved, 0);
  EXPECT_GT(found.deviation, 0);
  EXPECT_LE(found.deviation, 0.3 * model.diagonal);
  Progress progress;
  const MadeModel again = make_model(model.source, found.recipe, nullptr, progress);
  ASSERT_TRUE(again.dual);
  EXPECT_TRUE(solve(again.dual, model.options, progress).is_proved);
}

TEST(Soften, GoesNoFartherThanItMay) {
  const Stuck model = stuck();
  EXPECT_FALSE(softened(model, 1e-6 * model.diagonal).is_found());
}

TEST(Soften, IsLeftOutWhereTheCornersAreNotThere) {
  const auto source = std::make_shared<const PolygonSoup>(shapes::cube());
  Recipe recipe;
  recipe.moved = {{{5, 5, 5}, {6, 6, 6}}};
  Progress progress;
  const MadeModel made = make_model(source, recipe, nullptr, progress);
  ASSERT_TRUE(made.dual);
  EXPECT_EQ(made.n_moved, 0);
  EXPECT_EQ(made.dual->mesh().n_faces(), 6U);
  ASSERT_FALSE(made.done.empty());
  EXPECT_NE(made.done.back().find("Not softened"), std::string::npos);
}

TEST(Soften, StaysInTheProjectsFile) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                     ("netwright_soften_" + std::to_string(getpid()) + ".netwright");
  const auto source = std::make_shared<const PolygonSoup>(shapes::cube());
  Project project;
  project.source = source;
  project.path = "cube.obj";
  const glm::dvec3 corner = source->points.front();
  project.recipe.moved = {{corner, corner * 0.9}};
  Progress progress;
  project.made = std::make_shared<const MadeModel>(make_model(source, project.recipe, nullptr, progress));
  project.dual = project.made->dual;
  ASSERT_EQ(project.made->n_moved, 1);
  save_project(project, file);
  const Project read = load_project(file).project;
  std::filesystem::remove(file);
  EXPECT_EQ(read.recipe, project.recipe);
  EXPECT_EQ(read.dual->mesh().n_faces(), project.dual->mesh().n_faces());
}

TEST(Soften, EndsWhenCancelled) {
  const Stuck model = stuck();
  Progress progress;
  progress.cancel();
  const Softening found =
      soften(model.source, {}, *model.made, model.options, model.trouble, model.diagonal, progress);
  EXPECT_TRUE(found.was_cancelled);
  EXPECT_FALSE(found.is_found());
}

}  // namespace
}  // namespace netwright
