// Another version of a model in the place of the one a project was made for.
#include "core/project/replace_model.h"

#include <gtest/gtest.h>

#include "core/project/commands.h"
#include "core/project/open_model.h"
#include "core/solve/solve.h"
#include "tests/pins.h"
#include "tests/support.h"

namespace netwright {
namespace {

std::shared_ptr<const PolygonSoup> shared(PolygonSoup soup) {
  return std::make_shared<const PolygonSoup>(std::move(soup));
}

Project project_of(PolygonSoup soup, const Recipe& recipe = {}) {
  Progress progress;
  Project project;
  project.path = "/somewhere/" + soup.name;
  project.source = shared(std::move(soup));
  MadeModel made = make_model(project.source, recipe, nullptr, progress);
  add_survey(made, progress);
  project.recipe = recipe;
  project.dual = made.dual;
  project.made = std::make_shared<const MadeModel>(std::move(made));
  return project;
}

Project with_net(Project project) {
  Progress progress;
  SolveOptions options;
  options.pins = project.pins;
  const SolveResult result = solve(project.dual, options, progress);
  EXPECT_TRUE(result.is_proved);
  return accept_tree(std::move(project), result.net.tree, {0, result.moves, 0, 0, 0, true});
}

Replacement replaced(const Project& old, PolygonSoup soup) {
  Progress progress;
  return replace_model(old, "/elsewhere/new.obj", shared(std::move(soup)), std::nullopt, progress);
}

SolveResult solved_from(const Replacement& replacement) {
  Progress progress;
  SolveOptions options;
  options.pins = pins_with_edits(replacement.project);
  options.from = replacement.start;
  options.stays_near = true;
  return solve(replacement.project.dual, options, progress);
}

int n_changed_folds(const Mesh& mesh, const UnfoldTree& a, const UnfoldTree& b) {
  int n = 0;
  for (const EdgeId e : mesh.edges()) n += a.is_fold(mesh, e) != b.is_fold(mesh, e) ? 1 : 0;
  return n;
}

const MeshReport::Line* line_with(const ReplaceReport& report, const std::string& words) {
  for (const MeshReport::Line& line : report.lines)
    if (line.text.find(words) != std::string::npos) return &line;
  return nullptr;
}

/// The same ball with its faces listed from the other end and its points renumbered.
PolygonSoup relisted(const PolygonSoup& soup) {
  PolygonSoup other;
  other.name = soup.name;
  const int n = static_cast<int>(soup.points.size());
  for (int p = n - 1; p >= 0; --p) other.points.push_back(soup.points[static_cast<std::size_t>(p)]);
  for (int f = soup.n_faces() - 1; f >= 0; --f) {
    std::vector<int> corners;
    for (const int c : soup.face(f)) corners.push_back(n - 1 - c);
    other.add_face(corners);
  }
  return other;
}

/// The face is taken out and three come in its place, around a point above it.
PolygonSoup with_spike(const PolygonSoup& soup, int spiked, double height) {
  PolygonSoup other;
  other.name = "spiked.obj";
  other.points = soup.points;
  for (int f = 0; f < soup.n_faces(); ++f) {
    const std::vector<int> corners(soup.face(f).begin(), soup.face(f).end());
    if (f != spiked) {
      other.add_face(corners);
      continue;
    }
    const glm::dvec3 centre = (soup.points[static_cast<std::size_t>(corners[0])] +
                               soup.points[static_cast<std::size_t>(corners[1])] +
                               soup.points[static_cast<std::size_t>(corners[2])]) /
                              3.0;
    other.points.push_back(centre * (1 + height));
    const int top = static_cast<int>(other.points.size()) - 1;
    for (std::size_t k = 0; k < 3; ++k)
      other.add_face(std::vector<int>{corners[k], corners[(k + 1) % 3], top});
  }
  return other;
}

TEST(ReplaceModel, TheSameFacesInAnotherOrderKeepEveryPinAndTheWholeNet) {
  Random random(7);
  for (const auto& shape : testing::zoo()) {
    Project old = project_of(shape.soup);
    if (!old.dual) continue;
    old.pins = testing::random_pins(*old.dual, 2, random);
    Progress progress;
    SolveOptions options;
    options.pins = old.pins;
    options.max_iterations = 2000;
    const SolveResult before = solve(old.dual, options, progress);
    old.tree = std::make_shared<const UnfoldTree>(before.net.tree);
    const Replacement now = replaced(old, relisted(shape.soup));
    ASSERT_TRUE(now.refusal.empty()) << shape.soup.name << ": " << now.refusal;
    EXPECT_EQ(now.report.n_kept, now.report.n_pins) << shape.soup.name;
    EXPECT_EQ(now.report.n_lost, 0) << shape.soup.name;
    EXPECT_EQ(now.report.n_folds_kept, now.report.n_folds) << shape.soup.name;
    EXPECT_EQ(now.project.pins.must_fold.size(), old.pins.must_fold.size());
    EXPECT_EQ(now.project.pins.must_cut.size(), old.pins.must_cut.size());
    EXPECT_EQ(now.project.pins.together.size(), old.pins.together.size());
    EXPECT_EQ(now.project.tree, nullptr);
    if (!before.is_proved) continue;
    const SolveResult after = solved_from(now);
    ASSERT_TRUE(after.is_proved) << shape.soup.name;
    EXPECT_EQ(n_changed_folds(now.project.dual->mesh(), *now.start, after.net.tree), 0) << shape.soup.name;
  }
}

TEST(ReplaceModel, OnlyWhatMustChangeMovesWhenAFaceGetsASpike) {
  Random random(3);
  Project old = project_of(shapes::icosphere(4));
  old.pins = testing::random_pins(*old.dual, 4, random);
  old = with_net(old);
  const Replacement now = replaced(old, with_spike(shapes::icosphere(4), 100, 0.2));
  const Mesh& mesh = now.project.dual->mesh();
  ASSERT_EQ(mesh.n_faces(), 322U);
  EXPECT_GE(now.report.n_kept, now.report.n_pins - 1) << "all that are not about the face itself";
  EXPECT_GE(now.report.n_folds_kept, now.report.n_folds - 3);
  const SolveResult after = solved_from(now);
  ASSERT_TRUE(after.is_proved);
  EXPECT_TRUE(keeps_pins(mesh, after.net.tree, now.project.pins));
  EXPECT_LE(n_changed_folds(mesh, *now.start, after.net.tree), 24);
}

TEST(ReplaceModel, ATurnedScaledAndShiftedFileIsFoundAgain) {
  Random random(11);
  Project old = project_of(shapes::icosphere(3));
  old.pins = testing::random_pins(*old.dual, 3, random);
  PolygonSoup soup = shapes::icosphere(3);
  for (glm::dvec3& p : soup.points) p = 25.4 * glm::dvec3(p.x, -p.z, p.y) + glm::dvec3(3, 400, -20);
  soup.points[0] *= 1.001;
  const Replacement now = replaced(old, soup);
  EXPECT_EQ(now.report.n_lost, 0);
  EXPECT_GE(now.report.n_kept, now.report.n_pins - 2);
  ASSERT_NE(line_with(now.report, "25.4 times as large"), nullptr);
}

TEST(ReplaceModel, WhatIsGoneIsListedWithTheReasonAndThePlace) {
  Project old = project_of(shapes::combined(shapes::icosphere(2), shapes::cube(), {5, 0, 0}));
  const Mesh& mesh = old.dual->mesh();
  for (const EdgeId e : mesh.edges()) {
    if (mesh.component(mesh.face(mesh.halfedge(e))) != mesh.component(FaceId(80))) continue;
    if (old.pins.must_fold.size() < 2) set_pin(old.pins, e, EdgePin::MustFold);
  }
  old.pins.root = FaceId(82);
  set_pin(old.pins, EdgeId(7), EdgePin::MustCut);
  const Replacement now = replaced(old, shapes::icosphere(2));
  EXPECT_EQ(now.report.n_pins, 4);
  EXPECT_EQ(now.report.n_kept, 1);
  EXPECT_EQ(now.report.n_lost, 3);
  const MeshReport::Line* folds = line_with(now.report, "2 pinned folds are gone");
  ASSERT_NE(folds, nullptr);
  EXPECT_EQ(folds->kind, MeshReport::Line::Kind::Problem);
  ASSERT_EQ(folds->edge_places.size(), 2U);
  EXPECT_GT(folds->edge_places[0][0].x, 4) << "where the cube stood";
  const MeshReport::Line* root = line_with(now.report, "The root is gone");
  ASSERT_NE(root, nullptr);
  EXPECT_EQ(root->edge_places.size(), 4U) << "the sides of its face";
  EXPECT_FALSE(now.project.pins.root.is_valid());
  EXPECT_NE(now.report.summary.find("1 of 4 pins kept"), std::string::npos) << now.report.summary;
}

TEST(ReplaceModel, AMovedCornerTakesItsPinsAlong) {
  Project old = project_of(shapes::icosphere(3));
  const Mesh& mesh = old.dual->mesh();
  const VertexId corner = mesh.from(mesh.first(FaceId(0)));
  EdgeId pinned;
  for (const HalfedgeId h : mesh.halfedges())
    if (mesh.from(h) == corner) pinned = mesh.edge(h);
  set_pin(old.pins, pinned, EdgePin::MustFold);
  PolygonSoup soup = shapes::icosphere(3);
  for (glm::dvec3& p : soup.points)
    if (p == mesh.position(corner)) p *= 1.1;
  const Replacement now = replaced(old, soup);
  EXPECT_EQ(now.report.n_moved, 1);
  ASSERT_EQ(now.project.pins.must_fold.size(), 1U);
  const Mesh& to = now.project.dual->mesh();
  const HalfedgeId h = to.halfedge(now.project.pins.must_fold.front());
  const bool is_at_corner = glm::length(to.position(h)) > 1.05 * glm::length(mesh.position(corner)) ||
                            glm::length(to.position(to.next(h))) > 1.05 * glm::length(mesh.position(corner));
  EXPECT_TRUE(is_at_corner);
  EXPECT_NE(line_with(now.report, "1 pinned fold moved"), nullptr);
}

TEST(ReplaceModel, TheRecipeIsFollowedAgainWithPartsAndGroups) {
  PolygonSoup soup = shapes::combined(shapes::grid_cube(3), shapes::cube(0.4), {4, 0, 0});
  Recipe recipe;
  recipe.merges = true;
  Project plain = project_of(soup, recipe);
  const std::vector<ModelPart> parts = parts_of(*plain.made->stages->whole);
  recipe.left_out = {parts[1].first_face};
  recipe.apart = {plain.made->groups[FaceId(2)]};
  ASSERT_EQ(recipe.apart.front().size(), 9U);
  Project old = project_of(soup, recipe);
  ASSERT_EQ(old.dual->mesh().n_faces(), 5U + 9U);
  const Replacement now = replaced(old, relisted(soup));
  EXPECT_EQ(now.project.dual->mesh().n_faces(), 14U);
  EXPECT_TRUE(now.project.recipe.merges);
  EXPECT_EQ(now.project.recipe.left_out.size(), 1U);
  EXPECT_NE(now.project.recipe.left_out, recipe.left_out) << "the file's faces have other numbers now";
  EXPECT_EQ(line_with(now.report, "left out"), nullptr);

  const Replacement without = replaced(old, shapes::grid_cube(3));
  EXPECT_TRUE(without.project.recipe.left_out.empty());
  EXPECT_NE(line_with(without.report, "1 part that was left out is not there any more."), nullptr);
}

TEST(ReplaceModel, ABrokenVersionIsRefusedUnlessRepairsAreGiven) {
  Project old = project_of(shapes::cuboid({1, 2, 3}));
  PolygonSoup broken = shapes::cuboid({1, 2, 3});
  broken.add_face(std::vector<int>(broken.face(0).begin(), broken.face(0).end()));
  EXPECT_FALSE(replaced(old, broken).refusal.empty());
  Progress progress;
  const Replacement repaired = replace_model(old, "x.obj", shared(broken), usual_repair(), progress);
  EXPECT_EQ(repaired.refusal, "");
  EXPECT_EQ(repaired.project.recipe.repairs, usual_repair().repairs);
  EXPECT_EQ(repaired.project.dual->mesh().n_faces(), 6U);
}

TEST(ReplaceModel, PaperSizeAndSeedStay) {
  Project old = project_of(shapes::cube());
  old.paper.format = "A3";
  old.size = {PrintSize::Kind::Height, 90};
  old.seed = 12;
  const Replacement now = replaced(old, shapes::cuboid({1, 1.5, 1}));
  EXPECT_EQ(now.project.paper, old.paper);
  EXPECT_EQ(now.project.size, old.size);
  EXPECT_EQ(now.project.seed, 12U);
  EXPECT_EQ(now.project.path, std::filesystem::path("/elsewhere/new.obj"));
  EXPECT_NE(line_with(now.report, "1.5 times as tall"), nullptr);
}

/// Every other one of the corners around `middle`, going round.
bool is_up(const Mesh& mesh, VertexId middle, VertexId wanted) {
  HalfedgeId h;
  for (const HalfedgeId other : mesh.halfedges())
    if (!h.is_valid() && mesh.from(other) == middle) h = other;
  for (bool is_even = true;; is_even = !is_even) {
    if (mesh.to(h) == wanted) return is_even;
    h = mesh.twin(mesh.prev(h));
  }
}

TEST(ReplaceModel, PinsThatContradictEachOtherOnTheNewFacesAreLetGoOf) {
  Project old = project_of(shapes::icosphere(2));
  const Mesh& mesh = old.dual->mesh();
  // Five folds join all six faces around a corner, which lie flat there.
  VertexId five;
  for (const VertexId v : mesh.vertices()) {
    int n = 0;
    for (const HalfedgeId h : mesh.halfedges()) n += mesh.from(h) == v ? 1 : 0;
    if (n == 6) five = v;
  }
  std::vector<EdgeId> around;
  for (const HalfedgeId h : mesh.halfedges())
    if (mesh.from(h) == five) around.push_back(mesh.edge(h));
  ASSERT_EQ(around.size(), 6U);
  for (std::size_t k = 0; k < 5; ++k) set_pin(old.pins, around[k], EdgePin::MustFold);
  ASSERT_FALSE(find_contradiction(*old.dual, old.pins));
  // In the new version the faces go up and down around it: more than a full turn of paper.
  PolygonSoup soup = shapes::icosphere(2);
  for (std::size_t k = 0; k < around.size(); ++k) {
    const HalfedgeId h = mesh.halfedge(around[k]);
    const VertexId end = mesh.from(h) == five ? mesh.to(h) : mesh.from(h);
    for (glm::dvec3& p : soup.points)
      if (p == mesh.position(end)) p *= is_up(mesh, five, end) ? 1.35 : 0.75;
  }
  const Replacement now = replaced(old, soup);
  EXPECT_FALSE(find_contradiction(*now.project.dual, now.project.pins));
  EXPECT_EQ(now.report.n_kept + now.report.n_moved + now.report.n_lost, 5);
  EXPECT_GE(now.report.n_lost, 1);
  EXPECT_NE(line_with(now.report, "contradict"), nullptr);
}

}  // namespace
}  // namespace netwright
