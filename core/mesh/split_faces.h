// The alternative to moving corners: faces that are not flat are split into triangles, which always are. The
// shape stays exactly as it is and gets more folds.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace netwright {

struct SplitFaces {
  PolygonSoup soup;                ///< with the mesh's points, name, up axis, uv and materials
  std::vector<FaceId> split_from;  ///< per face of the soup: the face of the mesh that it is part of
  /// What the constructor takes: Mesh(soup, is_flipped, face_source). Faces are counted anew, not as in the
  /// file, since a proof wants every face of a model exactly once.
  std::vector<bool> is_flipped;
  std::vector<int> face_source;
  int n_split = 0;  ///< faces of the mesh that were split
};

/// Splits faces that are not flat into triangles, from a tenth of kFlatness on, so that a proof accepts what
/// is kept; the others keep their corners. Parts of a face follow each other in the face's place. A
/// four-cornered face is split along the diagonal that bends less.
SplitFaces split_uneven_faces(const Mesh& mesh);

}  // namespace netwright
