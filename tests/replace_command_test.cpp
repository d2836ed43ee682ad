// netwright-cli replace: a changed version of the model in a project's place.
#include "core/project/project_file.h"
#include "core/project/recipe.h"
#include "tests/cli_support.h"

namespace netwright {
namespace {

class ReplaceCommandLine : public CommandLine {
 protected:
  /// A project of a ball with a net and three pins.
  std::string write_project(Strings options = {}) {
    std::string project = at("ball.netwright");
    Strings words{
        "unfold",      write("ball.obj", shapes::icosphere(3)), "-o", project, "--seed", "5", "--root", "7",
        "--must-fold", "7:" + std::to_string(neighbour_of(7))};
    words.insert(words.end(), options.begin(), options.end());
    EXPECT_EQ(run(words).status, 0);
    return project;
  }
  /// A face beside this one, both counted from 1.
  static int neighbour_of(int face) {
    const auto mesh = testing::make_mesh(shapes::icosphere(3));
    return mesh->neighbour(mesh->first(FaceId(face - 1))).value + 1;
  }
  /// The ball with one corner pulled out.
  static PolygonSoup pulled() {
    PolygonSoup soup = shapes::icosphere(3);
    soup.points.back() *= 1.15;
    return soup;
  }
};

TEST_F(ReplaceCommandLine, KeepsPinsNetAndSettingsAndProvesTheResult) {
  const std::string project = write_project({"--paper", "A5"});
  const std::string out = at("new.netwright");
  const Ended ended = run({"replace", project, write("ball2.obj", pulled()), "-o", out, "-o", at("new.pdf")});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("ball2.obj takes the place of ball.obj"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("2 pins: "), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("proved"), std::string::npos) << ended.out;
  EXPECT_EQ(run({"verify", out}).status, 0);
  const Project old = load_project(project).project;
  const Project now = load_project(out).project;
  EXPECT_EQ(now.paper.format, "A5");
  EXPECT_EQ(now.seed, 5U);
  EXPECT_EQ(now.pins.must_fold.size(), 1U);
  EXPECT_TRUE(now.pins.root.is_valid());
  EXPECT_TRUE(now.run->is_proved);
  EXPECT_EQ(now.path, std::filesystem::path(at("ball2.obj")));
  // The faces have the same numbers, so folds can be compared one by one.
  int n_changed = 0;
  for (const EdgeId e : now.dual->mesh().edges())
    n_changed += old.tree->is_fold(old.dual->mesh(), e) != now.tree->is_fold(now.dual->mesh(), e) ? 1 : 0;
  EXPECT_LE(n_changed, 12) << "of " << now.dual->mesh().n_faces() - 1 << " folds";
  EXPECT_TRUE(std::filesystem::exists(at("new.pdf")));
}

TEST_F(ReplaceCommandLine, TellsWhatCouldNotBeKept) {
  const std::string project = write_project();
  PolygonSoup elsewhere = shapes::cuboid({2, 0.1, 0.1});
  const Ended ended = run({"replace", project, write("bar.obj", elsewhere), "-o", at("bar.netwright")});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("Not kept: The root is gone"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("0 of 2 pins kept"), std::string::npos) << ended.out;
  EXPECT_FALSE(load_project(at("bar.netwright")).project.pins.root.is_valid());
}

TEST_F(ReplaceCommandLine, JsonCountsPinsAndFolds) {
  const std::string project = write_project();
  const Json json = run_json(
      {"replace", project, write("same.obj", shapes::icosphere(3)), "-o", at("same.netwright"), "--json"}, 0);
  const Json* const replaced = json.find("replaced");
  ASSERT_NE(replaced, nullptr);
  EXPECT_EQ(replaced->find("pins")->integer(), 2);
  EXPECT_EQ(replaced->find("pins_kept")->integer(), 2);
  EXPECT_EQ(replaced->find("pins_lost")->integer(), 0);
  EXPECT_EQ(replaced->find("folds")->integer(), replaced->find("folds_kept")->integer());
  EXPECT_EQ(json.find("iterations")->integer(), 0) << "nothing had to move";
  EXPECT_EQ(*load_project(at("same.netwright")).project.tree, *load_project(project).project.tree);
}

TEST_F(ReplaceCommandLine, FollowsTheRecipeAgain) {
  const std::string project = at("few.netwright");
  const std::string model = write("ball.obj", shapes::icosphere(3));
  ASSERT_EQ(run({"unfold", model, "-o", project, "--simplify", "60"}).status, 0);
  ASSERT_EQ(run({"replace", project, write("ball2.obj", pulled()), "-o", at("new.netwright")}).status, 0);
  const Project now = load_project(at("new.netwright")).project;
  EXPECT_EQ(now.recipe.faces, 60);
  EXPECT_LE(now.dual->mesh().n_faces(), 60U);
}

TEST_F(ReplaceCommandLine, ABrokenVersionNeedsRepair) {
  const std::string project = write_project();
  PolygonSoup broken = shapes::icosphere(3);
  broken.add_face(std::vector<int>(broken.face(0).begin(), broken.face(0).end()));
  const std::string file = write("broken.obj", broken);
  expect_refusal(run({"replace", project, file, "-o", at("new.netwright")}), "Or add --repair.");
  EXPECT_EQ(run({"replace", project, file, "-o", at("new.netwright"), "--repair"}).status, 0);
}

TEST_F(ReplaceCommandLine, WrongWordsAreRefused) {
  const std::string project = write_project();
  const std::string model = at("ball.obj");
  expect_refusal(run({"replace", model, model, "-o", at("x.netwright")}), "is no project");
  expect_refusal(run({"replace", project, project, "-o", at("x.netwright")}), "is a project");
  expect_refusal(run({"replace", project, model}), "--output");
  expect_refusal(run({"replace", project, at("missing.obj"), "-o", at("x.netwright")}), "missing.obj");
  expect_refusal(run({"replace", project, model, "-o", at("x.txt")}), "Cannot tell how to write");
}

}  // namespace
}  // namespace netwright
