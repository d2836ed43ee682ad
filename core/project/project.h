// Only what the user made: the model they opened, the tree they accepted, their pins and paper settings. All
// that can be computed from it is in derived.h. Copying a Project is cheap: the big parts are shared.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/paper.h"
#include "core/mesh/dual_graph.h"
#include "core/project/make_model.h"
#include "core/sheet/export_settings.h"
#include "core/sheet/pages.h"
#include "core/sheet/placing.h"
#include "core/sheet/sheet_settings.h"
#include "core/solve/constraints.h"
#include "core/unfold/unfold_tree.h"

namespace netwright {

/// How the accepted tree was found, for the status bar and the printed sheet.
struct RunSummary {
  std::uint64_t seed = 0;
  std::int64_t moves = 0;
  int restarts = 0;
  double seconds = 0;
  int overlaps = 0;
  bool is_proved = false;
  bool operator==(const RunSummary&) const = default;
};

struct Project {
  std::filesystem::path path;                 ///< the model's file; empty for a bundled sample
  std::shared_ptr<const PolygonSoup> source;  ///< what the file held
  Recipe recipe;                              ///< what was done to it,
  std::shared_ptr<const MadeModel> made;      ///< and what came out
  std::shared_ptr<const DualGraph> dual;      ///< of made: model and dual graph; null in an empty project
  std::shared_ptr<const UnfoldTree> tree;     ///< the accepted tree, null before the first run
  std::optional<RunSummary> run;
  Constraints pins;   ///< of the made mesh
  Constraints edits;  ///< edges joined and cut by hand since the last run: what solving the rest keeps
  std::uint64_t seed = 0;
  PaperSetup paper;
  PrintSize size;
  TabSettings tabs;     ///< edits are of the made mesh
  SheetSettings sheet;  ///< folds named in it are of the made mesh
  ExportSettings exports;
  std::vector<EdgeId> glued;  ///< cuts of the tree that are glued already, sorted
  HandLayout placed;  ///< where the user put the pieces of the tree on this paper; empty without a tree
  bool operator==(const Project&) const =
      default;  ///< shared parts count as equal when they are the same object
};

}  // namespace netwright
