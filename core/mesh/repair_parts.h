// Parts of a soup that hang together along edges. For repair's own sources and the list of a model's parts.
#pragma once

#include <vector>

#include "core/base/geometry.h"
#include "core/mesh/soup.h"

namespace netwright::repair {

struct Part {
  std::vector<int> faces;
  Box3 box;
  bool is_closed = true;
};

/// In the order of their first faces. Faces with points of their own hang together only where these are
/// joined.
std::vector<Part> find_parts(const PolygonSoup& soup);

/// Per part: it lies wholly inside a closed one. Work is bounded; what was not looked at counts as outside.
std::vector<bool> find_inner_parts(const PolygonSoup& soup, const std::vector<Part>& parts);

/// Per part: its diagonal is below the share of the model's. Never the largest part.
std::vector<bool> find_small_parts(const PolygonSoup& soup, const std::vector<Part>& parts, double min_share);

}  // namespace netwright::repair
