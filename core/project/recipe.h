// What the user had done to a model before unfolding it. The file's own faces stay in the project; the recipe
// says how a mesh is made of them, so every ingredient can be changed or left out again.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/mesh/move_corners.h"
#include "core/mesh/repair.h"
#include "core/mesh/soup.h"

namespace netwright {

/// What happens to faces that are not flat. Paper cannot be bent in two ways at once, so they cannot stay.
enum class UnevenFaces {
  Refuse,   ///< say so and ask
  Split,    ///< into triangles: the shape stays, with more folds
  Flatten,  ///< move corners until all faces are flat (the paper's section 4.1)
};

/// Done in the order of the members. Plain data that means the same when it is read back from a file years
/// later: lengths are in the file's own units, faces are those of the file, counted from 0.
struct Recipe {
  std::optional<UpAxis> up{};    ///< which way is up, when the format's custom is wrong
  Repairs repairs = kNoRepairs;  ///< which steps of repair, and how far they go
  UnevenFaces uneven = UnevenFaces::Refuse;
  /// Parts of the model (what hangs together along edges) that get no piece: one face of the file for each,
  /// the least of the part's, in order. A part of which any face is named is left out.
  std::vector<int> left_out{};
  int faces = 0;  ///< simplify to at most so many; 0 = keep all
  /// Softened: corners moved after simplifying, where they lie then. When one of them is not there any more,
  /// all stay where they are.
  std::vector<MovedCorner> moved{};
  bool merges = false;                    ///< neighbours of one plane become one face,
  std::vector<std::vector<int>> apart{};  ///< but not these groups that were split again: faces of the file
  bool operator==(const Recipe&) const = default;
};

/// Which of the groups in `apart` holds this face of the file; apart.size() when none does.
inline std::size_t group_apart(const Recipe& recipe, int file_face) {
  const auto group = std::ranges::find_if(recipe.apart, [&](const std::vector<int>& faces) {
    return std::ranges::find(faces, file_face) != faces.end();
  });
  return static_cast<std::size_t>(group - recipe.apart.begin());
}

}  // namespace netwright
