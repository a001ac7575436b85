// Layouts of any format with their mesh, and the checks of a layout together with its mesh. The formats of other
// programs have no mesh, so the user chooses one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/layout/formats/layout_format.h"
#include "core/layout/layout.h"
#include "core/layout/user_choices.h"
#include "core/mesh/mesh_io.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// A layout of any format on its mesh.
struct ImportedSource {
  SensorSource source;
  /// One sentence for each value that was not in the file, and for each key that was ignored.
  std::vector<std::string> notes;
  bool frame_is_guess = false;  ///< true if the directions of the sensor are not from the file
};

/// Reads a layout of any format and its mesh. `choice.mesh` replaces the mesh of a layout that has one. Throws Error: a
/// file cannot be read, a value is wrong on any mesh, or the layout has no mesh and none is chosen.
ImportedSource read_any_source(const std::filesystem::path& layout_file, const SkinChoice& choice);

/// Puts an imported layout on a mesh as read, to which `scale` was applied. `mesh_file` is the mesh's name in the
/// layout.
ImportedSource put_on_mesh(ImportedLayout imported, LoadedMesh mesh, const std::string& mesh_file, const dvec3& scale,
                           const std::string& layout_file);

/// Puts an imported layout on a mesh file. Throws Error as load_mesh() does.
ImportedSource put_on_mesh_file(ImportedLayout imported, const std::filesystem::path& mesh_file,
                                const std::optional<dvec3>& scale, const std::string& layout_file);

/// Checks a layout on its mesh as read, as `taxel check` and the Python package do. Without an error, the layout is
/// compiled, and the problems of the model, the pressure field and the mesh follow. `file` is the layout's name in the
/// problems. Throws Error if the mesh cannot be repaired.
Problems check_layout_on_loaded_mesh(const Layout& layout, const LoadedMesh& loaded, const std::string& file);

/// Checks the values of a layout, then loads its mesh and checks the layout on the mesh. The mesh is relative to the
/// folder of `file`. A mesh that cannot be read is listed as a problem. Throws Error as above.
Problems check_layout_file(const Layout& layout, const std::string& file);

}  // namespace taxel
