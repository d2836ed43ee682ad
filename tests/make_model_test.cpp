// From a file's faces and a recipe to the mesh that is unfolded: what every ingredient does, and that stages
// kept from an earlier recipe change nothing but the time.
#include "core/project/make_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/predicates.h"
#include "core/mesh/difficulty.h"
#include "core/project/real_size.h"
#include "core/solve/solve.h"
#include "core/unfold/fold.h"
#include "tests/support.h"

namespace netwright {
namespace {

std::shared_ptr<const PolygonSoup> shared(PolygonSoup soup) {
  return std::make_shared<const PolygonSoup>(std::move(soup));
}

MadeModel make(const std::shared_ptr<const PolygonSoup>& soup, const Recipe& recipe,
               const std::shared_ptr<const ModelStages>& before = nullptr) {
  Progress progress;
  return make_model(soup, recipe, before, progress);
}

// A box whose lid is lifted at one corner: a quad that is not flat.
PolygonSoup bent_box() {
  PolygonSoup soup = shapes::cuboid({2, 1, 3});
  soup.points.back() += glm::dvec3(0.1, 0.2, 0.15);
  soup.name = "bent.obj";
  return soup;
}

PolygonSoup with_a_doubled_face(PolygonSoup soup) {
  soup.add_face(std::vector<int>(soup.face(2).begin(), soup.face(2).end()));
  return soup;
}

bool has_net(const MadeModel& model) {
  Progress progress;
  SolveOptions options;
  options.max_iterations = 50'000;
  return solve(model.dual, options, progress).is_proved;
}

void expect_same(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.n_faces(), b.n_faces());
  ASSERT_EQ(a.n_vertices(), b.n_vertices());
  for (const VertexId v : a.vertices()) EXPECT_EQ(a.position(v), b.position(v));
  for (const FaceId f : a.faces()) EXPECT_EQ(a.face_source(f), b.face_source(f));
}

TEST(MakeModel, WithoutARecipeASoundModelStaysAsItIs) {
  for (const auto& shape : testing::zoo()) {
    const MadeModel model = make(shared(shape.soup), {});
    ASSERT_TRUE(model.dual) << shape.soup.name;
    EXPECT_EQ(static_cast<int>(model.dual->mesh().n_faces()), shape.soup.n_faces());
    EXPECT_TRUE(model.done.empty()) << model.done.front();
  }
}

TEST(MakeModel, UnevenFacesAreRefusedSplitOrFlattenedAsAsked) {
  const auto soup = shared(bent_box());
  const MadeModel refused = make(soup, {});
  EXPECT_FALSE(refused.dual);
  EXPECT_NE(refused.refusal.find("flat"), std::string::npos) << refused.refusal;
  const MadeModel split = make(soup, {.uneven = UnevenFaces::Split});
  ASSERT_TRUE(split.dual);
  EXPECT_GT(split.dual->mesh().n_faces(), 6U);
  EXPECT_TRUE(has_net(split));
  const MadeModel flat = make(soup, {.uneven = UnevenFaces::Flatten});
  ASSERT_TRUE(flat.dual) << flat.refusal;
  EXPECT_EQ(flat.dual->mesh().n_faces(), 6U);
  EXPECT_TRUE(has_net(flat));
  for (const MadeModel* model : {&split, &flat}) EXPECT_EQ(model->done.size(), 1U);
}

TEST(MakeModel, RepairIsOnlyDoneWhenAskedFor) {
  const auto soup = shared(with_a_doubled_face(shapes::cube()));
  const MadeModel broken = make(soup, {});
  EXPECT_FALSE(broken.dual);
  EXPECT_FALSE(broken.refusal.empty());
  const MadeModel repaired = make(soup, {.repairs = Repairs{}});
  ASSERT_TRUE(repaired.dual) << repaired.refusal;
  EXPECT_EQ(repaired.dual->mesh().n_faces(), 6U);
  EXPECT_FALSE(repaired.done.empty());
  EXPECT_TRUE(has_net(repaired));
}

TEST(MakeModel, WhatItTakesForFlatPassesTheProofEvenWithManyShortSides) {
  // The lid is 40 sides wide: measured against its width it would be flat long after its sides are not.
  const auto rippled = [](double height) {
    PolygonSoup drum = shapes::regular_prism(40, 1);
    double side = 0;
    const auto lid = drum.face(drum.n_faces() - 1);
    for (std::size_t i = 0; i < lid.size(); ++i) {
      const glm::dvec3& next = drum.points[static_cast<std::size_t>(lid[(i + 1) % lid.size()])];
      side = std::max(side, glm::length(next - drum.points[static_cast<std::size_t>(lid[i])]));
    }
    for (std::size_t i = 0; i < lid.size(); ++i)
      drum.points[static_cast<std::size_t>(lid[i])].y += (i % 2 == 0 ? height : -height) * side;
    return make(shared(drum), {});
  };
  const MadeModel flat = rippled(0.98 * kFlatness);
  ASSERT_TRUE(flat.dual) << flat.refusal;
  EXPECT_TRUE(has_net(flat));
  const MadeModel uneven = rippled(1.02 * kFlatness);
  EXPECT_FALSE(uneven.dual);
  EXPECT_NE(uneven.refusal.find("not flat"), std::string::npos) << uneven.refusal;
}

TEST(MakeModel, SimplifiesAndMergesToModelsThatUnfold) {
  const auto ball = shared(shapes::icosphere(8));
  const MadeModel fewer = make(ball, {.faces = 200});
  ASSERT_TRUE(fewer.dual);
  EXPECT_LE(fewer.dual->mesh().n_faces(), 200U);
  EXPECT_GE(fewer.dual->mesh().n_faces(), 190U);
  EXPECT_TRUE(fewer.dual->mesh().is_closed());
  EXPECT_FALSE(fewer.deviation.has_value()) << "not measured yet";
  EXPECT_GT(measure_deviation(fewer, Progress()), 0);
  EXPECT_EQ(fewer.difficulty, predicted_difficulty(fewer.dual->mesh()));
  EXPECT_TRUE(has_net(fewer));
  const MadeModel merged = make(shared(shapes::grid_cube(3)), {.merges = true});
  EXPECT_EQ(merged.dual->mesh().n_faces(), 6U);
  EXPECT_TRUE(has_net(merged));
}

TEST(MakeModel, StagesKeptFromEarlierChangeOnlyTheTime) {
  const auto soup = shared(shapes::torus(20, 12));
  MadeModel model = make(soup, {});
  for (const Recipe& recipe : {Recipe{.faces = 100}, Recipe{.faces = 60}, Recipe{.faces = 60, .merges = true},
                               Recipe{.faces = 300}, Recipe{.repairs = Repairs{}, .faces = 80}, Recipe{}}) {
    model = make(soup, recipe, model.stages);
    expect_same(model.dual->mesh(), make(soup, recipe).dual->mesh());
  }
}

TEST(MakeModel, HeightIsAlongTheAxisThatIsUp) {
  const auto soup = shared(shapes::cuboid({2, 1, 3}));
  ASSERT_EQ(soup->up_axis, UpAxis::Y);
  EXPECT_EQ(make(soup, {}).dual->mesh().height(), 1);
  const MadeModel upright = make(soup, {.up = UpAxis::Z, .faces = 8, .merges = true});
  EXPECT_EQ(upright.dual->mesh().height(), 3);
  EXPECT_EQ(make(soup, {.up = UpAxis::Y}, upright.stages).dual->mesh().height(), 1);
}

TEST(MakeModel, NetsOfSplitAndRepairedModelsNameEveryFaceOnce) {
  PolygonSoup holed = shapes::icosphere(3);
  holed.corners.resize(holed.corners.size() - 3);
  holed.face_begin.pop_back();
  for (const auto& [soup, recipe] :
       {std::pair{shared(bent_box()), Recipe{.repairs = Repairs{}, .uneven = UnevenFaces::Split}},
        std::pair{shared(holed), Recipe{.repairs = Repairs{}}}}) {
    const MadeModel model = make(soup, recipe);
    ASSERT_TRUE(model.dual);
    EXPECT_TRUE(has_net(model)) << soup->name;
  }
}

/// A box with a ball inside, a crumb beside them and a second box, in the order of the file: crumb, ball,
/// box, box.
PolygonSoup four_parts() {
  PolygonSoup soup = shapes::combined(shapes::cube(0.1), shapes::icosphere(2), {9.5, 2, 0.3});
  soup = shapes::combined(soup, shapes::cube(4), {9, 0, 0});
  return shapes::combined(soup, shapes::cube(3), {20, 0, 0});
}

TEST(MakeModel, ListsPartsTheLargestFirst) {
  const MadeModel model = make(shared(four_parts()), {});
  ASSERT_TRUE(model.dual) << model.refusal;
  const std::vector<ModelPart> parts = parts_of(model.dual->mesh());
  ASSERT_EQ(parts.size(), 4U);
  EXPECT_EQ(parts[0].size, glm::dvec3(4));
  EXPECT_EQ(parts[3].first_face, 0);
  EXPECT_EQ(parts[3].faces.size(), 6U);
  for (std::size_t p = 0; p < 4; ++p) {
    EXPECT_EQ(parts[p].is_inner, parts[p].faces.size() == 80U) << p;
    EXPECT_EQ(parts[p].is_small, p == 3) << p;
  }
}

TEST(MakeModel, LeavesPartsOutByAFaceOfTheFile) {
  const auto soup = shared(four_parts());
  const MadeModel all = make(soup, {});
  const MadeModel fewer = make(soup, {.left_out = {0, 6}, .merges = true}, all.stages);
  ASSERT_TRUE(fewer.dual) << fewer.refusal;
  EXPECT_EQ(fewer.dual->mesh().n_components(), 2U);
  EXPECT_EQ(fewer.dual->mesh().n_faces(), 12U);
  EXPECT_EQ(fewer.dual->mesh().face_source(FaceId(0)), 86) << "faces keep the file's numbers";
  EXPECT_EQ(fewer.done.front(), "Left out 2 of 4 parts.");
  EXPECT_TRUE(has_net(fewer));
  const MadeModel back = make(soup, {}, fewer.stages);
  expect_same(back.dual->mesh(), all.dual->mesh());
  const MadeModel none = make(soup, {.left_out = {0, 6, 86, 92}}, all.stages);
  EXPECT_FALSE(none.dual);
  EXPECT_NE(none.refusal.find("keep at least one"), std::string::npos) << none.refusal;
}

TEST(MakeModel, PartsAreLeftOutBeforeFacesAreCounted) {
  const auto soup = shared(shapes::combined(shapes::icosphere(6), shapes::icosphere(4), {9, 0, 0}));
  const MadeModel both = make(soup, {.faces = 300});
  const MadeModel one = make(soup, {.left_out = {0}, .faces = 300}, both.stages);
  EXPECT_EQ(one.stages->mesh->n_faces(), 320U);
  EXPECT_GT(one.dual->mesh().n_faces(), 290U);
  EXPECT_LE(one.dual->mesh().n_faces(), 300U);
  expect_same(one.dual->mesh(), make(soup, {.left_out = {0}, .faces = 300}).dual->mesh());
}

TEST(MakeModel, ASurveyTellsWhatThereIsToChoose) {
  Progress progress;
  PolygonSoup soup = with_a_doubled_face(four_parts());
  soup.points.back() += glm::dvec3(0.1, 0.2, 0.15);
  Recipe recipe{.repairs = Repairs{}, .uneven = UnevenFaces::Split};
  MadeModel model = make(shared(soup), recipe);
  ASSERT_TRUE(model.dual) << model.refusal;
  add_survey(model, progress);
  const ModelSurvey& survey = *model.stages->survey;
  EXPECT_EQ(survey.parts.size(), 4U);
  ASSERT_NE(survey.repairs.find(RepairStep::UnevenFaces), nullptr);
  EXPECT_EQ(survey.repairs.find(RepairStep::UnevenFaces)->left, 0);
  EXPECT_EQ(survey.repairs.find(RepairStep::DoubledFaces)->found, 1);
  recipe.merges = true;
  EXPECT_EQ(make(model.stages->source, recipe, model.stages).stages->survey, model.stages->survey);
}

TEST(RealSize, IsOddUnderTenMillimetresAndOverTwoMetres) {
  const auto odd = [](double size, const std::string& name) {
    PolygonSoup soup = shapes::cube(size);
    soup.name = name;
    return real_size(soup, *testing::make_mesh(soup)).is_odd();
  };
  EXPECT_TRUE(odd(9.9, "a.stl"));
  EXPECT_FALSE(odd(10.1, "a.stl"));
  EXPECT_FALSE(odd(1999, "a.stl"));
  EXPECT_TRUE(odd(2001, "a.stl"));
  EXPECT_TRUE(odd(3.2, "a.glb"));
  EXPECT_FALSE(odd(3.2, "a.obj")) << "centimetres, probably";
}

TEST(RealSize, OfASheetOnTheTableIsNotAskedFor) {
  const auto is_asked = [](glm::dvec3 size) {
    PolygonSoup soup = shapes::cuboid(size);
    return real_size(soup, *testing::make_mesh(soup)).is_worth_asking();
  };
  EXPECT_TRUE(is_asked({3000, 3000, 3000}));
  EXPECT_FALSE(is_asked({3000, 1, 3000}));
  EXPECT_FALSE(is_asked({300, 300, 300}));
}

TEST(RealSize, IsToldInTheUnitThatFits) {
  EXPECT_EQ(real_length_text(0.0021), "0.0021 mm");
  EXPECT_EQ(real_length_text(8.31), "8.3 mm");
  EXPECT_EQ(real_length_text(45.4), "45 mm");
  EXPECT_EQ(real_length_text(3200), "3.2 m");
  EXPECT_EQ(real_length_text(14e6), "14 km");
}

TEST(MakeModel, ACancelledMakingIsNoModelOfTheRecipe) {
  Progress progress;
  progress.cancel();
  const MadeModel model = make_model(shared(shapes::icosphere(4)), {.faces = 100}, nullptr, progress);
  EXPECT_TRUE(model.was_cancelled);
  EXPECT_EQ(model.stages->simplifier, nullptr);
}

TEST(MakeModel, ReportsWhatTheReaderMissed) {
  PolygonSoup cube = shapes::grid_cube(2);
  cube.notices = {"The picture gone.png was not found; its faces stay plain."};
  Progress progress;
  const auto source = std::make_shared<const PolygonSoup>(cube);
  for (const bool merges : {false, true}) {
    const MadeModel model = make_model(source, {.merges = merges}, nullptr, progress);
    EXPECT_EQ(model.report.count(MeshReport::Topic::MissingTextures), 1);
  }
}

TEST(MakeModel, EveryFaceOfTheFileIsFoundInTheMergedMesh) {
  const auto grid = shared(shapes::grid_cube(3));
  const MadeModel merged = make(grid, {.merges = true});
  ASSERT_EQ(merged.dual->mesh().n_faces(), 6U);
  for (int f = 0; f < 54; ++f) {
    const std::vector<FaceId> faces = faces_made_of(merged.origins, std::array{f});
    ASSERT_EQ(faces.size(), 1U) << f;
    const std::vector<int>& group = merged.groups[faces.front()];
    EXPECT_EQ(group.size(), 9U);
    EXPECT_NE(std::ranges::find(group, f), group.end());
    EXPECT_EQ(file_faces_of(merged.origins, faces.front()), group);
  }
}

TEST(MakeModel, FacesThatSimplifyingSwallowedAreFoundInTheirHeirs) {
  const auto ball = shared(shapes::icosphere(6));
  const MadeModel fewer = make(ball, {.faces = 100});
  const Mesh& mesh = fewer.dual->mesh();
  for (int f = 0; f < ball->n_faces(); ++f) {
    const std::vector<FaceId> faces = faces_made_of(fewer.origins, std::array{f});
    ASSERT_EQ(faces.size(), 1U) << f;
    const glm::dvec3 there = ball->points[static_cast<std::size_t>(ball->face(f)[0])];
    EXPECT_LT(glm::distance(mesh.centre(faces.front()), there), 0.7) << "the heir is near by";
  }
}

TEST(MakeModel, AGroupThatIsSplitAgainStaysAsItWasAndTheOthersMerge) {
  const auto grid = shared(shapes::grid_cube(3));
  const MadeModel merged = make(grid, {.merges = true});
  const std::vector<int> group = merged.groups[FaceId(1)];
  const MadeModel split = make(grid, {.merges = true, .apart = {group}});
  EXPECT_EQ(split.dual->mesh().n_faces(), 5U + 9U);
  for (const int f : group) {
    const std::vector<FaceId> faces = faces_made_of(split.origins, std::array{f});
    ASSERT_EQ(faces.size(), 1U);
    EXPECT_TRUE(split.groups[faces.front()].empty());
  }
  for (const EdgeId e : split.dual->mesh().edges())
    EXPECT_FALSE(split.dual->is_hidden(e)) << "what was split on purpose is shown";
  EXPECT_TRUE(has_net(split));
}

TEST(MakeModel, FoldsThatAreAsGoodAsFlatAreHiddenWhenMergingCannotTakeThemAway) {
  // Top and bottom are rings around a hole: they have to stay in parts.
  const MadeModel merged = make(shared(shapes::cuboid_with_holes(1, 1)), {.merges = true});
  const Mesh& mesh = merged.dual->mesh();
  int n_hidden = 0;
  for (const EdgeId e : mesh.edges()) {
    n_hidden += merged.dual->is_hidden(e) ? 1 : 0;
    EXPECT_EQ(merged.dual->is_hidden(e), std::abs(merged.dual->bend(e)) < 1e-6);
  }
  EXPECT_GT(n_hidden, 0);
  UnfoldTree tree(mesh.n_faces());
  EdgeId hidden;
  for (const EdgeId e : mesh.edges())
    if (merged.dual->is_hidden(e)) hidden = e;
  tree.set_parent(mesh.face(mesh.halfedge(hidden)), mesh.halfedge(hidden));
  const IdVector<EdgeId, EdgeKind> kinds = edge_kinds(layout(merged.dual, tree));
  EXPECT_EQ(kinds[hidden], EdgeKind::Hidden);
  EXPECT_EQ(std::ranges::count(kinds, EdgeKind::Hidden), 1) << "the others are cut, and cuts are drawn";
}

}  // namespace
}  // namespace netwright
