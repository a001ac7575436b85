// Loads GLSL text and inserts `#include "file"` so that compiler messages can be traced to file and line.
#pragma once

#include <functional>
#include <string>
#include <vector>

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

}  // namespace taxel::gl
