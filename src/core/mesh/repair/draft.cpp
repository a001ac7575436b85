#include "core/mesh/repair/draft.h"

#include <tuple>

namespace taxel {

Draft make_draft(const TriMesh& mesh) {
  Draft draft{mesh.vertices(), mesh.faces(), {}};
  draft.loaded.resize(draft.faces.size());
  for (std::size_t f = 0; f < draft.faces.size(); ++f) draft.loaded[f] = static_cast<int>(f);
  if (!mesh.closed())
    for (const ivec3& face : mesh.flat_faces()) draft.add(face, -1);
  return draft;
}

void remove_faces(Draft& draft, const std::vector<char>& removed) {
  std::size_t kept = 0;
  for (std::size_t f = 0; f < draft.faces.size(); ++f) {
    if (removed[f] != 0) continue;
    draft.faces[kept] = draft.faces[f];
    draft.loaded[kept++] = draft.loaded[f];
  }
  draft.faces.resize(kept);
  draft.loaded.resize(kept);
}

void drop_unused_points(Draft& draft) {
  std::vector<int> number(draft.points.size(), -1);
  for (const ivec3& face : draft.faces) number[at(face.x)] = number[at(face.y)] = number[at(face.z)] = 0;
  std::size_t kept = 0;
  for (std::size_t v = 0; v < draft.points.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<int>(kept);
    draft.points[kept++] = draft.points[v];
  }
  draft.points.resize(kept);
  for (ivec3& face : draft.faces) face = {number[at(face.x)], number[at(face.y)], number[at(face.z)]};
}

void join_equal_points(Draft& draft) {
  std::vector<int> order(draft.points.size()), first(draft.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto key = [&](int i) { return std::tie(draft.points[at(i)].x, draft.points[at(i)].y, draft.points[at(i)].z); };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  for (std::size_t i = 0; i < order.size(); ++i)
    first[at(order[i])] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[at(order[i - 1])] : order[i];
  for (ivec3& f : draft.faces) f = {first[at(f.x)], first[at(f.y)], first[at(f.z)]};
}

bool is_flat(const dvec3& a, const dvec3& b, const dvec3& c) {
  constexpr double kFlat = 1e-9;
  const dvec3 ab = b - a, ac = c - a, bc = c - b;
  const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
  return !(0.5 * glm::length(glm::cross(ab, ac)) > kFlat * longest);
}

int corner_at(const ivec3& face, int vertex) {
  return face.x == vertex ? 0 : face.y == vertex ? 1 : 2;
}

RepairStep start_step(const char* code) {
  RepairStep step;
  step.code = code;
  return step;
}

void add_place(RepairStep& step, const dvec3& place) {
  if (step.count++ == 0) step.place = place;
}

}  // namespace taxel
