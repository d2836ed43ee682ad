// Where the corners of the model are drawn: on the model, or in space while a net folds up.
#pragma once

#include "core/mesh/mesh.h"

namespace netwright {

/// One point per corner of a face.
using Corners = IdVector<HalfedgeId, glm::dvec3>;

/// A view of both: cheap to copy, valid as long as what it looks at.
class ModelPose {
 public:
  explicit ModelPose(const Mesh& mesh, const Corners* corners = nullptr) : mesh_(&mesh), corners_(corners) {}

  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }
  /// Every corner is where the model has it, and both sides of a cut are in one place.
  [[nodiscard]] bool is_model() const { return corners_ == nullptr; }
  [[nodiscard]] const glm::dvec3& position(HalfedgeId h) const {
    return is_model() ? mesh_->position(h) : (*corners_)[h];
  }
  /// Mean of the face's corners.
  [[nodiscard]] glm::dvec3 centre(FaceId f) const {
    if (is_model()) return mesh_->centre(f);
    glm::dvec3 sum(0);
    for (const HalfedgeId h : mesh_->halfedges(f)) sum += position(h);
    return sum / static_cast<double>(mesh_->degree(f));
  }
  /// Unit normal, to the outside.
  [[nodiscard]] glm::dvec3 normal(FaceId f) const {
    if (is_model()) return mesh_->normal(f);
    glm::dvec3 sum(0);
    const glm::dvec3& origin = position(mesh_->first(f));
    for (const HalfedgeId h : mesh_->halfedges(f))
      sum += glm::cross(position(h) - origin, position(mesh_->next(h)) - origin);
    return glm::normalize(sum);
  }

 private:
  const Mesh* mesh_;
  const Corners* corners_;
};

}  // namespace netwright
