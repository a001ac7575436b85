#include "ui/gl/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

#include "core/base/error.h"

namespace taxel::shaders {
std::string_view embedded_file(std::string_view name);  // made by the build from shaders/
}

namespace taxel::gl {
namespace {

/// The name in a line such as `#include "common.glsl"`, or nothing.
std::string included_name(const std::string& line) {
  constexpr std::string_view key = "#include \"";
  if (line.rfind(key, 0) != 0) return {};
  const auto end = line.find('"', key.size());
  return end == std::string::npos ? std::string{} : line.substr(key.size(), end - key.size());
}

void append(const ShaderReader& read, const std::string& name, ShaderSource& out) {
  const auto before = static_cast<int>(out.files.size()) * kShaderFileLines;
  out.files.push_back(name);
  std::istringstream lines(read(name));
  std::string line;
  for (int n = 1; std::getline(lines, line); ++n) {
    const std::string included = included_name(line);
    if (included.empty()) {
      out.text += line + '\n';
      // #version must stay the first line of the whole
      if (line.rfind("#version", 0) == 0) out.text += fmt::format("#line {}\n", before + n + 1);
      continue;
    }
    if (std::find(out.files.begin(), out.files.end(), included) == out.files.end()) {
      out.text += fmt::format("#line {}\n", static_cast<int>(out.files.size()) * kShaderFileLines + 1);
      append(read, included, out);
    }
    out.text += fmt::format("#line {}\n", before + n + 1);
  }
}

/// Reads a number at `at` and moves past it; -1 when there is none.
int read_number(const std::string& text, std::size_t& at) {
  int value = -1;
  while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0 && value < 100'000'000) {
    value = std::max(value, 0) * 10 + (text[at++] - '0');
  }
  return value;
}

}  // namespace

std::string read_embedded_shader(const std::string& name) {
  const std::string_view text = shaders::embedded_file("shaders/" + name);
  if (text.empty()) throw Error(name, "no such shader in this program");
  return std::string(text);
}

ShaderSource assemble_shader(const ShaderReader& read, const std::string& name) {
  ShaderSource source;
  append(read, name, source);
  return source;
}

ShaderMessage parse_shader_log(const std::string& log, const ShaderSource& source) {
  ShaderMessage message{source.files.empty() ? "" : source.files.front(), "", log};
  std::size_t at = 0;
  if (read_number(log, at) < 0 || at >= log.size() || (log[at] != ':' && log[at] != '(')) return message;
  const int line = read_number(log, ++at);
  if (line < 0) return message;
  const auto file = static_cast<std::size_t>(line / kShaderFileLines);
  if (file < source.files.size()) message.file = source.files[file];
  message.where = fmt::format("line {}", line % kShaderFileLines);
  const auto text = log.find_first_not_of(" :)(0123456789", at);
  message.text = text == std::string::npos ? log : log.substr(text, log.find('\n', text) - text);
  return message;
}

}  // namespace taxel::gl
