// The edits. Each takes its Project by value and hands it back changed.
#include "core/project/commands.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/error.h"
#include "core/project/carry_pins.h"
#include "core/project/carry_settings.h"
#include "core/sheet/placing_edits.h"

namespace netwright {

namespace {

/// Where the pieces lie at another size; automatic when they would not fit as they lie.
HandLayout placed_at(const Project& project, const PrintSize& size) {
  if (project.placed.is_automatic()) return {};
  try {
    const std::optional<double> scale = scale_of(project.dual->mesh(), size);
    if (!scale) return {};
    const Net net = layout(project.dual, *project.tree);
    const std::optional<PageLayout> pages = lay_out(net, project.paper, project.placed, project.tabs);
    return pages ? resize_pieces(net, project.paper, *pages, *scale, project.tabs) : HandLayout();
  } catch (const Error&) {
    return {};  // a size that says nothing, or paper without room: that is told where the pages are made
  }
}

/// What was said of single edges means nothing for those of another mesh.
void forget_edges(Project& project) {
  project.tabs.edits.clear();
  project.sheet.hidden_folds.clear();
  project.sheet.shown_folds.clear();
}

}  // namespace

Project new_project(const Project& before, std::filesystem::path path,
                    std::shared_ptr<const DualGraph> dual) {
  Project project;
  project.path = std::move(path);
  project.dual = std::move(dual);
  project.paper = before.paper;
  project.tabs = before.tabs;
  project.sheet = before.sheet;
  project.exports = before.exports;
  forget_edges(project);
  return project;
}

Project remake(Project project, const Recipe& recipe, std::shared_ptr<const MadeModel> made) {
  Recipe turned_only = project.recipe;
  turned_only.up = recipe.up;
  if (turned_only == recipe) {
    // Another side up is another height, and with it another scale.
    if (project.size.kind == PrintSize::Kind::Height) project.placed = {};
    project.recipe = recipe;
    project.dual = made->dual;
    project.made = std::move(made);
    return project;
  }
  const std::array root_source{
      project.pins.root.is_valid() ? project.dual->mesh().face_source(project.pins.root) : -1};
  project.pins = carry_pins(project.pins, project.dual->mesh(), made->dual->mesh()).pins;
  const Mesh& before = project.dual->mesh();
  carry_settings(
      project.tabs, project.sheet, before, made->dual->mesh(),
      [&](EdgeId e) { return nearest_edge(before, e, made->dual->mesh()); },
      [](const glm::dvec3& d) { return d; });
  project.size = without_edge(before, project.size);
  // What became of the face is known; where it is nearest, only guessed.
  const std::vector<FaceId> heirs = faces_made_of(made->origins, root_source);
  if (!heirs.empty()) project.pins.root = heirs.front();
  project.recipe = recipe;
  project.dual = made->dual;
  project.made = std::move(made);
  project.tree = nullptr;
  project.run.reset();
  project.edits = {};
  project.placed = {};
  project.glued.clear();
  return project;
}

Project pin_root(Project project, FaceId face) {
  Constraints pins = project.pins;
  pins.root = face;
  return set_pins(std::move(project), pins);
}

Project set_pins(Project project, const Constraints& pins) {
  project.pins = pins;
  if (!pins.root.is_valid() || !project.tree || project.tree->is_root(pins.root)) return project;
  UnfoldTree tree = *project.tree;
  tree.reroot(project.dual->mesh(), pins.root);
  project.tree = std::make_shared<const UnfoldTree>(std::move(tree));
  return project;
}

Project accept_tree(Project project, UnfoldTree tree, const RunSummary& run) {
  project.tree = std::make_shared<const UnfoldTree>(std::move(tree));
  project.run = run;
  project.edits = {};
  project.placed = {};
  project.glued.clear();
  return project;
}

Project edit_by_hand(Project project, const HandEdit& edit) {
  for (const EdgeId e : edit.cut) set_pin(project.edits, e, EdgePin::MustCut);
  for (const EdgeId e : edit.joined) {
    set_pin(project.edits, e, EdgePin::MustFold);
    std::erase(project.glued, e);
  }
  UnfoldTree tree = edit.tree;
  if (project.pins.root.is_valid()) tree.reroot(project.dual->mesh(), project.pins.root);
  if (!project.placed.is_automatic())
    project.placed = carry_places(project.placed, layout(project.dual, *project.tree),
                                  layout(project.dual, tree), edit.moved);
  project.tree = std::make_shared<const UnfoldTree>(std::move(tree));
  if (!project.run) project.run.emplace();
  project.run->is_proved = false;
  return project;
}

Constraints pins_with_edits(const Project& project) {
  Constraints pins = project.pins;
  for (const EdgeId e : project.edits.must_fold) set_pin(pins, e, EdgePin::MustFold);
  for (const EdgeId e : project.edits.must_cut) set_pin(pins, e, EdgePin::MustCut);
  return pins;
}

Project set_seed(Project project, std::uint64_t seed) {
  project.seed = seed;
  return project;
}

Project set_paper(Project project, const PaperSetup& paper) {
  project.paper = paper;
  project.placed = {};
  return project;
}

Project set_size(Project project, const PrintSize& size) {
  project.placed = placed_at(project, size);
  project.size = size;
  return project;
}

Project set_tabs(Project project, const TabSettings& tabs) {
  project.tabs = tabs;
  return project;
}

Project set_sheet(Project project, const SheetSettings& sheet) {
  project.sheet = sheet;
  return project;
}

Project set_glued(Project project, std::vector<EdgeId> glued) {
  std::ranges::sort(glued);
  project.glued = std::move(glued);
  return project;
}

Project set_exports(Project project, const ExportSettings& exports) {
  project.exports = exports;
  return project;
}

Project place_pieces(Project project, const HandLayout& placed) {
  project.placed = placed;
  return project;
}

}  // namespace netwright
