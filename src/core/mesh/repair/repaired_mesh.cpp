#include "core/mesh/repair/repaired_mesh.h"

#include <algorithm>

namespace taxel {

RepairedMeshPtr as_loaded(const TriMeshPtr& loaded) {
  auto repaired = std::make_shared<RepairedMesh>();
  repaired->mesh = loaded;
  RepairReport& report = repaired->report;
  report.closed = loaded->closed();
  report.faces_before = report.faces_after = loaded->face_count();
  report.shells_before = report.shells_after = loaded->shell_count();
  return repaired;
}

std::vector<int> repaired_faces(const RepairedMesh& repaired, const std::vector<int>& loaded_faces) {
  if (repaired.loaded_face_of.empty()) return loaded_faces;
  std::vector<int> faces;
  for (std::size_t f = 0; f < repaired.loaded_face_of.size(); ++f)
    if (std::binary_search(loaded_faces.begin(), loaded_faces.end(), repaired.loaded_face_of[f]))
      faces.push_back(static_cast<int>(f));
  return faces;
}

std::vector<int> loaded_faces(const RepairedMesh& repaired, const std::vector<int>& faces) {
  std::vector<int> loaded;
  for (const int face : faces)
    if (const int from = repaired.loaded_face(face); from >= 0) loaded.push_back(from);
  std::sort(loaded.begin(), loaded.end());
  loaded.erase(std::unique(loaded.begin(), loaded.end()), loaded.end());
  return loaded;
}

}  // namespace taxel
