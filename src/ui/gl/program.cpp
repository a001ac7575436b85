#include "ui/gl/program.h"

#include <glm/gtc/type_ptr.hpp>

#include "core/base/error.h"

namespace taxel::gl {
namespace {

/// A shader object that exists until the program is linked.
class Shader {
 public:
  Shader(GLenum stage, const ShaderReader& read, const std::string& name) : id_(glCreateShader(stage)) {
    const ShaderSource source = assemble_shader(read, name);
    const char* text = source.text.c_str();
    glShaderSource(id_, 1, &text, nullptr);
    glCompileShader(id_);
    GLint ok = GL_FALSE, length = 0;
    glGetShaderiv(id_, GL_COMPILE_STATUS, &ok);
    if (ok == GL_TRUE) return;
    glGetShaderiv(id_, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(id_, length, &length, log.data());
    log.resize(static_cast<std::size_t>(std::max(length, 0)));
    glDeleteShader(id_);
    const ShaderMessage message = parse_shader_log(log, source);
    throw Error(message.file, message.where, message.text);
  }
  ~Shader() { glDeleteShader(id_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  [[nodiscard]] GLuint id() const { return id_; }

 private:
  GLuint id_;
};

}  // namespace

Program::Program(const ShaderReader& read, const std::string& vertex_name, const std::string& fragment_name) {
  const Shader vertex(GL_VERTEX_SHADER, read, vertex_name), fragment(GL_FRAGMENT_SHADER, read, fragment_name);
  glAttachShader(handle_.id(), vertex.id());
  glAttachShader(handle_.id(), fragment.id());
  glLinkProgram(handle_.id());
  GLint ok = GL_FALSE, length = 0;
  glGetProgramiv(handle_.id(), GL_LINK_STATUS, &ok);
  if (ok != GL_TRUE) {
    glGetProgramiv(handle_.id(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetProgramInfoLog(handle_.id(), length, &length, log.data());
    log.resize(static_cast<std::size_t>(std::max(length, 0)));
    throw Error(vertex_name + " with " + fragment_name, log);
  }
  glDetachShader(handle_.id(), vertex.id());
  glDetachShader(handle_.id(), fragment.id());
  const GLuint frame = glGetUniformBlockIndex(handle_.id(), "Frame");
  if (frame != GL_INVALID_INDEX) glUniformBlockBinding(handle_.id(), frame, kFrameBinding);
}

void Program::set(const char* name, int value) const {
  glProgramUniform1i(handle_.id(), location(name), value);
}
void Program::set(const char* name, float value) const {
  glProgramUniform1f(handle_.id(), location(name), value);
}
void Program::set(const char* name, const glm::vec2& value) const {
  glProgramUniform2fv(handle_.id(), location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::vec3& value) const {
  glProgramUniform3fv(handle_.id(), location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::vec4& value) const {
  glProgramUniform4fv(handle_.id(), location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::mat4& value) const {
  glProgramUniformMatrix4fv(handle_.id(), location(name), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace taxel::gl
