// Keeps a picture and knows when it is stale.
#include "render/viewport.h"

#include <glm/common.hpp>

#include "render/gl.h"

namespace netwright {

PictureKey& PictureKey::add_bytes(const void* data, std::size_t size) {
  // FNV-1a: a few hundred bytes a frame at most.
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (std::size_t k = 0; k < size; ++k) hash_ = (hash_ ^ bytes[k]) * 1099511628211ULL;
  return *this;
}

bool Viewport::redraw(glm::ivec2 size_px, const PictureKey& key, const std::function<void()>& paint) {
  size_px = glm::max(size_px, glm::ivec2(1));
  if (is_painted_ && size_px == framebuffer_.size_px() && key.value() == key_) return false;
  GLint before = 0;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
  framebuffer_.resize(size_px);
  framebuffer_.bind();
  glViewport(0, 0, size_px.x, size_px.y);
  paint();
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before));
  key_ = key.value();
  is_painted_ = true;
  return true;
}

}  // namespace netwright
