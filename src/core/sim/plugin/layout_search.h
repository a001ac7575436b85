// Where the plugin finds the layout: MuJoCo does not tell a plugin where the scene file lies.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/layout/layout.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// A layout and the place from which its mesh file is looked for.
struct FoundLayout {
  Layout layout;
  std::filesystem::path file;  ///< of the layout; for a layout given as text, a name in `folders` beside its mesh
};

/// `value` is an absolute path, a path relative to one of `folders` (the first that has it), or the layout's JSON text
/// itself (begins with '{'), whose mesh is then looked for in `folders`. Throws Error that lists the folders tried.
FoundLayout find_layout(const std::string& value, const std::vector<std::filesystem::path>& folders);

/// Reads the mesh and compiles the sensor.
SensorModelPtr compile_layout(const FoundLayout& found);

}  // namespace taxel
