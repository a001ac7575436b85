// Reads and writes project files, `*.taxelproj`, version 1 (docs/project_format.md).
#pragma once

#include <filesystem>
#include <string>

#include "core/document/project.h"

namespace taxel {

/// Parses the text of a project without changing its paths. Throws Error(file, JSON pointer, message) for wrong JSON, a
/// wrong type, word or version, an unknown key outside of the layout, and a violation of check_project.
Project parse_project(const std::string& text, const std::string& file = "");

/// Returns the text of a project file: fixed key order, shortest round-trip numbers, two-space indent, newline at the
/// end, unchanged paths. Throws Error with the JSON pointer of a number that is not finite.
std::string project_to_json(const Project& project);

/// Reads a project file and makes its paths (mesh, files of the scenario) absolute. Throws Error as parse_project()
/// does.
Project read_project(const std::filesystem::path& path);

/// Reads a layout file as a new project with absolute paths and unique ids, and a note for each changed id.
struct ProjectOfLayout {
  Project project;
  std::vector<std::string> notes;
};
ProjectOfLayout read_layout_as_project(const std::filesystem::path& path);

/// Writes a project file atomically, with paths relative to its folder. Throws Error that names the file and leaves an
/// existing file unchanged.
void write_project(const std::filesystem::path& path, const Project& project);

/// Writes the layout of the project to a layout file atomically, with the mesh's path relative to its folder.
void export_layout(const std::filesystem::path& path, const Project& project);

}  // namespace taxel
