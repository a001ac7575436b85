// Finds the shells of a mesh that are inside another shell.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Returns 1 for each shell inside another shell (shell_is_enclosed()), and 0 for the others.
std::vector<char> enclosed_shells(const TriMesh& mesh);

}  // namespace taxel
