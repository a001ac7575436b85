// Checks a layout together with its mesh, as `taxel check` and the Python package do.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/layout/layout.h"
#include "core/mesh/mesh_io.h"

namespace taxel {

/// Checks a layout on its mesh as read. Without an error, the layout is compiled, and the problems of the model, the
/// pressure field and the mesh follow. `file` is the layout's name in the problems. Throws Error if the mesh cannot be
/// repaired.
Problems check_layout_on_loaded_mesh(const Layout& layout, const LoadedMesh& loaded, const std::string& file);

/// Checks the values of a layout, then loads its mesh and checks the layout on the mesh. The mesh is relative to the
/// folder of `file`. A mesh that cannot be read is listed as a problem. Throws Error as above.
Problems check_layout_file(const Layout& layout, const std::string& file);

}  // namespace taxel
