// The search for the layout of a sensor: MuJoCo does not give a plugin the folder of the scene file.
#pragma once

#include <filesystem>
#include <functional>
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
  /// For a layout given as text, the reason for which its mesh file is not there; otherwise empty.
  std::string no_mesh;
};

/// Reads a layout. `value` is an absolute path, a path relative to one of `folders` (the first one that has the file),
/// or the JSON text of the layout (begins with '{'), whose mesh is then searched in `folders`. Throws Error that lists
/// the searched folders if there is no such layout file.
FoundLayout find_layout(const std::string& value, const std::vector<std::filesystem::path>& folders);

/// Reads the mesh and compiles the sensor. If the mesh file does not exist, takes the triangles that `mesh_of_scene`
/// returns instead, frame M, unless they are null. Throws Error if the mesh cannot be read or the sensor not compiled.
SensorModelPtr compile_layout(const FoundLayout& found, const std::function<TriMeshPtr()>& mesh_of_scene);

}  // namespace taxel
