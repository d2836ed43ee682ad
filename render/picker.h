// Which face is under the pointer. Works on the CPU alone: a box tree over the model, a grid over the net;
// both answer in well under a millisecond and are rebuilt only when what they hold changes.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/mesh/dual_graph.h"
#include "core/unfold/net.h"
#include "render/camera.h"
#include "render/model_pose.h"

namespace netwright {

class ModelPicker {
 public:
  /// Does nothing when it holds this model already. Null empties it.
  void set_model(std::shared_ptr<const DualGraph> dual);
  /// Picks among its faces where they are now, null for the model itself; does nothing when `version` is what
  /// it holds already.
  void set_pose(const Corners* corners, std::uint64_t version);
  /// The first face a ray meets, from either side; invalid when none.
  [[nodiscard]] FaceId pick(const Ray& ray) const;

 private:
  struct Triangle {
    glm::dvec3 a, b, c;
    FaceId face;
  };
  struct Node {  ///< inner: children at first and first+1 (count 0); leaf: triangles first … first+count-1
    Box3 box;
    int first = 0;
    int count = 0;
  };
  void collect(const ModelPose& pose);
  void build();

  std::shared_ptr<const DualGraph> dual_;
  std::uint64_t pose_version_ = 0;
  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

class NetPicker {
 public:
  /// Takes a net over; does nothing when `version` (not 0) is what it holds already.
  void set_net(const Net& net, std::uint64_t version);
  void clear();
  /// The topmost face at a point of the plane, which is the one painted last; invalid when none.
  [[nodiscard]] FaceId pick(glm::dvec2 point) const;

 private:
  struct Part {  ///< a convex part of a face: corners first … first+count-1
    int first = 0;
    int count = 0;
    FaceId face;
  };
  void collect_parts(const Net& net);
  void fill_grid();
  [[nodiscard]] Box2 part_box(const Part& part) const;
  [[nodiscard]] bool contains(const Part& part, glm::dvec2 point) const;
  [[nodiscard]] int column(double x) const;
  [[nodiscard]] int row(double y) const;

  std::uint64_t version_ = 0;
  Box2 box_;
  int columns_ = 0;
  int rows_ = 0;
  double cell_ = 1;
  std::vector<glm::dvec2> corners_;
  std::vector<Part> parts_;
  std::vector<int> cell_begin_;  ///< parts of cell i: cell_parts_[cell_begin_[i]] … [cell_begin_[i+1]]-1
  std::vector<int> cell_parts_;
};

}  // namespace netwright
