// The recipe, step by step: repair, uneven faces, parts, simplify, merge. Merging comes last because
// simplifying cuts polygons up again.
#include "core/project/make_model.h"

#include "core/base/counted.h"
#include "core/mesh/deviation.h"
#include "core/mesh/difficulty.h"
#include "core/mesh/merge_faces.h"
#include "core/mesh/move_corners.h"
#include "core/mesh/planarize.h"
#include "core/mesh/repair.h"
#include "core/mesh/split_faces.h"

namespace netwright {

namespace {

std::vector<bool> flips_of(const Mesh& mesh) {
  std::vector<bool> flips;
  for (const FaceId f : mesh.faces()) flips.push_back(mesh.is_flipped(f));
  return flips;
}

template <class Faces>
std::vector<int> sources_of(const Mesh& mesh, const Faces& faces) {
  std::vector<int> sources;
  for (const FaceId f : faces) sources.push_back(mesh.face_source(f));
  return sources;
}

bool is_apart(const Recipe& recipe, int file_face) {
  return group_apart(recipe, file_face) < recipe.apart.size();
}

class Maker {
 public:
  Maker(std::shared_ptr<const PolygonSoup> source, const Recipe& recipe, Progress& progress)
      : source_(std::move(source)), recipe_(recipe), progress_(progress) {}

  MadeModel make(const std::shared_ptr<const ModelStages>& before) {
    if (before && before->whole && before->source == source_ && has_same_base(before->recipe)) {
      stages_ = *before;
    } else {
      prepare_base();
    }
    if (stages_.whole && (!stages_.mesh || stages_.recipe.left_out != recipe_.left_out)) leave_out();
    stages_.recipe = recipe_;
    model_.done = stages_.done;
    if (stages_.mesh && model_.refusal.empty()) finish();
    model_.was_cancelled = progress_.is_cancelled();
    model_.stages = std::make_shared<const ModelStages>(std::move(stages_));
    return std::move(model_);
  }

 private:
  [[nodiscard]] bool has_same_base(const Recipe& other) const {
    return other.up == recipe_.up && other.repairs == recipe_.repairs && other.uneven == recipe_.uneven;
  }

  void prepare_base() {
    stages_.source = source_;
    if (recipe_.up && *recipe_.up != source_->up_axis) {
      auto turned = std::make_shared<PolygonSoup>(*source_);
      turned->up_axis = *recipe_.up;
      source_ = std::move(turned);
    }
    PreparedModel prepared;
    if (recipe_.repairs != kNoRepairs) {
      progress_.set_phase("Repairing " + source_->name);
      RepairResult repaired =
          repair_all(*source_, recipe_.repairs, progress_, recipe_.uneven == UnevenFaces::Split);
      stages_.repaired = std::move(repaired.done);
      prepared = std::move(repaired.prepared);
      if (!prepared.is_fit()) prepared.refusal = repaired.verdict;
    } else {
      progress_.set_phase("Checking " + source_->name);
      prepared = prepare(*source_);
    }
    if (prepared.mesh) stages_.file_lines = lines_about_file(*source_);
    model_.report = prepared.report;
    model_.refusal = prepared.refusal;
    stages_.whole = prepared.mesh;
    if (prepared.mesh && prepared.report.n_uneven_faces > 0) treat_uneven(prepared.refusal);
    if (!model_.refusal.empty()) stages_.whole = nullptr;
  }

  void leave_out() {
    stages_.simplifier = nullptr;
    stages_.mesh = stages_.whole;
    stages_.done = stages_.repaired;
    if (recipe_.left_out.empty()) return;
    stages_.mesh = without_parts(*stages_.whole, recipe_.left_out);
    if (!stages_.mesh) {
      model_.refusal = source_->name + ": all its parts are left out; keep at least one.";
      return;
    }
    const auto n_all = static_cast<std::int64_t>(stages_.whole->n_components());
    const auto n_kept = static_cast<std::int64_t>(stages_.mesh->n_components());
    if (n_kept < n_all)
      stages_.done.push_back("Left out " + grouped(n_all - n_kept) + " of " + grouped(n_all) + " parts.");
  }

  void treat_uneven(const std::string& refusal) {
    const Mesh& mesh = *stages_.whole;
    if (recipe_.uneven == UnevenFaces::Split) {
      const SplitFaces split = split_uneven_faces(mesh);
      stages_.whole =
          std::make_shared<const Mesh>(split.soup, split.is_flipped, sources_of(mesh, split.split_from));
      stages_.repaired.push_back("Split " + counted(split.n_split, "uneven face", "uneven faces") +
                                 " into triangles.");
      model_.refusal.clear();
    } else if (recipe_.uneven == UnevenFaces::Flatten) {
      progress_.set_phase("Flattening the faces of " + source_->name);
      const PlanarizeResult flat = planarize(mesh, {}, progress_);
      if (flat.has_converged) {
        stages_.whole =
            std::make_shared<const Mesh>(flat.soup, flips_of(mesh), sources_of(mesh, mesh.faces()));
        stages_.repaired.push_back(flat.sentence);
        model_.refusal.clear();
      } else {
        model_.refusal = flat.sentence;
      }
    } else {
      model_.refusal = refusal;
    }
  }

  void finish() {
    std::shared_ptr<const Mesh> mesh = stages_.mesh;
    model_.origins = origins_of(*mesh);
    if (recipe_.faces > 0) mesh = simplified();
    if (!recipe_.moved.empty() && !progress_.is_cancelled()) mesh = softened(std::move(mesh));
    std::vector<EdgeId> hidden;
    if (recipe_.merges && !progress_.is_cancelled()) {
      progress_.set_phase("Merging faces of one plane");
      mesh = merged(*mesh);
      hidden = hidden_folds(*mesh, recipe_);
    }
    model_.difficulty = predicted_difficulty(*mesh);
    model_.report = report_on(*mesh);
    add_reader_notices(*source_, model_.report);
    model_.dual = std::make_shared<const DualGraph>(std::move(mesh), hidden);
  }

  std::shared_ptr<const Mesh> softened(std::shared_ptr<const Mesh> mesh) {
    const MovedMesh moved = move_corners(*mesh, recipe_.moved);
    if (!moved.mesh) {
      model_.done.push_back("Not softened: the corners to be moved are not there any more.");
      return mesh;
    }
    model_.n_moved = static_cast<int>(recipe_.moved.size());
    model_.origins = passed_on(model_.origins, moved.heirs);
    model_.deviation.reset();
    model_.done.push_back("Softened: moved " + counted(model_.n_moved, "corner", "corners") + ".");
    return moved.mesh;
  }

  std::shared_ptr<const Mesh> merged(const Mesh& mesh) {
    MergeOptions options;
    for (const FaceId f : mesh.faces())
      if (is_apart(recipe_, mesh.face_source(f))) options.left_alone.push_back(f);
    MergedFaces result = merge_coplanar_faces(mesh, options);
    std::vector<int> heirs(mesh.n_faces(), -1);
    for (std::size_t f = 0; f < result.sources.size(); ++f)
      for (const FaceId source : result.sources[f]) heirs[source.index()] = static_cast<int>(f);
    for (const std::vector<FaceId>& faces : result.sources) {
      model_.groups.push_back(faces.size() > 1 ? sources_of(mesh, faces) : std::vector<int>());
      std::erase_if(model_.groups.raw().back(), [](int file_face) { return file_face < 0; });  // filled holes
    }
    model_.origins = passed_on(model_.origins, heirs);
    for (std::string& sentence : result.sentences) model_.done.push_back(std::move(sentence));
    return std::make_shared<const Mesh>(result.soup, result.is_flipped, result.face_source);
  }

  std::shared_ptr<const Mesh> simplified() {
    if (!stages_.simplifier) {
      progress_.set_phase("Simplifying " + source_->name);
      stages_.simplifier = std::make_shared<const Simplifier>(stages_.mesh, SimplifyOptions{}, progress_);
      if (progress_.is_cancelled()) stages_.simplifier = nullptr;  // only a part of its history
      if (!stages_.simplifier) return stages_.mesh;
    }
    const Simplifier& simplifier = *stages_.simplifier;
    model_.n_faces_least = simplifier.n_faces_min();
    const int n_before = static_cast<int>(stages_.mesh->n_faces());
    if (recipe_.faces >= n_before) return stages_.mesh;
    std::vector<int> sources = simplifier.sources_at(recipe_.faces);
    for (int& source : sources) source = stages_.mesh->face_source(FaceId(source));
    auto mesh = std::make_shared<const Mesh>(simplifier.soup_at(recipe_.faces), std::vector<bool>(), sources);
    model_.origins = passed_on(model_.origins, simplifier.heirs_at(recipe_.faces));
    model_.deviation.reset();
    model_.done.push_back("Simplified from " + grouped(n_before) + " to " +
                          counted(static_cast<std::int64_t>(mesh->n_faces()), "face", "faces") + ".");
    return mesh;
  }

  std::shared_ptr<const PolygonSoup> source_;
  Recipe recipe_;
  Progress& progress_;
  ModelStages stages_;
  MadeModel model_;
};

}  // namespace

std::vector<EdgeId> hidden_folds(const Mesh& mesh, const Recipe& recipe) {
  std::vector<EdgeId> folds = unmerged_flat_edges(mesh);
  std::erase_if(folds, [&](EdgeId e) {
    const HalfedgeId h = mesh.halfedge(e);
    return is_apart(recipe, mesh.face_source(mesh.face(h))) ||
           is_apart(recipe, mesh.face_source(mesh.neighbour(h)));
  });
  return folds;
}

double measure_deviation(const MadeModel& made, const Progress& progress) {
  const ModelStages& stages = *made.stages;
  const Mesh& mesh = made.dual->mesh();
  if (stages.simplifier) return stages.simplifier->deviation_of(mesh, progress);
  return hausdorff_distance(SurfaceTree(*stages.mesh), SurfaceTree(mesh), progress);
}

MadeModel make_model(const std::shared_ptr<const PolygonSoup>& source, const Recipe& recipe,
                     const std::shared_ptr<const ModelStages>& before, Progress& progress) {
  return Maker(source, recipe, progress).make(before);
}

namespace {

/// A project's file leaves out the parts that its user did.
void remake_whole(ModelStages& stages, Progress& progress) {
  Recipe recipe{.up = stages.recipe.up, .repairs = stages.recipe.repairs, .uneven = stages.recipe.uneven};
  const MadeModel all = make_model(stages.source, recipe, nullptr, progress);
  stages.whole = all.stages->whole;
  stages.repaired = all.stages->repaired;
}

}  // namespace

void add_survey(MadeModel& model, Progress& progress) {
  if (model.stages->survey || progress.is_cancelled()) return;
  ModelStages stages = *model.stages;
  auto survey = std::make_shared<ModelSurvey>();
  survey->repairs = survey_repairs(*stages.source, stages.recipe.repairs, progress);
  for (RepairCount& count : survey->repairs.counts) {
    if (count.step == RepairStep::UnevenFaces && stages.recipe.uneven != UnevenFaces::Refuse) count.left = 0;
  }
  if (!stages.whole && stages.mesh) remake_whole(stages, progress);
  if (stages.whole) survey->parts = parts_of(*stages.whole);
  stages.survey = std::move(survey);
  model.stages = std::make_shared<const ModelStages>(std::move(stages));
}

}  // namespace netwright
