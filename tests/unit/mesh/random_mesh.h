// Random meshes for oracles: triangle soups with the hard cases of a BVH, and bumpy spheres.
#pragma once

#include "core/base/rng.h"
#include "core/mesh/make/primitives.h"

namespace taxel::test {

/// A stream of random numbers and points.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed) : rng_(seed) {}
  double uniform(double lo, double hi) { return lo + (hi - lo) * rng_.uniform(next_++); }
  int below(int n) { return static_cast<int>(rng_.bits(next_++) % static_cast<std::uint64_t>(n)); }
  dvec3 in_cube(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
  dvec3 direction() {
    for (;;) {
      const dvec3 v = in_cube(1);
      const double length = glm::length(v);
      if (length > 0.1 && length < 1) return v / length;
    }
  }

 private:
  CounterRng rng_;
  std::uint64_t next_ = 0;
};

/// Returns triangles at random places in the unit cube: small, large, needles, and several at exactly the same place.
inline TriMesh random_soup(std::uint64_t seed, int face_count) {
  RandomStream random(seed);
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  while (static_cast<int>(faces.size()) < face_count) {
    const double size = std::pow(10.0, random.uniform(-6, 0));
    dvec3 a = random.in_cube(1), b = a + size * random.direction(), c = a + size * random.direction();
    if (random.below(4) == 0) c = 0.5 * (a + b) + 1e-7 * size * random.direction();  // a needle
    // A flat box, with many triangles in one plane.
    if (random.below(4) == 0) a.z = b.z = c.z = 0.25;
    if (!(glm::length(glm::cross(b - a, c - a)) > 0)) continue;
    const int copies = random.below(8) == 0 ? 3 : 1;
    for (int i = 0; i < copies; ++i) {
      const int first = static_cast<int>(vertices.size());
      vertices.insert(vertices.end(), {a, b, c});
      faces.emplace_back(first, first + 1, first + 2);
    }
  }
  return {std::move(vertices), std::move(faces)};
}

/// Returns a sphere with waves in its radius: smooth, closed, not convex.
inline TriMesh bumpy_sphere(int subdivisions) {
  const TriMesh sphere = make_icosphere(1.0, subdivisions);
  std::vector<dvec3> vertices = sphere.vertices();
  for (dvec3& v : vertices) v *= 1.0 + 0.2 * std::sin(5 * v.x) * std::cos(4 * v.y + v.z);
  return {std::move(vertices), sphere.faces()};
}

/// Returns two meshes as one mesh without merging vertices.
inline TriMesh together(const TriMesh& a, const TriMesh& b) {
  std::vector<dvec3> vertices = a.vertices();
  std::vector<ivec3> faces = a.faces();
  for (const ivec3& f : b.faces()) faces.push_back(f + a.vertex_count());
  vertices.insert(vertices.end(), b.vertices().begin(), b.vertices().end());
  return {std::move(vertices), std::move(faces)};
}

inline TriMesh moved(const TriMesh& mesh, const dvec3& by) {
  std::vector<dvec3> vertices = mesh.vertices();
  for (dvec3& v : vertices) v += by;
  return {std::move(vertices), mesh.faces()};
}

}  // namespace taxel::test
