// What is wrong with or noteworthy about a model, as a value that window, command line and tests print alike.
#pragma once

#include <string>
#include <vector>

namespace netwright {

class Mesh;
struct PolygonSoup;

struct MeshReport {
  struct Line {
    enum class Kind { Fact, Notice, Problem };  ///< a Problem keeps the model from being unfolded
    Kind kind = Kind::Fact;
    std::string text;  ///< a whole sentence or "370 faces"
  };
  std::vector<Line> lines;
  int n_faces = 0;
  int n_vertices = 0;
  int n_components = 0;
  int genus = 0;
  int n_border_edges = 0;
  int n_border_loops = 0;
  bool is_closed = false;
  bool is_manifold = false;      ///< orientable manifold: a Mesh can be made of it
  int n_uneven_faces = 0;        ///< not flat (kFlatness)
  double worst_unevenness = 0;   ///< share of the face's size
  int n_self_intersections = 0;  ///< pairs of faces that cut through each other in space
  [[nodiscard]] bool is_fit() const { return is_manifold && n_uneven_faces == 0; }
};

/// A share as people read it: 0.034 is "3.4 %".
std::string percent(double share);

/// Facts about a mesh (counts, components, genus, borders) and what is noteworthy: uneven faces, faces that
/// cut through each other.
MeshReport report_on(const Mesh& mesh);

/// The counts that a soup without a mesh still has, and why there is no mesh.
MeshReport report_on(const PolygonSoup& soup, const std::string& problem);

}  // namespace netwright
