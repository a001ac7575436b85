// GLSL text: where it comes from, and how `#include "file"` is put together so that messages keep file and line.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace taxel::gl {

/// Returns the text of a shader by its name ("mesh.vert"). Throws Error when there is none.
using ShaderReader = std::function<std::string(const std::string& name)>;

/// Reads the shaders that are built into the program. Throws Error if there is no shader of this name.
std::string read_embedded_shader(const std::string& name);

struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  ///< line numbers of file i begin after i * kShaderFileLines
};
/// #line's own number of a source string gets lost in some of Mesa's messages; the line number never does.
inline constexpr int kShaderFileLines = 10000;

/// Puts included files in place, once each. Throws Error for a missing file.
ShaderSource assemble_shader(const ShaderReader& read, const std::string& name);

/// A message of a GLSL compiler ("0:12(5): error: ..." or "0(12) : error ...") as FILE and "line 12"; the line is empty
/// if the message has no number.
struct ShaderMessage {
  std::string file, where, text;
};
ShaderMessage parse_shader_log(const std::string& log, const ShaderSource& source);

}  // namespace taxel::gl
