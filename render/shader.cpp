// Compiles the embedded shader sources. They are part of the program, so an error here is a driver's or our
// own.
#include "render/shader.h"

#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>

#include "assets/assets.h"
#include "render/gl.h"

namespace netwright {
namespace {

void check(bool is_good, const std::string& what, const std::string& log) {
  if (!is_good) throw std::runtime_error("the graphics driver refuses the shader " + what + ": " + log);
}

GlObject compile(const std::string& file, GLenum kind) {
  GlObject shader(glCreateShader(kind), [](GLuint name) { glDeleteShader(name); });
  const std::string_view text = asset_text("shaders/" + file);
  const GLchar* start = text.data();
  const auto length = static_cast<GLint>(text.size());
  glShaderSource(shader.name(), 1, &start, &length);
  glCompileShader(shader.name());
  GLint is_good = 0;
  glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &is_good);
  std::string log(2048, '\0');
  GLsizei used = 0;
  glGetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), &used, log.data());
  log.resize(static_cast<std::size_t>(used));
  check(is_good != 0, file, log);
  return shader;
}

}  // namespace

Shader::Shader(const std::string& file)
    : GlObject(glCreateProgram(), [](GLuint program) { glDeleteProgram(program); }) {
  const GlObject vertex = compile(file + ".vert", GL_VERTEX_SHADER);
  const GlObject fragment = compile(file + ".frag", GL_FRAGMENT_SHADER);
  glAttachShader(name(), vertex.name());
  glAttachShader(name(), fragment.name());
  glLinkProgram(name());
  GLint is_good = 0;
  glGetProgramiv(name(), GL_LINK_STATUS, &is_good);
  std::string log(2048, '\0');
  GLsizei used = 0;
  glGetProgramInfoLog(name(), static_cast<GLsizei>(log.size()), &used, log.data());
  log.resize(static_cast<std::size_t>(used));
  check(is_good != 0, file, log);
}

void Shader::use() const { glUseProgram(name()); }
int Shader::location(const char* uniform) const { return glGetUniformLocation(name(), uniform); }
void Shader::set(const char* uniform, int value) const { glUniform1i(location(uniform), value); }
void Shader::set(const char* uniform, float value) const { glUniform1f(location(uniform), value); }
void Shader::set(const char* uniform, glm::vec2 value) const {
  glUniform2f(location(uniform), value.x, value.y);
}
void Shader::set(const char* uniform, const glm::vec3& value) const {
  glUniform3fv(location(uniform), 1, glm::value_ptr(value));
}
void Shader::set(const char* uniform, const glm::vec4& value) const {
  glUniform4fv(location(uniform), 1, glm::value_ptr(value));
}
void Shader::set(const char* uniform, const glm::mat4& value) const {
  glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Shader::set(const char* uniform, std::span<const glm::vec4> values) const {
  if (!values.empty())
    glUniform4fv(location(uniform), static_cast<GLsizei>(values.size()), glm::value_ptr(values.front()));
}

}  // namespace netwright
