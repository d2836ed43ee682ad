// Finished runs that are saved with the project and there again when it is opened.
#include "core/project/kept_runs.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/project/project_file.h"
#include "core/solve/disjoint_sets.h"
#include "core/solve/solve.h"
#include "tests/session_support.h"

namespace netwright {
namespace {

using namespace testing;

class KeptRuns : public SessionTest {
 protected:
  void run_seeds(int n) {
    for (int i = 0; i < n; ++i) {
      session_.set_seed(static_cast<std::uint64_t>(i));
      session_.unfold();
      ASSERT_TRUE(frames_until_idle());
    }
  }
  std::filesystem::path saved() {
    std::filesystem::path file = in_folder("kept.netwright");
    session_.save(file);
    EXPECT_TRUE(frames_until([this] { return !session_.is_saving(); }));
    return file;
  }
};

TEST_F(KeptRuns, AreThereAgainWhenTheProjectIsOpened) {
  open(bumpy());
  run_seeds(4);
  session_.accept_run(2);
  const std::vector<RunList::Entry> before = session_.runs();
  ASSERT_EQ(before.size(), 4U);
  const std::filesystem::path file = saved();
  open(ball());
  ASSERT_TRUE(session_.runs().empty());
  session_.open(file);
  ASSERT_TRUE(frames_until([&] { return session_.file() == file; }));
  ASSERT_TRUE(frames_until_idle());
  const std::vector<RunList::Entry> after = session_.runs();
  ASSERT_EQ(after.size(), 4U);
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(*after[i]->tree, *before[i]->tree);
    EXPECT_EQ(after[i]->summary, before[i]->summary);
    EXPECT_EQ(after[i]->number, before[i]->number);
    EXPECT_EQ(after[i]->score(), before[i]->score());
    EXPECT_EQ(after[i]->picture.rgba, before[i]->picture.rgba);
    EXPECT_EQ(after[i]->figures.moves, before[i]->figures.moves);
  }
  EXPECT_EQ(session_.accepted_run(), 2);
  EXPECT_FALSE(session_.is_modified());
  session_.view_run(3);
  ASSERT_TRUE(frames_until([this] { return session_.shown()->net.tree == *session_.runs()[2]->tree; }));
  EXPECT_TRUE(session_.shown()->is_proved);
  EXPECT_FALSE(session_.timeline()) << "its moves are not kept";
  session_.accept_run(3);
  EXPECT_EQ(*session_.project().tree, *before[2]->tree);
}

TEST_F(KeptRuns, OnlyTheBestOfManyAreKept) {
  open(ball());
  RunList list;
  const std::shared_ptr<const DualGraph> dual = session_.project().dual;
  SolveOptions options;
  Progress progress;
  const SolveResult result = solve(dual, options, progress);
  for (int i = 0; i < 30; ++i) {
    FinishedRun run;
    run.dual = dual;
    run.tree = std::make_shared<const UnfoldTree>(result.net.tree);
    run.summary.seed = static_cast<std::uint64_t>(i);
    run.summary.is_proved = true;
    run.measures.fill = i % 2 == 0 ? 0.5 : 0.1 + 0.001 * i;
    list.add(std::move(run));
  }
  const std::vector<KeptRun> kept = runs_to_keep(list, dual);
  ASSERT_EQ(kept.size(), kMostKeptRuns);
  EXPECT_EQ(
      std::count_if(kept.begin(), kept.end(), [](const KeptRun& run) { return run.summary.seed % 2 == 0; }),
      15);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end(), [](const KeptRun& a, const KeptRun& b) {
    return a.summary.seed < b.summary.seed;
  }));
  EXPECT_EQ(kept.back().summary.seed, 29U);
  EXPECT_TRUE(runs_to_keep(list, nullptr).empty());
}

TEST_F(KeptRuns, ARunThatOnlySaysItIsProvedIsNot) {
  open(bumpy());
  const std::shared_ptr<const DualGraph> dual = session_.project().dual;
  // Folds in the order of the edges: nobody looks out for overlaps.
  IdVector<EdgeId, char> is_fold(dual->mesh().n_edges(), 0);
  DisjointSets sets(dual->mesh().n_faces());
  for (const EdgeId e : dual->mesh().edges()) {
    const HalfedgeId h = dual->mesh().halfedge(e);
    if (!dual->mesh().is_border(e) && sets.join(dual->mesh().face(h).value, dual->mesh().neighbour(h).value))
      is_fold[e] = 1;
  }
  KeptRun forged{std::make_shared<const UnfoldTree>(tree_from_folds(dual->mesh(), is_fold)), {}};
  forged.summary.is_proved = true;
  const Progress progress;
  const std::vector<FinishedRun> runs = finished_again(dual, {forged}, progress);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_FALSE(runs[0].summary.is_proved);
  EXPECT_GT(runs[0].summary.overlaps, 0);
}

TEST_F(KeptRuns, AFileWithADamagedRunIsRefused) {
  open(bumpy());
  run_seeds(1);
  const Project& project = session_.project();
  const KeptRun good{project.tree, *project.run};
  EXPECT_EQ(parse_project(project_bytes(project, {}, nullptr, {good}), "x").runs.size(), 1U);
  EXPECT_TRUE(parse_project(project_bytes(project), "x").runs.empty()) << "files without runs are read";
  ProjectParts parts = to_parts(project, {}, nullptr, {good});
  const std::size_t runs = parts.json.find("\"runs\"");
  ASSERT_NE(runs, std::string::npos);
  const std::size_t tree = parts.json.find("-1", runs);
  parts.json.replace(tree, 2, "99");
  EXPECT_THROW(static_cast<void>(from_parts(parts, "x")), Error);
  const std::vector<KeptRun> many(kMostKeptRuns + 1, good);
  EXPECT_THROW(static_cast<void>(parse_project(project_bytes(project, {}, nullptr, many), "x")), Error);
}

}  // namespace
}  // namespace netwright
