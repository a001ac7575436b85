// Fonts that are installed on the system, as fontconfig lists them.
#pragma once

#include <filesystem>
#include <optional>

namespace taxel::os {

/// A font in a file, which may hold several.
struct FontFile {
  std::filesystem::path file;
  int index = 0;  ///< number of the font in the file
  bool operator==(const FontFile&) const = default;
};

/// Returns the font of the system for a language ("zh-cn", "ja", "ko") if the font has a character. The library of
/// fontconfig is loaded when it is needed. Returns nothing without the library, its configuration, or such a font.
[[nodiscard]] std::optional<FontFile> find_font(const char* language, char32_t character);

}  // namespace taxel::os
