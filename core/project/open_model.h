// From a model file to a DualGraph ready to be unfolded: read, prepare, unroll, with everything the user
// should be told on the way.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/dual_graph.h"
#include "core/mesh/mesh_report.h"
#include "core/mesh/read.h"
#include "core/project/make_model.h"

namespace netwright {

/// A file on disk, or a bundled model in memory when `path` is empty.
struct ModelSource {
  std::filesystem::path path;
  std::string name;
  std::string bytes;
  CompanionLookup companions;
};

struct OpenedModel {
  std::filesystem::path path;
  std::shared_ptr<const PolygonSoup> source;
  MadeModel made;                             ///< as the file is, nothing repaired; may be unfit
  std::shared_ptr<const MadeModel> repaired;  ///< by usual_repair(), where that is unfit; else null
  std::vector<std::string> notices;           ///< whole sentences
};

/// All that repair changes without being told how far to go: what "repair all" does, and --repair.
inline Recipe usual_repair() { return {.repairs = {}, .uneven = UnevenFaces::Split}; }

/// Throws Error with one sentence when the model cannot be read, or cannot be unfolded and not be repaired
/// either.
OpenedModel open_model(const ModelSource& source, Progress& progress);

/// The sentence for whatever exception is being handled; `task` says what failed: "Opening bunny.obj".
std::string sentence_for_current_exception(const std::string& task);

}  // namespace netwright
