// What a file contained, and nothing promised: points, polygons, texture coordinates, materials. It is the
// only place where broken input lives; `repair` and `Mesh` turn it into something that can be trusted.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace netwright {

struct Image;

/// The model's up direction, by the convention of its file format: y for OBJ and glTF, z for STL, PLY, OFF
/// and 3MF. Collada and 3DS models are turned y up when they are read.
enum class UpAxis { Y, Z };

struct Material {
  std::string name;
  glm::dvec3 colour{0.8, 0.8, 0.8};      ///< linear 0…1
  std::shared_ptr<const Image> texture;  ///< null when there is none
};

struct PolygonSoup {
  std::string name;  ///< file name without folder, for messages and titles
  UpAxis up_axis = UpAxis::Y;
  std::vector<glm::dvec3> points;
  std::vector<int> face_begin{0};  ///< face f has corners face_begin[f] … face_begin[f+1]-1
  std::vector<int> corners;        ///< index into points, one per corner
  bool is_indexed = true;          ///< false: faces came with points of their own (STL, glTF)
  bool is_joined = false;  ///< points at one place are apart on purpose (after a repair): never weld again
  std::vector<glm::dvec2> corner_uv;  ///< empty, or one per corner; (0, 0) is the picture's lower left
  std::vector<int> face_material;     ///< empty, or one per face: index into materials or -1
  std::vector<Material> materials;
  std::vector<std::string> notices;  ///< sentences worth telling the user (a texture was missing …)

  [[nodiscard]] int n_faces() const { return static_cast<int>(face_begin.size()) - 1; }
  [[nodiscard]] std::span<const int> face(int f) const {
    return std::span(corners).subspan(static_cast<std::size_t>(face_begin[static_cast<std::size_t>(f)]),
                                      static_cast<std::size_t>(face_begin[static_cast<std::size_t>(f) + 1] -
                                                               face_begin[static_cast<std::size_t>(f)]));
  }
  void add_face(std::span<const int> face_corners) {
    corners.insert(corners.end(), face_corners.begin(), face_corners.end());
    face_begin.push_back(static_cast<int>(corners.size()));
  }
};

}  // namespace netwright
