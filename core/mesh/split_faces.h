// The alternative to moving corners: faces that are not flat are split into triangles, which always are. The
// shape stays exactly as it is and gets more folds.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace netwright {

struct SplitFaces {
  PolygonSoup soup;              ///< with the mesh's points, name, up axis, uv and materials
  std::vector<int> face_source;  ///< per face of the soup: the file's face (Mesh::face_source) it is part of
  std::vector<bool> is_flipped;  ///< per face of the soup: does it run against the file's (Mesh::is_flipped)
  int n_split = 0;               ///< faces that were split
};

/// Splits faces that are not flat (unevenness over kFlatness) into triangles; the others keep their corners.
/// Parts of a face follow each other in the face's place. Mesh(soup, is_flipped, face_source) accepts the
/// result. A four-cornered face is split along the diagonal that bends less.
SplitFaces split_uneven_faces(const Mesh& mesh);

}  // namespace netwright
