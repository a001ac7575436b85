// Valid meshes with one fault each, for tests of the repair.
#pragma once

#include <map>
#include <tuple>

#include "unit/mesh/random_mesh.h"

namespace taxel::test {

inline std::size_t slot(int i) {
  return static_cast<std::size_t>(i);
}

inline std::vector<int> all_faces(const TriMesh& mesh) {
  std::vector<int> faces(mesh.faces().size());
  for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = static_cast<int>(f);
  return faces;
}

/// Returns the mesh with equal vertices merged.
inline TriMesh welded(const TriMesh& mesh) {
  std::map<std::tuple<double, double, double>, int> numbers;
  std::vector<dvec3> vertices;
  std::vector<int> number_of;
  for (const dvec3& v : mesh.vertices()) {
    const auto [entry, is_new] = numbers.try_emplace({v.x, v.y, v.z}, static_cast<int>(vertices.size()));
    if (is_new) vertices.push_back(v);
    number_of.push_back(entry->second);
  }
  std::vector<ivec3> faces;
  for (const ivec3& f : mesh.faces())
    faces.emplace_back(number_of[slot(f.x)], number_of[slot(f.y)], number_of[slot(f.z)]);
  return {std::move(vertices), std::move(faces)};
}

inline TriMesh without_faces(const TriMesh& mesh, const std::vector<int>& missing) {
  std::vector<ivec3> faces;
  for (int f = 0; f < mesh.face_count(); ++f)
    if (std::find(missing.begin(), missing.end(), f) == missing.end()) faces.push_back(mesh.faces()[slot(f)]);
  return {mesh.vertices(), std::move(faces)};
}

inline TriMesh with_turned_faces(const TriMesh& mesh, const std::vector<int>& turned) {
  std::vector<ivec3> faces = mesh.faces();
  for (const int f : turned) std::swap(faces[slot(f)].y, faces[slot(f)].z);
  return {mesh.vertices(), std::move(faces)};
}

/// Adds a triangle on an edge of a face, perpendicular to the face and `height` high.
inline TriMesh with_fin(const TriMesh& mesh, int face, double height) {
  std::vector<dvec3> vertices = mesh.vertices();
  std::vector<ivec3> faces = mesh.faces();
  const ivec3 f = faces[slot(face)];
  vertices.push_back(0.5 * (vertices[slot(f.x)] + vertices[slot(f.y)]) + height * mesh.face_normals()[slot(face)]);
  faces.emplace_back(f.x, f.y, mesh.vertex_count());
  return {std::move(vertices), std::move(faces)};
}

/// Gives faces whose centre has z > 0 their own vertices, each moved by up to `gap` in each direction.
inline TriMesh torn(const TriMesh& mesh, double gap) {
  RandomStream random(7);
  std::vector<dvec3> vertices = mesh.vertices();
  std::vector<ivec3> faces = mesh.faces();
  std::map<int, int> copies;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if ((mesh.vertex(f, 0) + mesh.vertex(f, 1) + mesh.vertex(f, 2)).z <= 0) continue;
    for (int c = 0; c < 3; ++c) {
      const int vertex = faces[slot(f)][c];
      const auto [entry, is_new] = copies.try_emplace(vertex, static_cast<int>(vertices.size()));
      if (is_new) vertices.push_back(vertices[slot(vertex)] + random.in_cube(gap));
      faces[slot(f)][c] = entry->second;
    }
  }
  return {std::move(vertices), std::move(faces)};
}

/// Returns a cube of half width h with its sides divided into n by n squares.
inline TriMesh refined_box(double h, int n) {
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int sign : {-1, 1}) {
      const int first = static_cast<int>(vertices.size());
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
          dvec3 p;
          p[axis] = sign * h;
          p[(axis + 1) % 3] = h * (2.0 * i / n - 1);
          p[(axis + 2) % 3] = h * (2.0 * j / n - 1);
          vertices.push_back(p);
        }
      }
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const int a = first + i * (n + 1) + j, b = a + n + 1;
          faces.emplace_back(a, sign > 0 ? b : b + 1, sign > 0 ? b + 1 : b);
          faces.emplace_back(a, sign > 0 ? b + 1 : a + 1, sign > 0 ? a + 1 : b + 1);
        }
      }
    }
  }
  return welded({std::move(vertices), std::move(faces)});
}

/// Returns a cube with a vertex in the middle of an edge that only the face on one side of the edge uses. The vertex is
/// the last one.
inline TriMesh box_with_t_junction(double h) {
  const TriMesh box = make_box(dvec3(h));
  std::vector<dvec3> vertices = box.vertices();
  std::vector<ivec3> faces = box.faces();
  const ivec3 f = faces[0];
  vertices.push_back(0.5 * (vertices[slot(f.x)] + vertices[slot(f.y)]));
  faces[0] = {f.x, box.vertex_count(), f.z};
  faces.emplace_back(box.vertex_count(), f.y, f.z);
  return {std::move(vertices), std::move(faces)};
}
/// Returns the face without area that closes the gap of box_with_t_junction.
inline ivec3 t_junction_face() {
  const TriMesh box = make_box(dvec3(1));
  return {box.faces()[0].x, box.faces()[0].y, box.vertex_count()};
}

inline TriMesh hollow_sphere(double outer, double inner) {
  const TriMesh hole = make_icosphere(inner, 2);
  return together(make_icosphere(outer, 2), with_turned_faces(hole, all_faces(hole)));
}

/// Returns cubes of half width h, joined face to face into one body whose first and last cube touch along an edge.
inline TriMesh closed_ring_of_cubes(double h) {
  const std::vector<ivec3> ring{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}};
  TriMesh all = moved(make_box(dvec3(h)), 2 * h * dvec3(ring[0]));
  for (std::size_t i = 1; i < ring.size(); ++i) all = together(all, moved(make_box(dvec3(h)), 2 * h * dvec3(ring[i])));
  // Sides between two cubes of the ring are removed: the faces whose square occurs twice.
  std::map<std::tuple<long, long, long>, int> squares;
  const auto square = [&](const TriMesh& mesh, int f) {
    Aabb box;
    for (int c = 0; c < 3; ++c) box.include(mesh.vertex(f, c));
    const dvec3 q = box.center() / h;
    return std::tuple(std::lround(q.x), std::lround(q.y), std::lround(q.z));
  };
  for (int f = 0; f < all.face_count(); ++f) ++squares[square(all, f)];
  std::vector<int> inner;
  for (int f = 0; f < all.face_count(); ++f)
    if (squares[square(all, f)] == 4) inner.push_back(f);
  const TriMesh rounded = without_faces(all, inner);
  std::vector<dvec3> vertices;
  for (const dvec3& v : rounded.vertices()) vertices.push_back(h * glm::round(v / h));
  return extract_faces(welded({std::move(vertices), rounded.faces()}), all_faces(rounded));
}

/// Returns a band of mean radius r and half width w, twisted by half a turn around its middle line.
inline TriMesh moebius_strip(double r, double w, int n) {
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * i / n;
    for (const double side : {-w, w}) {
      const double radius = r + side * std::cos(angle / 2);
      vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), side * std::sin(angle / 2));
    }
    const int next = i + 1 < n ? 2 * i + 2 : 1, other = i + 1 < n ? 2 * i + 3 : 0;
    faces.emplace_back(2 * i, next, 2 * i + 1);
    faces.emplace_back(2 * i + 1, next, other);
  }
  return {std::move(vertices), std::move(faces)};
}

}  // namespace taxel::test
