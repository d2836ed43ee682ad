// Thin wrappers around OpenGL's names; everything is bound right before it is used, nothing relies on what
// was bound earlier, because the interface's own drawing comes in between.
#include "render/gl_objects.h"

#include <algorithm>
#include <glm/common.hpp>
#include <stdexcept>

#include "render/gl.h"

namespace netwright {
namespace {

unsigned int generate(void (*make)(GLsizei, GLuint*)) {
  unsigned int name = 0;
  make(1, &name);
  return name;
}

GLuint make_buffer() {
  return generate([](GLsizei n, GLuint* names) { glGenBuffers(n, names); });
}
GLuint make_array() {
  return generate([](GLsizei n, GLuint* names) { glGenVertexArrays(n, names); });
}
GLuint make_texture() {
  return generate([](GLsizei n, GLuint* names) { glGenTextures(n, names); });
}
GLuint make_framebuffer() {
  return generate([](GLsizei n, GLuint* names) { glGenFramebuffers(n, names); });
}
GLuint make_renderbuffer() {
  return generate([](GLsizei n, GLuint* names) { glGenRenderbuffers(n, names); });
}

/// Halved, taking means, until no side is longer.
Image within(Image image, int largest) {
  while (std::max(image.width, image.height) > largest) {
    const int nx = image.width > largest ? 2 : 1;
    const int ny = image.height > largest ? 2 : 1;
    Image half{image.width / nx, image.height / ny, {}};
    half.rgba.reserve(4 * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    for (int y = 0; y < half.height; ++y)
      for (int x = 0; x < half.width; ++x)
        for (std::size_t i = 0; i < 4; ++i) {
          int sum = 0;
          for (int k = 0; k < nx * ny; ++k) {
            const auto column = static_cast<std::size_t>(nx * x + k % nx);
            const auto row = static_cast<std::size_t>(ny * y + k / nx);
            sum += image.rgba[4 * (row * static_cast<std::size_t>(image.width) + column) + i];
          }
          half.rgba.push_back(static_cast<std::uint8_t>(sum / (nx * ny)));
        }
    image = std::move(half);
  }
  return image;
}

std::vector<std::uint8_t> upside_down(const Image& image) {
  const auto row = static_cast<std::size_t>(image.width) * 4;
  std::vector<std::uint8_t> rows(image.rgba.size());
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    const auto from = image.rgba.end() - static_cast<std::ptrdiff_t>((y + 1) * row);
    std::copy_n(from, row, rows.begin() + static_cast<std::ptrdiff_t>(y * row));
  }
  return rows;
}

}  // namespace

Buffer::Buffer() : GlObject(make_buffer(), [](GLuint name) { glDeleteBuffers(1, &name); }) {}

void Buffer::upload(std::span<const std::byte> bytes) {
  glBindBuffer(GL_ARRAY_BUFFER, name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_DYNAMIC_DRAW);
}

VertexArray::VertexArray() : GlObject(make_array(), [](GLuint name) { glDeleteVertexArrays(1, &name); }) {}

void VertexArray::attribute(unsigned int index, const Buffer& buffer, int components, AttributeType type,
                            std::size_t stride, std::size_t offset, bool is_per_instance) {
  glBindVertexArray(name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  glEnableVertexAttribArray(index);
  const auto step = static_cast<GLsizei>(stride);
  // OpenGL wants the offset dressed as a pointer.
  const auto* start = reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
  switch (type) {
    case AttributeType::Float:
      glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, step, start);
      break;
    case AttributeType::NormalizedByte:
      glVertexAttribPointer(index, components, GL_UNSIGNED_BYTE, GL_TRUE, step, start);
      break;
    case AttributeType::UnsignedInt:
      glVertexAttribIPointer(index, components, GL_UNSIGNED_INT, step, start);
      break;
  }
  glVertexAttribDivisor(index, is_per_instance ? 1 : 0);
  glBindVertexArray(0);
}

Texture::Texture() : GlObject(make_texture(), [](GLuint name) { glDeleteTextures(1, &name); }) {}

void Texture::upload(const Image& given) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const bool fits = std::max(given.width, given.height) <= largest;
  const Image halved = fits ? Image() : within(given, largest);
  const Image& image = fits ? given : halved;
  glBindTexture(GL_TEXTURE_2D, name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const std::vector<std::uint8_t> rows = upside_down(image);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               rows.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
}

void Texture::upload_grey(std::span<const std::uint8_t> values, int width) {
  glBindTexture(GL_TEXTURE_2D, name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const auto rows = static_cast<GLsizei>(values.size() / static_cast<std::size_t>(width));
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, rows, 0, GL_RED, GL_UNSIGNED_BYTE, values.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

void Texture::upload_table(std::span<const std::uint8_t> values) {
  const auto width = static_cast<std::size_t>(kTableWidth);
  const std::size_t rows = std::max<std::size_t>(1, (values.size() + width - 1) / width);
  std::vector<std::uint8_t> table(values.begin(), values.end());
  table.resize(rows * width, 0);
  glBindTexture(GL_TEXTURE_2D, name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8UI, kTableWidth, static_cast<GLsizei>(rows), 0, GL_RED_INTEGER,
               GL_UNSIGNED_BYTE, table.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

Framebuffer::Framebuffer()
    : GlObject(make_framebuffer(), [](GLuint name) { glDeleteFramebuffers(1, &name); }),
      depth_(make_renderbuffer(), [](GLuint name) { glDeleteRenderbuffers(1, &name); }) {}

void Framebuffer::resize(glm::ivec2 size_px) {
  size_px = glm::max(size_px, glm::ivec2(1));
  if (size_px == size_px_) return;
  size_px_ = size_px;
  glBindTexture(GL_TEXTURE_2D, colour_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size_px.x, size_px.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  // Shown pixel by pixel: filtering would only cost time.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size_px.x, size_px.y);
  bind();
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(), 0);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("OpenGL cannot draw into a picture of " + std::to_string(size_px.x) + " x " +
                             std::to_string(size_px.y) + " pixels; a smaller window may help");
}

void Framebuffer::bind() const { glBindFramebuffer(GL_FRAMEBUFFER, name()); }

Image Framebuffer::read_pixels() const {
  Image image{size_px_.x, size_px_.y, {}};
  image.rgba.resize(static_cast<std::size_t>(size_px_.x) * static_cast<std::size_t>(size_px_.y) * 4);
  if (image.is_empty()) return image;
  GLint before = 0;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
  bind();
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size_px_.x, size_px_.y, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before));
  image.rgba = upside_down(image);
  return image;
}

}  // namespace netwright
