// Draws the model: soft two-light shading, one tone per face, thin edges, and each face's state.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/mesh/dual_graph.h"
#include "core/unfold/fold.h"
#include "render/camera.h"
#include "render/face_states.h"
#include "render/line_renderer.h"
#include "render/model_pose.h"

namespace netwright {

struct MeshLook {
  bool shows_edges = true;
  bool shows_folds = true;       ///< of the edges that have a kind; cuts and borders show with shows_edges
  bool shows_materials = true;   ///< the model's own colours and textures, when it has any
  bool is_seen_through = false;  ///< faces like thin glass, hidden edges faintly
  float scale = 1;               ///< pixels per design pixel
};

class MeshRenderer {
 public:
  explicit MeshRenderer(const LineRenderer& lines);
  /// Takes the model over to the graphics card; does nothing when it is there already. Null empties it.
  void set_model(std::shared_ptr<const DualGraph> dual);
  /// Draws its faces where they are now, null for the model itself, and its edges by their kinds, null for
  /// all alike; does nothing when both versions are what it holds already.
  void set_pose(const Corners* corners, std::uint64_t pose_version, const IdVector<EdgeId, EdgeKind>* kinds,
                std::uint64_t kinds_version);
  /// Draws into the framebuffer in use, with depth. `states`: one per face, or none.
  void draw(const OrbitCamera& camera, const Palette& palette, const FaceStates& states,
            const MeshLook& look);

 private:
  struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 uv;
    std::array<std::uint8_t, 4> material;
    std::uint32_t face;
  };
  struct Group {  ///< triangles that share a texture
    int material = -1;
    int first = 0;
    int count = 0;
  };
  void collect_triangles();
  void upload_triangles(const ModelPose& pose);
  void upload_edges(const ModelPose& pose, const IdVector<EdgeId, EdgeKind>* kinds);
  void upload_outlines();
  void upload_textures();
  void upload_states(const FaceStates& states);
  void draw_faces(const OrbitCamera& camera, const Palette& palette, const MeshLook& look) const;
  void draw_groups() const;
  void draw_lines(const OrbitCamera& camera, const Palette& palette, const MeshLook& look) const;

  const LineRenderer& lines_;
  Shader shader_;
  Buffer buffer_;
  VertexArray array_;
  Texture state_table_;
  std::vector<Texture> textures_;  ///< one per material, empty ones for materials without a picture
  std::vector<Group> groups_;
  std::vector<Vertex> vertices_;
  std::vector<HalfedgeId> corner_of_;  ///< one per vertex
  std::vector<glm::vec3> corners_;     ///< where the corners are now, one per halfedge
  std::vector<glm::vec3> normals_;     ///< of the faces there
  std::vector<LineSegment> segments_;  ///< uploaded last, kept for their room
  std::uint64_t pose_version_ = 0;
  std::uint64_t kinds_version_ = 0;
  LineBatch edges_;
  LineBatch outlines_;  ///< of selected faces
  std::shared_ptr<const DualGraph> dual_;
  FaceStates states_;
};

}  // namespace netwright
