// What is wrong with or noteworthy about a model, as a value that window, command line and tests print alike.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace netwright {

class Mesh;
struct PolygonSoup;

struct MeshReport {
  /// What a line is about. Windows hang their buttons on it; topic_name() is its name in JSON.
  enum class Topic {
    Counts,  ///< faces and corners
    Shape,   ///< closed or open, genus
    Parts,
    Borders,  ///< loops and their length
    Size,
    DoubledPoints,  ///< points that lie where another one is
    IsolatedPoints,
    BrokenFaces,  ///< a corner twice, or fewer than three
    ZeroAreaFaces,
    DoubledFaces,
    NonManifoldEdges,
    NonManifoldPoints,
    TurnedFaces,  ///< run against their neighbours or face inward
    OneSided,     ///< no orientation exists (Möbius strip, Klein bottle)
    UnevenFaces,
    SelfIntersections,
    MissingTextures,
    Other,  ///< whatever the reader had to say, and why there is no mesh
  };
  struct Line {
    enum class Kind { Fact, Notice, Problem };  ///< a Problem keeps the model from being unfolded
    Kind kind = Kind::Fact;
    std::string text;  ///< a whole sentence or "370 faces"
    Topic topic = Topic::Other;
    int count = 0;                            ///< of what the topic counts
    std::vector<int> faces{};                 ///< culprits: faces of the soup, worst or first ones first
    std::vector<int> points{};                ///< culprits: points of the soup
    std::vector<std::array<int, 2>> edges{};  ///< culprits: edges as two points of the soup
    // Where points and edges lie in the model, also where they have no numbers in a file.
    std::vector<glm::dvec3> point_places{};
    std::vector<std::array<glm::dvec3, 2>> edge_places{};
    [[nodiscard]] bool has_culprits() const {
      return !faces.empty() || !point_places.empty() || !edge_places.empty();
    }
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
  double border_length = 0;      ///< model units
  glm::dvec3 size{0};            ///< of the box around all faces, model units
  [[nodiscard]] bool is_fit() const { return is_manifold && n_uneven_faces == 0; }
  /// The line about a topic; null when there is nothing to say.
  [[nodiscard]] const Line* find(MeshReport::Topic topic) const;
  /// How many of the topic's culprits there are; 0 without such a line.
  [[nodiscard]] int count(MeshReport::Topic topic) const;
};

/// "non_manifold_edges"
std::string_view topic_name(MeshReport::Topic topic);

/// A share as people read it: 0.034 is "3.4 %".
std::string percent(double share);

/// A box in model units, three digits that matter: "60 × 20 × 0.5".
std::string size_text(const glm::dvec3& size);

/// What one unit of a file probably is, in mm: what its format prescribes (STL and 3MF mm, glTF m), else what
/// makes the model's longest side between 2 cm and 2 m.
struct UnitGuess {
  std::string_view name;  ///< "mm", "cm" or "m"
  double in_mm = 1;
};
UnitGuess guess_unit(const PolygonSoup& soup);

/// Everything about a soup, also a broken one, with its points joined as weld() does on opening. Takes about
/// n log n time; the search for faces that cut through each other stops at a fixed amount of work and says
/// so. Counts of a model that is no manifold (genus, borders) are those of its manifold edges.
MeshReport report_on(const PolygonSoup& soup);

/// Facts about a mesh (counts, components, genus, borders) and what is noteworthy: uneven faces, faces that
/// cut through each other. Culprits are faces of the file (face_source); borders have places only.
MeshReport report_on(const Mesh& mesh);

/// What the file had that a mesh made of it has no more (points joined or dropped, faces and edges repaired),
/// as notices with their culprits.
std::vector<MeshReport::Line> lines_about_file(const PolygonSoup& soup);

/// Adds what the reader had to say (soup.notices).
void add_reader_notices(const PolygonSoup& soup, MeshReport& report);

/// The counts that a soup without a mesh still has, and why there is no mesh.
MeshReport report_on(const PolygonSoup& soup, const std::string& problem);

}  // namespace netwright
