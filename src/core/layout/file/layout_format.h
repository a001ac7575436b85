// The file formats of layouts: the project's own and those of other programs, one file each in this folder.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/layout/file/imported_layout.h"

namespace taxel {

/// A file format of layouts, one row of layout_formats().
struct LayoutFormat {
  std::string_view name;  ///< name in menus, such as "Table of taxels"
  /// File name extensions in lower case, with their dots. The longest one that fits a file decides.
  std::vector<std::string_view> extensions;
  /// Reads a file. `sensor` is the name of one of several sensors in the file, or of its geom, or empty for the first
  /// sensor. Throws Error naming the file and the place.
  ImportedLayout (*read)(const std::filesystem::path& path, const std::string& sensor);
  /// Writes a file atomically. Returns one sentence for each value that the format cannot hold. Throws Error naming the
  /// file. Null if the format is only read.
  std::vector<std::string> (*write)(const std::filesystem::path& path, const Layout& layout);
};

/// Returns all formats, the project's own first.
const std::vector<LayoutFormat>& layout_formats();

/// Returns the format of a file by its name, in any case; null if no extension fits.
const LayoutFormat* layout_format_of(const std::filesystem::path& path);

/// Returns true if the name belongs to a layout of another program.
bool is_foreign_layout(const std::filesystem::path& path);

/// Reads a file in the format of its name. Throws Error: no extension fits, or the file cannot be read.
ImportedLayout import_layout(const std::filesystem::path& path, const std::string& sensor = "");

}  // namespace taxel
