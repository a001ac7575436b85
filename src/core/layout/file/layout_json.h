// Layouts and taxels as JSON: reads layout files of version 1 and earlier ones, writes version 1
// (docs/layout_format.md), and copies and pastes taxels as text that a person can read and write.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// Parses the text of a layout, of version 1 or an earlier one. Does not check rules such as radius > 0: layout_check
/// does. Throws Error(file, JSON pointer, message): wrong JSON, type, word or version.
Layout parse_layout(const std::string& text, const std::string& file = "");

/// Reads a file by parse_layout(). mesh.file is unchanged (see mesh_path). Throws as parse_layout() does, or if the
/// file cannot be read.
Layout read_layout(const std::filesystem::path& path);

/// A layout, and facts on its file.
struct LayoutOfFile {
  Layout layout;
  bool has_frame = true;  ///< false if `layout.frame` is the default, because the file lacks it
  /// Sentences on the changes from an earlier version of the format; empty if the file is of the current version.
  std::vector<std::string> notes = {};
};
/// Parses a text. Throws as parse_layout() does.
LayoutOfFile parse_layout_of_file(const std::string& text, const std::string& file = "");
/// Reads a file. Throws as read_layout() does.
LayoutOfFile read_layout_of_file(const std::filesystem::path& path);

/// Returns the text of a layout: fixed key order, shortest numbers that read back unchanged, two spaces of indent,
/// newline at the end. Equal layouts give equal bytes.
std::string layout_to_json(const Layout& layout);

/// Writes layout_to_json() to a file atomically. Throws Error naming the file.
void write_layout(const std::filesystem::path& path, const Layout& layout);

/// Returns the path of the layout's mesh for the path of the layout file.
std::filesystem::path mesh_path(const Layout& layout, const std::filesystem::path& layout_file);

/// Returns taxels for the clipboard: {"format": "taxels", "version": 1, "taxels": [...]}, each as in layout files.
/// Throws Error with the JSON pointer of a number that is not finite.
std::string taxels_to_json(const std::vector<Taxel>& taxels);

/// Reads the text of taxels_to_json(). Also reads the text of a layout file, an array of taxels, or one taxel, so that
/// parts of files can be pasted. Unknown keys are ignored. Returns at least one taxel. Throws Error(source, JSON
/// pointer, message) for any other text.
std::vector<Taxel> parse_taxels(const std::string& text, const std::string& source = "clipboard");

}  // namespace taxel
