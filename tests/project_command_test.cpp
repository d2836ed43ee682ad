// Project files on the command line: written by unfold, proved by verify, told of by info, unfolded again.
#include "core/project/project_file.h"
#include "core/unfold/overlap.h"
#include "tests/cli_support.h"

namespace netwright {
namespace {

class ProjectCommand : public CommandLine {
 protected:
  /// A project with a net, found with seed 5.
  std::string write_project(const PolygonSoup& soup, Strings options = {}) {
    std::string project = at("model.netwright");
    options.insert(options.begin(), {"unfold", write("model.obj", soup), "-o", project, "--seed", "5"});
    EXPECT_EQ(run(options).status, 0);
    return project;
  }
};

/// All faces hang on each other as far from `first` as they are: nobody looks out for overlaps.
UnfoldTree ring_by_ring(const Mesh& mesh, FaceId first) {
  IdVector<EdgeId, char> is_fold(mesh.n_edges(), 0);
  IdVector<FaceId, char> is_seen(mesh.n_faces(), 0);
  std::vector<FaceId> reached{first};
  is_seen[first] = 1;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const HalfedgeId h : mesh.halfedges(reached[i])) {
      const FaceId next = mesh.neighbour(h);
      if (!next.is_valid() || is_seen[next] != 0) continue;
      is_seen[next] = 1;
      is_fold[mesh.edge(h)] = 1;
      reached.push_back(next);
    }
  }
  return tree_from_folds(mesh, is_fold, first);
}

TEST_F(ProjectCommand, UnfoldWritesAProjectThatHoldsItAll) {
  const std::string file =
      write_project(shapes::torus(8, 6), {"--paper", "A3", "--height", "120", "--root", "1", "--merge"});
  const Project project = load_project(file).project;
  EXPECT_EQ(project.source->n_faces(), 96);
  EXPECT_EQ(project.path, std::filesystem::path(at("model.obj")));
  EXPECT_TRUE(project.recipe.merges);
  EXPECT_EQ(project.seed, 5U);
  EXPECT_EQ(project.paper.format, "A3");
  EXPECT_EQ(project.size, (PrintSize{PrintSize::Kind::Height, 120}));
  ASSERT_TRUE(project.tree && project.run);
  EXPECT_TRUE(project.run->is_proved);
  EXPECT_EQ(project.run->seed, 5U);
  EXPECT_EQ(project.tree->roots(), std::vector<FaceId>{project.pins.root});
}

TEST_F(ProjectCommand, VerifyProvesTheStoredNet) {
  const std::string file = write_project(shapes::letter_e());
  const Ended ended = run({"verify", file});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("in one piece"), std::string::npos) << ended.out;
  const Json json = run_json({"verify", file, "--json"}, 0);
  EXPECT_EQ(json.find("verified")->boolean(), true);
  EXPECT_EQ(json.find("faces")->integer(), 14);
}

TEST_F(ProjectCommand, VerifySeesThroughAProjectThatOnlySaysItIsProved) {
  const std::string file = write_project(shapes::hat());
  Project project = load_project(file).project;
  const std::shared_ptr<const DualGraph> dual = project.dual;
  for (const FaceId f : dual->mesh().faces()) {
    const auto rings = std::make_shared<const UnfoldTree>(ring_by_ring(dual->mesh(), f));
    if (find_overlaps(layout(dual, *rings), 1e-6).empty()) continue;
    project.tree = rings;
    save_project(project, file);
    const Ended ended = run({"verify", file});
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.out.find("Not a net"), std::string::npos) << ended.out;
    EXPECT_NE(run({"info", file}).out.find("not proved"), std::string::npos);
    return;
  }
  ADD_FAILURE() << "no tree of the hat overlaps any more";
}

TEST_F(ProjectCommand, UnfoldTakesTheStoredNetAndTheStoredSettings) {
  const std::string file = write_project(shapes::icosphere(2), {"--paper", "A5"});
  const Ended ended = run({"unfold", file, "-o", at("net.fold"), "-o", at("net.pdf")});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("holds a proved net"), std::string::npos) << ended.err;
  EXPECT_NE(ended.out.find("seed 5"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("A5"), std::string::npos) << ended.out;
  EXPECT_EQ(run({"verify", at("net.fold")}).status, 0);
  const Ended direct =
      run({"unfold", at("model.obj"), "--seed", "5", "--paper", "A5", "-o", at("direct.fold")});
  EXPECT_EQ(direct.status, 0);
  EXPECT_EQ(content(at("net.fold")), content(at("direct.fold")));
}

TEST_F(ProjectCommand, UnfoldSearchesAnewWhenAskedTo) {
  const std::string file = write_project(shapes::icosphere(2));
  EXPECT_EQ(run({"unfold", file, "--seed", "6", "-o", at("other.netwright")}).status, 0);
  const Project other = load_project(at("other.netwright")).project;
  EXPECT_EQ(other.run->seed, 6U);
  EXPECT_NE(*other.tree, *load_project(file).project.tree);
  EXPECT_EQ(run({"unfold", file, "--simplify", "40", "-o", at("less.netwright")}).status, 0);
  const Project less = load_project(at("less.netwright")).project;
  EXPECT_EQ(less.dual->mesh().n_faces(), 40U);
  EXPECT_EQ(less.source->n_faces(), 80) << "all faces of the file stay in the project";
}

TEST_F(ProjectCommand, InfoTellsOfAProject) {
  const std::string file = write_project(shapes::icosphere(2), {"--simplify", "40"});
  const Ended ended = run({"info", file});
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.out.find("A project made of model.obj"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("Simplified from 80 to 40 faces."), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("A net in one piece, proved (seed 5)."), std::string::npos) << ended.out;
  const Json json = run_json({"info", file, "--json"}, 0);
  EXPECT_EQ(json.find("faces")->integer(), 40);
  const Json* const project = json.find("project");
  ASSERT_NE(project, nullptr);
  EXPECT_EQ(project->find("source_faces")->integer(), 80);
  EXPECT_EQ(project->find("verified")->boolean(), true);
}

TEST_F(ProjectCommand, DamagedAndEmptyProjectsAreRefusedInOneSentence) {
  const std::string file = write_project(shapes::cube());
  const std::string bytes = content(file);
  expect_refusal(run({"info", write("short.netwright", bytes.substr(0, bytes.size() / 2))}),
                 "short.netwright is damaged");
  expect_refusal(run({"verify", write("empty.netwright", std::string())}), "empty.netwright is empty");
  expect_refusal(run({"unfold", write("text.netwright", std::string("v 0 0 0\n"))}),
                 "is no Netwright project");
  expect_refusal(run({"unfold", at("missing.netwright")}), "does not exist");
}

TEST_F(ProjectCommand, VerifySaysThatAProjectHasNoNet) {
  const std::string file = write_project(shapes::cube());
  Project project = load_project(file).project;
  project.tree = nullptr;
  project.run.reset();
  save_project(project, file);
  expect_refusal(run({"verify", file}), "without a net");
  EXPECT_NE(run({"info", file}).out.find("No net yet."), std::string::npos);
}

TEST_F(ProjectCommand, AFailedSaveLeavesTheOldProject) {
  const std::string file = write_project(shapes::cube());
  const std::string before = content(file);
  expect_refusal(run({"unfold", at("model.obj"), "-o", at("no_folder/x.netwright")}), "does not exist");
  EXPECT_EQ(content(file), before);
}

}  // namespace
}  // namespace netwright
