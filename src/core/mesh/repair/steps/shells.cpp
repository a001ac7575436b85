#include "core/mesh/repair/steps/shells.h"

#include "core/mesh/query/disjoint_sets.h"

namespace taxel {

FaceShells find_shells(const Draft& draft) {
  DisjointSets sets(draft.points.size());
  for (const ivec3& f : draft.faces) {
    sets.unite(f.x, f.y);
    sets.unite(f.x, f.z);
  }
  FaceShells shells;
  std::vector<int> number(draft.points.size(), -1);
  for (int f = 0; f < draft.face_count(); ++f) {
    int& shell = number[at(sets.find(draft.faces[at(f)].x))];
    if (shell < 0) {
      shell = static_cast<int>(shells.faces.size());
      shells.faces.emplace_back();
    }
    shells.faces[at(shell)].push_back(f);
    shells.of_face.push_back(shell);
  }
  return shells;
}

double volume_of(const Draft& draft, const std::vector<int>& faces) {
  const dvec3 apex = draft.corner(faces.front(), 0);
  double volume = 0;
  for (const int f : faces) {
    volume +=
        glm::dot(draft.corner(f, 0) - apex, glm::cross(draft.corner(f, 1) - apex, draft.corner(f, 2) - apex)) / 6.0;
  }
  return volume;
}

bool cuts_through_itself(const SelfIntersections& found, int faces) {
  constexpr double kFew = 1e-3;
  constexpr int kMinPairs = 4;
  return found.pairs >= kMinPairs && found.pairs > kFew * faces;
}

bool cuts_through_itself(const Draft& draft) {
  std::vector<ivec3> faces;
  for (int f = 0; f < draft.face_count(); ++f)
    if (draft.area(f) > 0) faces.push_back(draft.faces[at(f)]);
  if (faces.empty()) return false;
  const auto count = static_cast<int>(faces.size());
  return cuts_through_itself(find_self_intersections(TriMesh(draft.points, std::move(faces))), count);
}

}  // namespace taxel
