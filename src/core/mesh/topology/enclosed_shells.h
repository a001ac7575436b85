// Which shells of a mesh lie inside another one, for all shells at once.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Per shell: 1 if it lies inside another shell (shell_is_enclosed()), 0 otherwise.
std::vector<char> enclosed_shells(const TriMesh& mesh);

}  // namespace taxel
