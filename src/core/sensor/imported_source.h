// Layouts of any format with the mesh that they sense with: formats of other programs hold none, so it is chosen.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/layout/file/layout_format.h"
#include "core/layout/file/skin_choice.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

struct ImportedSource {
  SensorSource source;
  /// Values that were not in the file, and keys that could not be carried over: a sentence each.
  std::vector<std::string> notes;
  bool frame_is_guess = false;  ///< the file does not say where the sensor points
};

/// Reads a layout of any format and its mesh. `choice.mesh` replaces the mesh of a layout that has one. Throws Error
/// for what cannot be read, for values that no mesh could make right, and for a layout without mesh if none is chosen.
ImportedSource read_any_source(const std::filesystem::path& layout_file, const SkinChoice& choice);

/// Puts an imported layout on a mesh as read; `mesh_file` names it in the layout, `scale` is already applied.
ImportedSource put_on_mesh(ImportedLayout imported, LoadedMesh mesh, const std::string& mesh_file, const dvec3& scale,
                           const std::string& layout_file);

/// Puts an imported layout on a mesh file. Throws Error as load_mesh does.
ImportedSource put_on_mesh_file(ImportedLayout imported, const std::filesystem::path& mesh_file,
                                const std::optional<dvec3>& scale, const std::string& layout_file);

}  // namespace taxel
