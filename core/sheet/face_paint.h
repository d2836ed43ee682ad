// What colour each face has at each of its points: the model's textures, made smaller where they are printed
// smaller, or the colours of its materials. Used by the pictures on the sheets.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/image.h"
#include "core/mesh/mesh.h"

namespace netwright {

using Pixel = std::array<std::uint8_t, 4>;  ///< RGBA, sRGB

/// The looks of a model. Textures are shared with the mesh and must outlive this.
class FacePaint {
 public:
  explicit FacePaint(const Mesh& mesh);

  /// True when there is nothing to print: no texture, and one material at most, which is grey or white.
  [[nodiscard]] bool is_plain() const { return is_plain_; }

  /// A texture in the size that suits what is printed, or one colour where `texture` is null.
  struct Coat {
    const Image* texture = nullptr;
    Pixel colour{255, 255, 255, 255};
  };
  /// `texels_per_pixel`: how densely the full texture would be printed there.
  [[nodiscard]] Coat coat(FaceId f, double texels_per_pixel) const;
  /// Size of the face's full texture in pixels; 0 x 0 where it has none.
  [[nodiscard]] ImageSize texture_size(FaceId f) const;

 private:
  /// The texture, then each time half as large.
  struct Levels {
    const Image* full = nullptr;
    std::vector<Image> smaller;
  };
  const Mesh& mesh_;
  std::vector<Levels> textures_;  ///< per material; `full` is null where there is none
  std::vector<Pixel> colours_;    ///< per material
  bool is_plain_ = true;
};

/// The texture at a place (0, 0 = lower left, repeated beyond 0…1), blended between its pixels, on white.
/// Any numbers will do.
Pixel texture_at(const Image& texture, glm::dvec2 uv);

}  // namespace netwright
