// Why no single piece was found, as lines for people or as JSON.
#pragma once

#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/solve/trouble.h"

namespace netwright {

struct WhyNot {
  Trouble trouble;
  Releases releases;  ///< empty where nothing was pinned
  bool has_pins = false;
};

/// Looks into a search that found no net; where there are pins, tries what happens without them.
[[nodiscard]] WhyNot look_into(const SolveResult& result, const SolveOptions& options, Progress& progress);

/// "Most often in collision: faces 12, 7 and 9 (64 % of all)." and so on; faces by the file's numbers.
[[nodiscard]] std::vector<std::string> why_lines(const WhyNot& why, const Mesh& mesh);
/// hot_faces (face, heat), excess_points (x, y, z, degrees, share) and, where there are pins, releases: a
/// list of ways, each a list of pins.
[[nodiscard]] Json why_json(const WhyNot& why, const Mesh& mesh);

}  // namespace netwright
