// Names of files that the program numbers itself.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace taxel::studio {

/// Returns "screenshot-1.png", or the name with the first number that no file has.
inline std::string free_name(std::string_view begin, std::string_view end) {
  for (int number = 1;; ++number) {
    std::string name = fmt::format("{}{}{}", begin, number, end);
    std::error_code ignored;
    if (!std::filesystem::exists(name, ignored)) return name;
  }
}

}  // namespace taxel::studio
