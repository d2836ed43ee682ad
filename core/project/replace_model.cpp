// The order matters: where the new model stands is found before anything is simplified, since untouched
// corners tell best; pins and folds are matched on the meshes that are unfolded.
#include "core/project/replace_model.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/base/counted.h"
#include "core/project/carry_settings.h"
#include "core/project/replace_pins.h"
#include "core/project/replace_recipe.h"
#include "core/solve/disjoint_sets.h"

namespace netwright {

namespace {

using Kind = MeshReport::Line::Kind;

std::string factor_text(double factor) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", factor);
  return text;
}

std::int64_t as_count(std::size_t n) { return static_cast<std::int64_t>(n); }

/// Those whose place in the new mesh matters most.
std::vector<EdgeId> pinned_and_edited(const Project& project) {
  std::vector<EdgeId> edges = project.pins.must_fold;
  for (const auto* more : {&project.pins.must_cut, &project.edits.must_fold, &project.edits.must_cut,
                           &project.sheet.hidden_folds, &project.sheet.shown_folds})
    edges.insert(edges.end(), more->begin(), more->end());
  for (const TabEdit& edit : project.tabs.edits) edges.push_back(edit.edge);
  return edges;
}

/// The old net's folds that are still there: those that did not move first, and none that closes a loop.
UnfoldTree start_forest(const UnfoldTree& old, const Mesh& from, const Mesh& to, const MeshMatch& match,
                        ReplaceReport& report) {
  IdVector<EdgeId, char> is_fold(to.n_edges(), 0);
  DisjointSets sets(to.n_faces());
  for (const bool is_same : {true, false}) {
    for (const EdgeId e : from.edges()) {
      if (!old.is_fold(from, e) || (match.is_edge_same[e] != 0) != is_same) continue;
      ++report.n_folds;
      const EdgeId heir = match.edges[e];
      if (!heir.is_valid() || to.is_border(heir)) continue;
      const HalfedgeId h = to.halfedge(heir);
      if (!sets.join(to.face(h).value, to.neighbour(h).value)) continue;
      is_fold[heir] = 1;
      ++report.n_folds_kept;
    }
  }
  return tree_from_folds(to, is_fold);
}

std::string frame_text(const ModelFrame& frame) {
  std::string text;
  if (frame.turn != ModelFrame::Turn::None)
    text = frame.turn == ModelFrame::Turn::UpToZ ? "stands upright along z instead of y"
                                                 : "stands upright along y instead of z";
  if (std::abs(frame.scale - 1) > 1e-3)
    text += (text.empty() ? "" : ", ") + std::string("is ") + factor_text(frame.scale) + " times as large";
  if (text.empty()) text = "stands elsewhere";
  return "The new file " + text + "; the two were compared one on top of the other.";
}

/// What was said about the model as a whole comes before what became of single pins.
std::vector<MeshReport::Line> general_lines(const Project& old, const Project& next, const ModelFrame& frame,
                                            const ReplaceReport& report) {
  std::vector<MeshReport::Line> lines;
  const auto faces_before = as_count(old.dual->mesh().n_faces());
  const auto faces_after = as_count(next.dual->mesh().n_faces());
  lines.push_back({Kind::Fact, faces_before == faces_after
                                   ? "It stays at " + counted(faces_after, "face", "faces") + "."
                                   : counted(faces_before, "face", "faces") + " before, " +
                                         grouped(faces_after) + " after."});
  if (report.n_folds > 0)
    lines.push_back({Kind::Fact, grouped(report.n_folds_kept) + " of " +
                                     counted(report.n_folds, "fold", "folds") +
                                     " of the net are there again."});
  if (report.n_pins > 0)
    lines.push_back({Kind::Fact, counted(report.n_pins, "pin", "pins") + ": " + grouped(report.n_kept) +
                                     " kept, " + grouped(report.n_moved) + " moved, " +
                                     grouped(report.n_lost) + " lost."});
  if (frame != ModelFrame{}) lines.push_back({Kind::Notice, frame_text(frame)});
  if (!old.placed.is_automatic())
    lines.push_back({Kind::Problem, "The pieces are arranged on the pages anew."});
  const double taller = next.dual->mesh().height() / (frame.scale * old.dual->mesh().height());
  if (old.size.kind == PrintSize::Kind::Height && std::abs(taller - 1) > 1e-3)
    lines.push_back({Kind::Notice, "It is printed as tall as before, but is " + factor_text(taller) +
                                       " times as tall by its file: all else comes out " +
                                       (taller > 1 ? "smaller." : "larger.")});
  return lines;
}

std::string summary_of(const Project& old, const Project& next, const ReplaceReport& report) {
  const std::string& name = next.source->name;
  std::string text =
      name == old.source->name ? name + " was read again" : name + " takes the place of " + old.source->name;
  std::vector<std::string> parts;
  if (report.n_pins > 0) {
    const int n_there = report.n_kept + report.n_moved;
    parts.push_back(report.n_lost == 0
                        ? "all pins kept"
                        : grouped(n_there) + " of " + counted(report.n_pins, "pin", "pins") + " kept");
  }
  if (report.n_folds > 0)
    parts.push_back(grouped(report.n_folds_kept) + " of " + counted(report.n_folds, "fold", "folds") +
                    " there again");
  for (std::size_t i = 0; i < parts.size(); ++i) text += (i == 0 ? ": " : ", ") + parts[i];
  return text + ".";
}

class Replacer {
 public:
  Replacer(const Project& old, Progress& progress) : old_(old), progress_(progress) {}

  Replacement replace(std::filesystem::path path, std::shared_ptr<const PolygonSoup> source, Recipe recipe) {
    Project& next = result_.project;
    next = old_;
    next.path = std::move(path);
    next.source = std::move(source);
    next.tree = nullptr;
    next.run.reset();
    next.pins = next.edits = {};
    next.placed = {};
    next.glued.clear();
    next.size = without_edge(old_.dual->mesh(), old_.size);
    if (make(std::move(recipe))) carry();
    return std::move(result_);
  }

 private:
  bool make(Recipe recipe) {
    Project& next = result_.project;
    recipe.left_out.clear();
    recipe.apart.clear();
    // As far as that goes without what speaks of single faces; simplifying comes when that is known.
    Recipe base = recipe;
    base.faces = 0;
    base.merges = false;
    MadeModel made = make_model(next.source, base, nullptr, progress_);
    if (made.dual && !progress_.is_cancelled()) {
      frame_ = find_frame(*old_.made->stages->mesh, *made.stages->mesh);
      CarriedRecipe carried = carry_recipe(old_, recipe, made, frame_);
      recipe = std::move(carried.recipe);
      about_recipe_ = std::move(carried.lines);
      made = make_model(next.source, recipe, made.stages, progress_);
    }
    result_.refusal = made.refusal;
    next.recipe = recipe;
    next.dual = made.dual;
    if (made.dual && !progress_.is_cancelled()) add_survey(made, progress_);
    next.made = std::make_shared<const MadeModel>(std::move(made));
    return next.dual != nullptr && !progress_.is_cancelled();
  }

  void carry() {
    Project& next = result_.project;
    ReplaceReport& report = result_.report;
    progress_.set_phase("Comparing " + next.source->name);
    const Mesh& from = old_.dual->mesh();
    const Mesh& to = next.dual->mesh();
    const MeshMatch match = match_meshes(from, to, frame_, pinned_and_edited(old_));
    replace_pins(old_, match, frame_, next, report);
    carry_settings(
        next.tabs, next.sheet, from, to, [&](EdgeId e) { return match.edges[e]; },
        [&](const glm::dvec3& d) { return frame_.direction(d); });
    if (old_.tree)
      result_.start = std::make_shared<const UnfoldTree>(start_forest(*old_.tree, from, to, match, report));
    std::vector<MeshReport::Line> lines = general_lines(old_, next, frame_, report);
    lines.insert(lines.end(), about_recipe_.begin(), about_recipe_.end());
    lines.insert(lines.end(), report.lines.begin(), report.lines.end());
    report.lines = std::move(lines);
    report.summary = summary_of(old_, next, report);
  }

  const Project& old_;
  Progress& progress_;
  Replacement result_;
  ModelFrame frame_;
  std::vector<MeshReport::Line> about_recipe_;
};

}  // namespace

Replacement replace_model(const Project& old, std::filesystem::path path,
                          std::shared_ptr<const PolygonSoup> source, const std::optional<Recipe>& repairs,
                          Progress& progress) {
  Recipe recipe = old.recipe;
  if (repairs) {
    recipe.repairs = repairs->repairs;
    recipe.uneven = repairs->uneven;
  }
  return Replacer(old, progress).replace(std::move(path), std::move(source), recipe);
}

}  // namespace netwright
