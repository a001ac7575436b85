#include "core/layout/sampling/surface_walk.h"

namespace taxel {
namespace {

double squared(const dvec2& v) {
  return glm::dot(v, v);
}

/// Squared distance of the origin from a segment.
double from_origin(const dvec2& a, const dvec2& b) {
  const dvec2 edge = b - a;
  const double length = squared(edge);
  const double t = length > 0.0 ? glm::clamp(-glm::dot(a, edge) / length, 0.0, 1.0) : 0.0;
  return squared(a + t * edge);
}

}  // namespace

SurfaceGraph::SurfaceGraph(const TriMesh& mesh) : mesh_(mesh), sides_(3 * mesh.faces().size()) {
  // Half-edges by the vertex where they begin.
  std::vector<int> first(mesh.vertices().size() + 1, 0);
  for (const ivec3& f : mesh.faces())
    for (int c = 0; c < 3; ++c) ++first[static_cast<std::size_t>(f[c]) + 1];
  for (std::size_t v = 0; v + 1 < first.size(); ++v) first[v + 1] += first[v];
  std::vector<int> sides(3 * mesh.faces().size()), next(first.begin(), first.end() - 1);
  for (int f = 0; f < mesh.face_count(); ++f)
    for (int c = 0; c < 3; ++c)
      sides[static_cast<std::size_t>(next[static_cast<std::size_t>(mesh.faces()[static_cast<std::size_t>(f)][c])]++)] =
          3 * f + c;
  const auto end_of = [&](int side) { return mesh.faces()[static_cast<std::size_t>(side / 3)][(side % 3 + 1) % 3]; };
  const auto sides_between = [&](int a, int b, int& last) {
    int count = 0;
    for (int i = first[static_cast<std::size_t>(a)]; i < first[static_cast<std::size_t>(a) + 1]; ++i)
      if (end_of(sides[static_cast<std::size_t>(i)]) == b) last = sides[static_cast<std::size_t>(i)], ++count;
    return count;
  };
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const int a = mesh.faces()[static_cast<std::size_t>(f)][c], b = end_of(3 * f + c);
      Side& mine = sides_[side(f, c)];
      mine.along = glm::normalize(mesh.vertex(f, (c + 1) % 3) - mesh.vertex(f, c));
      mine.outward = glm::cross(mine.along, mesh.face_normals()[static_cast<std::size_t>(f)]);
      int found = kNone;
      if (sides_between(a, b, found) == 1 && sides_between(b, a, found) == 1) mine.across = found;
    }
  }
}

SurfaceStep SurfaceGraph::walk(SurfaceStep at, dvec3 way) const {
  int came_from = -1;
  for (int steps = 0; steps < 4 * mesh_.face_count() + 16; ++steps) {  // ends a walk round and round a point
    double part = 1.0;
    int exit = -1;
    for (int c = 0; c < 3; ++c) {
      const dvec3& outward = sides_[side(at.face, c)].outward;
      const double speed = glm::dot(way, outward);
      if (c == came_from || !(speed > 0.0)) continue;
      const double t = std::max(0.0, glm::dot(mesh_.vertex(at.face, c) - at.position, outward) / speed);
      if (t < part) part = t, exit = c;
    }
    at.position += part * way;
    if (exit < 0) return at;
    const int entered = sides_[side(at.face, exit)].across;
    if (entered == kNone) return at;
    way = turn((1.0 - part) * way, at.face, exit);
    at.face = entered / 3;
    came_from = entered % 3;
  }
  return at;
}

SurfaceChart::SurfaceChart(const SurfaceGraph& graph)
    : graph_(graph), image_of_(static_cast<std::size_t>(graph.mesh().face_count()), -1), stamp_(image_of_.size(), 0) {}

void SurfaceChart::unfold(const SurfaceStep& origin, const dvec3& u, const dvec3& v, double radius) {
  ++round_;
  images_.clear();
  entries_.clear();
  const double limit = radius * radius;
  add({origin.face, origin.position, u, v, dvec2(0)}, limit);
  while (!entries_.empty()) {
    std::pop_heap(entries_.begin(), entries_.end());
    const Entry entry = entries_.back();
    entries_.pop_back();
    if (has(entry.face)) continue;
    const Image& from = images_[static_cast<std::size_t>(entry.image)];
    const dvec3& base = graph_.mesh().vertex(from.face, entry.corner);
    add({entry.face, base, graph_.turn(from.u, from.face, entry.corner), graph_.turn(from.v, from.face, entry.corner),
         from.of(base)},
        limit);
  }
}

void SurfaceChart::add(const Image& image, double limit) {
  const auto f = static_cast<std::size_t>(image.face);
  stamp_[f] = round_;
  image_of_[f] = static_cast<int>(images_.size());
  images_.push_back(image);
  const TriMesh& mesh = graph_.mesh();
  for (int c = 0; c < 3; ++c) {
    const int next = graph_.across(image.face, c);
    if (next < 0 || has(next)) continue;
    const double distance =
        from_origin(image.of(mesh.vertex(image.face, c)), image.of(mesh.vertex(image.face, (c + 1) % 3)));
    if (!(distance < limit)) continue;
    entries_.push_back({distance, next, image_of_[f], c});
    std::push_heap(entries_.begin(), entries_.end());
  }
}

bool SurfaceChart::find(const SurfaceStep& place, dvec2& flat) const {
  if (!has(place.face)) return false;
  flat = images_[static_cast<std::size_t>(image_of_[static_cast<std::size_t>(place.face)])].of(place.position);
  return true;
}

}  // namespace taxel
