// Findings about a mesh in words, with their meaning for a sensor.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

struct MeshFinding {
  Severity severity = Severity::note;
  std::string code;     ///< code of check_mesh, or "mesh_repaired"
  std::string what;     ///< sentence with the number of places and the first of them
  std::string meaning;  ///< consequence for sensing
};
using MeshFindings = std::vector<MeshFinding>;

/// Returns the problems of check_mesh, the most severe first, followed by `notes`, the changes made while reading
/// (LoadedMesh::notes). The cost is that of check_mesh.
MeshFindings mesh_report(const TriMesh& mesh, const std::vector<std::string>& notes);
/// As above, with the tree of the faces that exists already.
MeshFindings mesh_report(const MeshIndex& index, const std::vector<std::string>& notes);

/// Returns the numbers of findings, as in "3 warnings, 1 note". Empty if there are none.
std::string count_findings(const MeshFindings& findings);

}  // namespace taxel
