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

Project remake(Project project, const Recipe& recipe, std::shared_ptr<const MadeModel> made) {
  Recipe turned_only = project.recipe;
  turned_only.up = recipe.up;
  if (turned_only == recipe) {
    project.recipe = recipe;
    project.dual = made->dual;
    project.made = std::move(made);
    return project;
  }
  FaceId root;
  if (project.pinned_root.is_valid()) {
    const int source = project.dual->mesh().face_source(project.pinned_root);
    for (const FaceId f : made->dual->mesh().faces())
      if (made->dual->mesh().face_source(f) == source && !root.is_valid()) root = f;
  }
  project.recipe = recipe;
  project.dual = made->dual;
  project.made = std::move(made);
  project.pinned_root = root;
  project.tree = nullptr;
  project.run.reset();
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
