// Layout files, version 1 (docs/layout_format.md).
#pragma once

#include <filesystem>
#include <string>

#include "core/layout/layout.h"

namespace taxel {

/// Parses the text of a layout. Throws Error(file, JSON pointer, message) for wrong JSON, type, word or version.
/// Values that are well formed but break a rule (radius <= 0) are layout_check's business.
Layout parse_layout(const std::string& text, const std::string& file = "");

/// parse_layout of a file; mesh.file stays as written (see mesh_path).
Layout read_layout(const std::filesystem::path& path);

/// A layout, and whether its file gives the directions of the finger. Without them `layout.frame` is the default.
struct LayoutOfFile {
  Layout layout;
  bool has_frame = true;
};
/// read_layout with the news of the frame.
LayoutOfFile read_layout_of_file(const std::filesystem::path& path);

/// Deterministic: fixed key order, shortest round-trip numbers, two-space indent, newline at the end.
std::string layout_to_json(const Layout& layout);

/// layout_to_json, written atomically.
void write_layout(const std::filesystem::path& path, const Layout& layout);

/// Where the layout's mesh lies, given where the layout file lies.
std::filesystem::path mesh_path(const Layout& layout, const std::filesystem::path& layout_file);

}  // namespace taxel
