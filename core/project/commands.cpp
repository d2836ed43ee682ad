// The edits. Each takes its Project by value and hands it back changed.
#include "core/project/commands.h"

namespace netwright {

Project new_project(const Project& before, std::filesystem::path path,
                    std::shared_ptr<const DualGraph> dual) {
  Project project;
  project.path = std::move(path);
  project.dual = std::move(dual);
  project.paper = before.paper;
  return project;
}

Project pin_root(Project project, FaceId face) {
  project.pinned_root = face;
  if (!face.is_valid() || !project.tree || project.tree->is_root(face)) return project;
  UnfoldTree tree = *project.tree;
  tree.reroot(project.dual->mesh(), face);
  project.tree = std::make_shared<const UnfoldTree>(std::move(tree));
  return project;
}

Project accept_tree(Project project, UnfoldTree tree, const RunSummary& run) {
  project.tree = std::make_shared<const UnfoldTree>(std::move(tree));
  project.run = run;
  return project;
}

Project set_seed(Project project, std::uint64_t seed) {
  project.seed = seed;
  return project;
}

Project set_paper(Project project, const PaperSetup& paper) {
  project.paper = paper;
  return project;
}

Project set_size(Project project, const PrintSize& size) {
  project.size = size;
  return project;
}

}  // namespace netwright
