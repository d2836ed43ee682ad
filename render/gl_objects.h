// OpenGL objects that free themselves. Each remembers the version of what it holds, so that nothing is sent
// to the graphics card twice. All need the window's context to be current, also when they are destroyed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/image.h"

namespace netwright {

/// Owner of one OpenGL name, movable and not copyable.
class GlObject {
 public:
  using Deleter = void (*)(unsigned int);

  GlObject(unsigned int name, Deleter deleter) : name_(name), deleter_(deleter) {}
  GlObject(GlObject&& other) noexcept
      : name_(std::exchange(other.name_, 0)),
        deleter_(other.deleter_),
        version_(std::exchange(other.version_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(deleter_, other.deleter_);
    std::swap(version_, other.version_);
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  ~GlObject() {
    if (name_ != 0) deleter_(name_);
  }

  [[nodiscard]] unsigned int name() const { return name_; }
  /// Does it hold the content of this version? A new object holds version 0, which means "nothing".
  [[nodiscard]] bool holds(std::uint64_t version) const { return version != 0 && version_ == version; }
  void stamp(std::uint64_t version) { version_ = version; }

 private:
  unsigned int name_ = 0;
  Deleter deleter_ = nullptr;
  std::uint64_t version_ = 0;
};

/// A buffer of vertices or instances.
class Buffer : public GlObject {
 public:
  Buffer();
  /// Replaces the whole content.
  void upload(std::span<const std::byte> bytes);
};

/// How the numbers of a vertex attribute are stored.
enum class AttributeType { Float, NormalizedByte, UnsignedInt };

/// What a draw call reads, and from where.
class VertexArray : public GlObject {
 public:
  VertexArray();
  /// Attribute `index` takes `components` numbers at `offset` of every `stride` bytes; one per vertex, or one
  /// per instance. UnsignedInt reaches the shader as an integer, the others as floats.
  void attribute(unsigned int index, const Buffer& buffer, int components, AttributeType type,
                 std::size_t stride, std::size_t offset, bool is_per_instance = false);
};

/// A picture, or a table of small numbers, that shaders read.
class Texture : public GlObject {
 public:
  Texture();
  /// Smoothly filtered and repeating; the picture's first row becomes v = 1, as model files have it.
  /// A picture larger than the card takes is halved until it fits.
  void upload(const Image& given);
  /// One number 0…1 per pixel, in rows of this width, smoothly filtered.
  void upload_grey(std::span<const std::uint8_t> values, int width);
  /// One byte per entry, in rows of kTableWidth, read by the shader as unsigned integers.
  void upload_table(std::span<const std::uint8_t> values);
  static constexpr int kTableWidth = 1024;
};

/// A colour texture with a depth buffer to draw into.
class Framebuffer : public GlObject {
 public:
  Framebuffer();
  /// Gives both a size in pixels; the content is lost when it changes. Throws std::runtime_error when the
  /// driver refuses.
  void resize(glm::ivec2 size_px);
  void bind() const;
  [[nodiscard]] glm::ivec2 size_px() const { return size_px_; }
  [[nodiscard]] unsigned int texture() const { return colour_.name(); }
  /// The picture as it is now; rows from top to bottom.
  [[nodiscard]] Image read_pixels() const;

 private:
  glm::ivec2 size_px_{0, 0};
  Texture colour_;
  GlObject depth_;
};

}  // namespace netwright
