// A picture that is kept: drawn into a texture, and drawn again only when something in it changed.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <type_traits>

#include "render/gl_objects.h"

namespace netwright {

/// A fingerprint of everything a picture depends on: add it all, compare with the last one.
class PictureKey {
 public:
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T> PictureKey& add(T value) {
    add_bytes(&value, sizeof(value));
    return *this;
  }
  PictureKey& add(glm::dvec2 v) { return add(v.x).add(v.y); }
  template <class Camera>
  requires requires(const Camera& c) { c.view_projection(); }
  PictureKey& add(const Camera& camera) {
    const auto matrix = camera.view_projection();
    add_bytes(&matrix, sizeof(matrix));
    return add(camera.size_px());
  }
  PictureKey& add_bytes(const void* data, std::size_t size);
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 14695981039346656037ULL;
};

class Viewport {
 public:
  /// Calls `paint` with the viewport's framebuffer in use (and its size set as OpenGL's viewport) when the
  /// size or the key differs from the last time; true when it did.
  bool redraw(glm::ivec2 size_px, const PictureKey& key, const std::function<void()>& paint);
  /// Makes the next redraw paint whatever the key says.
  void invalidate() { is_painted_ = false; }

  /// The picture for ImGui::Image (cast it to ImTextureID). Its rows run upwards: use uv (0,1) to (1,0).
  [[nodiscard]] std::uintptr_t texture() const { return framebuffer_.texture(); }
  [[nodiscard]] glm::ivec2 size_px() const { return framebuffer_.size_px(); }
  [[nodiscard]] Image read_pixels() const { return framebuffer_.read_pixels(); }

 private:
  Framebuffer framebuffer_;
  std::uint64_t key_ = 0;
  bool is_painted_ = false;
};

}  // namespace netwright
