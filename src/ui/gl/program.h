// Shader programs: their GLSL with `#include "file"`, whose compiler messages are traced to file and line; a linked
// vertex and fragment shader; and the fixed-function state of one draw.
#pragma once

#include <epoxy/gl.h>
#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <vector>

#include "ui/gl/objects.h"

namespace taxel::gl {

/// Returns the text of a shader by its name ("mesh.vert"). Throws Error if there is no such shader.
using ShaderReader = std::function<std::string(const std::string& name)>;

/// Reads the shaders that are built into the program. Throws Error if there is no shader of this name.
std::string read_embedded_shader(const std::string& name);

struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  ///< line numbers of file i begin after i * kShaderFileLines
};
/// Range of line numbers for each file. The file is encoded in the line number, because some of Mesa's messages lose
/// the source-string number of #line.
inline constexpr int kShaderFileLines = 10000;

/// Inserts included files, each once. Throws Error if a file is missing.
ShaderSource assemble_shader(const ShaderReader& read, const std::string& name);

/// A message of a GLSL compiler ("0:12(5): error: ..." or "0(12) : error ..."), with its file and "line 12". The line
/// is empty if the message has no number.
struct ShaderMessage {
  std::string file, where, text;
};
ShaderMessage parse_shader_log(const std::string& log, const ShaderSource& source);

/// The place where every program reads its uniform block Frame, if it has one.
inline constexpr GLuint kFrameBinding = 0;

/// A vertex and a fragment shader, linked.
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

/// The fixed-function state of one draw. It is always set as a whole, so no draw depends on the previous one.
struct DrawState {
  GLenum depth = GL_LEQUAL;  ///< depth test; GL_ALWAYS for no test
  bool depth_write = true;
  bool blend = false;     ///< blends premultiplied colours over the framebuffer
  GLenum cull = GL_NONE;  ///< culled side: GL_BACK or GL_FRONT, or GL_NONE
};

inline void enable(GLenum what, bool on) {
  if (on) {
    glEnable(what);
  } else {
    glDisable(what);
  }
}

inline void apply(const DrawState& state) {
  enable(GL_DEPTH_TEST, state.depth != GL_ALWAYS || state.depth_write);
  glDepthFunc(state.depth);
  glDepthMask(state.depth_write ? GL_TRUE : GL_FALSE);
  enable(GL_BLEND, state.blend);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  enable(GL_CULL_FACE, state.cull != GL_NONE);
  if (state.cull != GL_NONE) glCullFace(state.cull);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace taxel::gl
