// Faces of a repaired mesh and those of the mesh as loaded that they come from.
#pragma once

#include <vector>

#include "core/mesh/repair/repaired_mesh.h"

namespace taxel {

/// The loaded mesh as it is, with a report of no change.
RepairedMeshPtr as_loaded(const TriMeshPtr& loaded);

/// Faces of the repaired mesh that come from `loaded_faces`. Both lists ascend.
std::vector<int> repaired_faces(const RepairedMesh& repaired, const std::vector<int>& loaded_faces);

/// Faces of the loaded mesh that `faces` of the repaired mesh come from, each once, ascending. Filled-in faces come
/// from none.
std::vector<int> loaded_faces(const RepairedMesh& repaired, const std::vector<int>& faces);

}  // namespace taxel
