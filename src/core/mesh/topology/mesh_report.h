// What reading a mesh did and what is wrong with it, with what that means for a sensor: for people, not for programs.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

struct MeshFinding {
  Severity severity = Severity::note;
  std::string code;     ///< of check_mesh, or "mesh_repaired"
  std::string what;     ///< with the number of places and the first of them
  std::string meaning;  ///< for sensing
};
using MeshFindings = std::vector<MeshFinding>;

/// What check_mesh lists, the gravest first, and then what was done on reading (LoadedMesh::notes). Empty: nothing to
/// say. Costs what check_mesh costs.
MeshFindings mesh_report(const TriMesh& mesh, const std::vector<std::string>& notes);

/// For a line of text: "3 warnings, 1 note"; empty where there is nothing.
std::string count_findings(const MeshFindings& findings);

}  // namespace taxel
