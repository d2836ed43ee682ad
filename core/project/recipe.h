// What the user had done to a model before unfolding it. The file's own faces stay in the project; the recipe
// says how a mesh is made of them, so every ingredient can be changed or left out again.
#pragma once

#include <optional>

#include "core/mesh/soup.h"

namespace netwright {

/// What happens to faces that are not flat. Paper cannot be bent in two ways at once, so they cannot stay.
enum class UnevenFaces {
  Refuse,   ///< say so and ask
  Split,    ///< into triangles: the shape stays, with more folds
  Flatten,  ///< move corners until all faces are flat (the paper's section 4.1)
};

/// Done in the order of the members.
struct Recipe {
  std::optional<UpAxis> up{};  ///< which way is up, when the format's custom is wrong
  bool repairs = false;  ///< everything that repair_all() can put right, uneven faces split unless flattened
  UnevenFaces uneven = UnevenFaces::Refuse;
  int faces = 0;        ///< simplify to at most so many; 0 = keep all
  bool merges = false;  ///< neighbours of one plane become one face
  bool operator==(const Recipe&) const = default;
};

}  // namespace netwright
