// Shader programs: a pair NAME.vert and NAME.frag of the folder shaders/, which is embedded in the program.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>

#include "render/gl_objects.h"

namespace netwright {

class Shader : public GlObject {
 public:
  /// Compiles and links NAME.vert and NAME.frag. Throws std::runtime_error with the driver's own words.
  explicit Shader(const std::string& name);

  void use() const;
  // The program must be in use. A name the compiler optimized away is ignored.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, glm::vec2 value) const;
  void set(const char* uniform, const glm::vec3& value) const;
  void set(const char* uniform, const glm::vec4& value) const;
  void set(const char* uniform, const glm::mat4& value) const;
  void set(const char* uniform, std::span<const glm::vec4> values) const;

 private:
  [[nodiscard]] int location(const char* uniform) const;
};

}  // namespace netwright
