#include "core/mesh/repair/steps/shells.h"

#include "core/mesh/query/disjoint_sets.h"
#include "core/mesh/query/self_intersection.h"

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

Draft extract_faces(const Draft& draft, const std::vector<int>& faces) {
  std::vector<int> points;
  points.reserve(3 * faces.size());
  for (const int f : faces)
    for (int c = 0; c < 3; ++c) points.push_back(draft.faces[at(f)][c]);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Draft part;
  for (const int v : points) part.points.push_back(draft.points[at(v)]);
  const auto number = [&](int v) {
    return static_cast<int>(std::lower_bound(points.begin(), points.end(), v) - points.begin());
  };
  for (const int f : faces) {
    const ivec3& face = draft.faces[at(f)];
    part.add({number(face.x), number(face.y), number(face.z)}, draft.loaded[at(f)]);
  }
  return part;
}

void append(Draft& draft, const Draft& other) {
  const int first = draft.point_count();
  draft.points.insert(draft.points.end(), other.points.begin(), other.points.end());
  for (int f = 0; f < other.face_count(); ++f) draft.add(other.faces[at(f)] + first, other.loaded[at(f)]);
}

BoxTree tree_of_faces(const Draft& draft) {
  std::vector<Aabb> boxes(draft.faces.size());
  for (int f = 0; f < draft.face_count(); ++f)
    for (int c = 0; c < 3; ++c) boxes[at(f)].include(draft.corner(f, c));
  return BoxTree(boxes, Bvh::Effort::few_queries);
}

std::vector<std::pair<int, int>> find_crossing_pairs(const Draft& draft) {
  return find_crossing_pairs(draft, std::vector<char>(draft.faces.size(), 1));
}

std::vector<std::pair<int, int>> find_crossing_pairs(const Draft& draft, const std::vector<char>& chosen) {
  return find_crossing_pairs(draft.points, draft.faces, chosen);
}

int few_pairs(int faces) {
  constexpr double kFew = 1e-3;
  constexpr int kAlwaysFew = 3;
  return std::max(kAlwaysFew, static_cast<int>(kFew * faces));
}

}  // namespace taxel
