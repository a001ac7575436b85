// Project files, `*.taxelproj`, version 1 (docs/project_format.md): the layout and what only the window needs.
#pragma once

#include <filesystem>
#include <string>

#include "core/document/project.h"

namespace taxel {

/// Parses the text of a project; paths stay as written. Throws Error(file, JSON pointer, message) for wrong JSON, type,
/// word, version, an unknown key outside of the layout, and what check_project refuses.
Project parse_project(const std::string& text, const std::string& file = "");

/// Deterministic: fixed key order, shortest round-trip numbers, two-space indent, newline at the end; paths as they
/// are. Throws Error with the JSON pointer of a number that is not finite.
std::string project_to_json(const Project& project);

/// parse_project of a file, with the paths in it (mesh, object of the scenario) made absolute.
Project read_project(const std::filesystem::path& path);

/// A layout file as a new project: paths made absolute, ids made unique, with a note for each taxel where that took a
/// change.
struct ProjectOfLayout {
  Project project;
  std::vector<std::string> notes;
};
ProjectOfLayout read_layout_as_project(const std::filesystem::path& path);

/// project_to_json with paths relative to the file's folder, written atomically. Throws Error naming the file; then the
/// old one is untouched.
void write_project(const std::filesystem::path& path, const Project& project);

/// The project's layout alone, with the mesh's path relative to the file's folder, written atomically.
void export_layout(const std::filesystem::path& path, const Project& project);

}  // namespace taxel
