#include <array>
#include <tuple>
#include <utility>

#include "core/mesh/mesh_check.h"

namespace taxel {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

struct Side {
  int low, high, face;
  bool forward;  // the face runs from low to high
};

/// A face across an edge with exactly two faces, and whether both wind alike.
struct Link {
  int face = -1;
  bool alike = true;
};

std::vector<std::vector<Link>> links(const TriMesh& mesh) {
  std::vector<Side> sides;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const ivec3& ids = mesh.faces()[at(f)];
    for (int c = 0; c < 3; ++c) {
      const int a = ids[c], b = ids[(c + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), f, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });
  std::vector<std::vector<Link>> result(at(mesh.face_count()));
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high) ++end;
    if (end - begin != 2) continue;
    const Side &s = sides[begin], &t = sides[begin + 1];
    const bool alike = s.forward != t.forward;
    result[at(s.face)].push_back({t.face, alike});
    result[at(t.face)].push_back({s.face, alike});
  }
  return result;
}

}  // namespace

TriMesh oriented(const TriMesh& mesh) {
  const std::vector<std::vector<Link>> neighbours = links(mesh);
  std::vector<int> turned(at(mesh.face_count()), -1);  // -1: not seen yet
  std::vector<ivec3> faces = mesh.faces();
  std::vector<int> queue;
  for (int seed = 0; seed < mesh.face_count(); ++seed) {
    if (turned[at(seed)] >= 0) continue;
    queue.assign(1, seed);
    turned[at(seed)] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const Link& link : neighbours[at(queue[i])]) {
        if (turned[at(link.face)] >= 0) continue;
        turned[at(link.face)] = link.alike ? turned[at(queue[i])] : 1 - turned[at(queue[i])];
        queue.push_back(link.face);
      }
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (turned[f] == 1) std::swap(faces[f].y, faces[f].z);
  }
  TriMesh alike(mesh.vertices(), faces);
  if (!alike.closed()) return alike;
  // A closed shell encloses a positive volume, a cavity a negative one.
  std::vector<char> flip(at(alike.shell_count()), 0);
  for (int s = 0; s < alike.shell_count(); ++s)
    flip[at(s)] = (extract_shells(alike, {s}).volume() < 0) != shell_is_enclosed(alike, s) ? 1 : 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (flip[at(alike.shell_of_face()[f])] != 0) std::swap(faces[f].y, faces[f].z);
  }
  return {mesh.vertices(), std::move(faces)};
}

}  // namespace taxel
