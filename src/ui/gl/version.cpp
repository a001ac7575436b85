#include "ui/gl/version.h"

#include <fmt/format.h>

#include <string_view>

namespace taxel::gl {

std::string offered_text(const char* version, const char* renderer) {
  if (version == nullptr || *version == '\0') return "this machine offers no OpenGL at all";
  const std::string_view text(version);
  const std::string_view number = text.substr(0, text.find(' '));
  return fmt::format("this machine offers {} from {}", number, renderer != nullptr ? renderer : "an unknown renderer");
}

}  // namespace taxel::gl
