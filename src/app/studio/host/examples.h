// Examples that travel inside the program: the fingertip's sweep, the paper's jumping taxel, a hand, and known sensors.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/studio/host/document/documents.h"

namespace taxel::studio {

struct Example {
  std::string label;  ///< entry of the menu
  /// Name under which Session::open() opens it, or scene_of_example() for a scene; empty for the fingertip's sweep.
  std::string name;
  std::string tip;      ///< its content, for people who see it for the first time
  std::string picture;  ///< embedded PNG for the start card, or empty for none there
};

/// Returns all examples in the order of the menu, those with pictures first.
const std::vector<Example>& examples();

/// Returns whether this is the name of a document that is built into the program. Scenes are not: see below.
bool is_built_in(std::string_view name);
/// Loads a built-in document. Throws Error if there is none with this name, or Cancelled.
LoadedDocument load_built_in(std::string_view name, const SensorBuild& how);

/// Returns whether this is the name of a scene, whose files are written by write_examples() before it is opened.
bool is_scene_example(std::string_view name);
/// Returns the scene's path in the folder of write_examples().
std::filesystem::path scene_of_example(std::string_view name);

/// Name under which the new layout opens, instead of a file.
inline constexpr std::string_view kNewLayout = "built-in: new layout";
/// Returns a layout without taxels on the fingertip's mesh, with the fingertip's settings. Throws Cancelled.
LoadedDocument new_layout(const SensorBuild& how);

/// Writes the example layouts, meshes and scenes, as files to open, into a folder, in the folders `layouts`, `meshes`
/// and `scenes`. Files that exist stay as they are: the user may have changed them. Throws Error naming a file that
/// cannot be written.
void write_examples(const std::filesystem::path& folder);

}  // namespace taxel::studio
