// What is to be seen of each face apart from its shape: hovered, root, overlapping and so on, one byte a
// face. Renderers compare it with what they drew last and send it on only when it differs.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/ids.h"

namespace netwright {

enum class FaceState : std::uint8_t {
  Hovered = 1,
  Root = 2,
  Overlapping = 4,  ///< red with a hatch
  Selected = 8,     ///< green outline
  Chosen = 16,      ///< the face a move starts from
  Climbed = 32,     ///< on the path the move climbed
  Warm = 64,        ///< how often in collision: seldom,
  Hot = 128,        ///< often, and with Warm most often
};

class FaceStates {
 public:
  FaceStates() = default;
  explicit FaceStates(std::size_t n_faces) : bits_(n_faces, 0) {}

  /// An invalid face is ignored.
  void add(FaceId face, FaceState state) {
    if (face.is_valid() && face.index() < bits_.size())
      bits_[face.index()] |= static_cast<std::uint8_t>(state);
  }
  [[nodiscard]] bool has(FaceId face, FaceState state) const {
    return (bits_[face.index()] & static_cast<std::uint8_t>(state)) != 0;
  }
  [[nodiscard]] const std::vector<std::uint8_t>& bits() const { return bits_; }
  [[nodiscard]] std::size_t size() const { return bits_.size(); }
  bool operator==(const FaceStates&) const = default;

 private:
  std::vector<std::uint8_t> bits_;
};

}  // namespace netwright
