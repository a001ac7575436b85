// Maps faces of a repaired mesh to the loaded faces that they come from, and back.
#pragma once

#include <vector>

#include "core/mesh/repair/repaired_mesh.h"

namespace taxel {

/// Returns the loaded mesh as a repaired mesh without changes.
RepairedMeshPtr as_loaded(const TriMeshPtr& loaded);

/// Returns the faces of the repaired mesh that come from `loaded_faces`. Both lists are ascending.
std::vector<int> repaired_faces(const RepairedMesh& repaired, const std::vector<int>& loaded_faces);

/// Returns the loaded faces that `faces` of the repaired mesh come from, each once, ascending. Filled-in faces have no
/// loaded face.
std::vector<int> loaded_faces(const RepairedMesh& repaired, const std::vector<int>& faces);

}  // namespace taxel
