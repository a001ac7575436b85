// The search for the layout of a sensor: MuJoCo does not give a plugin the folder of the scene file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/layout/layout.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// A layout, and the file relative to which its mesh is searched.
struct FoundLayout {
  Layout layout;
  /// File of the layout. For a layout given as text, a file name in the folder of its mesh.
  std::filesystem::path file;
};

/// Reads a layout. `value` is an absolute path, a path relative to one of `folders` (the first one that has the file),
/// or the JSON text of the layout (begins with '{'), whose mesh is then searched in `folders`. Throws Error that lists
/// the searched folders.
FoundLayout find_layout(const std::string& value, const std::vector<std::filesystem::path>& folders);

/// Reads the mesh and compiles the sensor. Throws Error if either fails.
SensorModelPtr compile_layout(const FoundLayout& found);

}  // namespace taxel
