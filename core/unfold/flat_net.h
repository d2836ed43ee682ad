// A net as it is stored and printed: plain coordinates and index lists, with the place of every net vertex on
// the model. It knows no Mesh and no tree, so a file holds it completely, and `verify` judges nothing else.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/unfold/net.h"

namespace netwright {

enum class Assignment : char { Mountain = 'M', Valley = 'V', Flat = 'F', Boundary = 'B' };

struct FlatNet {
  struct Edge {
    int from = 0;
    int to = 0;
    Assignment assignment = Assignment::Boundary;
    double fold_angle_rad = 0;  ///< FOLD's sign: positive valley, negative mountain, 0 on the boundary
  };
  std::string title;
  std::vector<glm::dvec2> points;       ///< in the plane, mm at print scale
  std::vector<glm::dvec3> folded;       ///< the same vertices on the model, model units
  std::vector<std::vector<int>> faces;  ///< in the order of the model's file
  std::vector<int> face_source;         ///< index of the model's face, one per face and each once: the file's
                                        ///< face, or the mesh's where one of the file became several
  std::vector<Edge> edges;              ///< folds once; cut edges once per side, as Boundary
};

/// Faces joined by a fold share the fold's two vertices exactly; cut edges get vertices of their own on
/// either side. `scale` is mm per model unit. All faces are listed the same way round: as the file has them
/// where the whole file runs inwards, else counter-clockwise.
FlatNet to_flat_net(const Net& net, double scale);

/// The model's total: how a FlatNet's mean edge is measured (all sides of all faces), in mm.
double mean_edge(const FlatNet& net);

}  // namespace netwright
