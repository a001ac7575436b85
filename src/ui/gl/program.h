// A shader program: a vertex and a fragment shader, linked.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "ui/gl/handle.h"
#include "ui/gl/shader_source.h"

namespace taxel::gl {

/// The place where every program reads its uniform block Frame, if it has one.
inline constexpr GLuint kFrameBinding = 0;

class Program {
 public:
  /// Compiles and links NAME.vert and NAME.frag (or the two names given). Throws Error with file and line.
  Program(const ShaderReader& read, const std::string& vertex_name, const std::string& fragment_name);
  Program(const ShaderReader& read, const std::string& name) : Program(read, name + ".vert", name + ".frag") {}

  void use() const { glUseProgram(handle_.id()); }
  /// Uniforms that the shader does not have are ignored, as GL does.
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, const glm::vec2& value) const;
  void set(const char* name, const glm::vec3& value) const;
  void set(const char* name, const glm::vec4& value) const;
  void set(const char* name, const glm::mat4& value) const;

 private:
  [[nodiscard]] GLint location(const char* name) const { return glGetUniformLocation(handle_.id(), name); }
  ProgramHandle handle_;
};

}  // namespace taxel::gl
