// The one door for layouts in files of any format: our own, and those of other programs, a file each in this folder.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// A layout as read, and what about it is not from the file.
struct ImportedLayout {
  Layout layout;
  std::vector<std::string> notes;  ///< "holds no mesh", a sentence each
};

struct LayoutFormat {
  std::string_view name;  ///< for menus: "Table of taxels"
  std::vector<std::string_view>
      extensions;  ///< lower case, with the dot; of several that fit a file the longest counts
  /// Throws Error that names the file and the place.
  ImportedLayout (*read)(const std::filesystem::path& path);
  /// Writes atomically; returns what the format cannot hold, a sentence each. Null where it is only read.
  std::vector<std::string> (*write)(const std::filesystem::path& path, const Layout& layout);
};

/// All formats, our own first.
const std::vector<LayoutFormat>& layout_formats();

/// The format of a file by its name, any case; null where none fits.
const LayoutFormat* layout_format_of(const std::filesystem::path& path);

/// Reads with the format of the name. Throws Error listing the extensions there are where none fits.
ImportedLayout import_layout(const std::filesystem::path& path);

}  // namespace taxel
