#include "core/mesh/make/primitives.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/mesh/ring_surface.h"

namespace taxel {
namespace {

void require_positive(double value, const char* what) {
  if (!(value > 0) || !std::isfinite(value)) throw Error(fmt::format("{} must be positive, not {}", what, value));
}

Error too_fine(double edge_length, double size) {
  return Error(fmt::format("edge length {} is too small for a size of {}", edge_length, size));
}

/// Returns the number of pieces of at most `piece` that a length needs.
int pieces(double length, double piece) {
  return std::max(1, static_cast<int>(std::ceil(length / piece)));
}

struct Polyhedron {
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
};

Polyhedron icosahedron() {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));  // golden ratio
  return {{{-1, g, 0},
           {1, g, 0},
           {-1, -g, 0},
           {1, -g, 0},
           {0, -1, g},
           {0, 1, g},
           {0, -1, -g},
           {0, 1, -g},
           {g, 0, -1},
           {g, 0, 1},
           {-g, 0, -1},
           {-g, 0, 1}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

/// Splits every triangle into four at the middles of its edges, and moves these onto the unit sphere.
void subdivide_on_unit_sphere(Polyhedron& p) {
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [entry, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<int>(p.vertices.size()));
    if (fresh) p.vertices.push_back(glm::normalize(p.vertices[at(a)] + p.vertices[at(b)]));
    return entry->second;
  };
  std::vector<ivec3> faces;
  faces.reserve(4 * p.faces.size());
  for (const ivec3& f : p.faces) {
    const int a = middle(f.x, f.y), b = middle(f.y, f.z), c = middle(f.z, f.x);
    faces.insert(faces.end(), {ivec3(f.x, a, c), ivec3(f.y, b, a), ivec3(f.z, c, b), ivec3(a, b, c)});
  }
  p.faces = std::move(faces);
}

constexpr int kMaxSubdivisions = 9;  // 5 million triangles
constexpr int kDrawnSteps = 7;       // from the pole of a drawn ball to its rim of 5 times as many corners

Polyhedron unit_icosphere(int subdivisions) {
  if (subdivisions < 0 || subdivisions > kMaxSubdivisions)
    throw Error(fmt::format("a sphere of {} subdivisions is out of range (0 to {})", subdivisions, kMaxSubdivisions));
  Polyhedron p = icosahedron();
  for (dvec3& v : p.vertices) v = glm::normalize(v);
  for (int i = 0; i < subdivisions; ++i) subdivide_on_unit_sphere(p);
  return p;
}

double longest_edge(const std::vector<dvec3>& vertices, const std::vector<ivec3>& faces, const dvec3& scale) {
  double longest = 0;
  for (const ivec3& f : faces) {
    for (int c = 0; c < 3; ++c)
      longest = std::max(longest, glm::length(scale * (vertices[at(f[c])] - vertices[at(f[(c + 1) % 3])])));
  }
  return longest;
}

/// Returns one ring of `count` points.
std::vector<dvec3> circle(double radius, double z, int count) {
  std::vector<dvec3> ring;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * kPi * i / count;
    ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return ring;
}

/// Makes flat caps of rings of 6 k points, and `rows` of aligned points, so that the side is a prism.
TriMesh cylinder(double radius, double half_length, int discs, int rows) {
  RingSurface surface;
  for (int k = 0; k <= discs; ++k) surface.add_ring(circle(radius * k / discs, -half_length, std::max(1, 6 * k)));
  for (int k = 1; k <= rows; ++k) surface.add_ring(circle(radius, half_length * (2.0 * k / rows - 1.0), 6 * discs));
  for (int k = discs - 1; k >= 0; --k) surface.add_ring(circle(radius * k / discs, half_length, std::max(1, 6 * k)));
  return surface.mesh();
}

/// Makes round caps of rings of 5 k points, k `steps` from the pole, with even triangles at the pole and at the rim.
/// The result without rows is a ball.
TriMesh capsule(double radius, double half_length, int steps, int rows) {
  const auto cap_ring = [&](int k, double side) {
    const double angle = 0.5 * kPi * k / steps;
    const double z = k == steps ? half_length : half_length + radius * std::cos(angle);
    return circle(k == 0 ? 0.0 : radius * std::sin(angle), side * z, std::max(1, 5 * k));
  };
  RingSurface surface;
  for (int k = 0; k <= steps; ++k) surface.add_ring(cap_ring(k, -1));
  for (int k = 1; k <= rows; ++k) surface.add_ring(circle(radius, half_length * (2.0 * k / rows - 1.0), 5 * steps));
  for (int k = steps - 1; k >= 0; --k) surface.add_ring(cap_ring(k, 1));
  return surface.mesh();
}

/// Throws Error if the mesh of a surface would have more than about 10^7 triangles, as after a mistake in the unit.
void require_feasible(double area, double size, double edge_length) {
  require_positive(edge_length, "edge length");
  constexpr double kMost = 5e6;
  if (area / edge_length / edge_length > kMost || size / edge_length > kMost) throw too_fine(edge_length, size);
}

/// Calls make(step) with ever smaller steps until no edge is longer than `edge_length`.
template <class Make>
TriMesh as_fine_as(double edge_length, const Make& make) {
  for (double step = edge_length;;) {
    TriMesh mesh = make(step);
    const double longest = longest_edge(mesh.vertices(), mesh.faces(), dvec3(1));
    if (longest <= edge_length) return mesh;
    step *= 0.99 * edge_length / longest;
  }
}

}  // namespace

TriMesh make_box(const dvec3& half_size) {
  for (int i = 0; i < 3; ++i) require_positive(half_size[i], "half size of a box");
  std::vector<dvec3> vertices;
  for (int i = 0; i < 8; ++i)
    vertices.push_back(half_size * dvec3((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1));
  return {std::move(vertices),
          {{0, 2, 3},
           {0, 3, 1},
           {4, 5, 7},
           {4, 7, 6},
           {0, 1, 5},
           {0, 5, 4},
           {2, 6, 7},
           {2, 7, 3},
           {0, 4, 6},
           {0, 6, 2},
           {1, 3, 7},
           {1, 7, 5}}};
}

TriMesh make_icosphere(double radius, int subdivisions) {
  require_positive(radius, "radius of a sphere");
  Polyhedron p = unit_icosphere(subdivisions);
  for (dvec3& v : p.vertices) v *= radius;
  return {std::move(p.vertices), std::move(p.faces)};
}

TriMesh make_sphere(double radius, double edge_length) {
  require_positive(radius, "radius of a sphere");
  return make_ellipsoid(dvec3(radius), edge_length);
}

TriMesh make_ellipsoid(const dvec3& semi_axes, double edge_length) {
  for (int i = 0; i < 3; ++i) require_positive(semi_axes[i], "semi-axis of an ellipsoid");
  require_positive(edge_length, "edge length");
  // A subdivision divides edge lengths by at most 2: an edge length that is out of reach is refused first.
  const double smallest = std::min({semi_axes.x, semi_axes.y, semi_axes.z});
  if (smallest > edge_length * (1 << kMaxSubdivisions)) throw too_fine(edge_length, smallest);
  Polyhedron p = unit_icosphere(0);
  for (int i = 0; longest_edge(p.vertices, p.faces, semi_axes) > edge_length; ++i) {
    if (i == kMaxSubdivisions) throw too_fine(edge_length, smallest);
    subdivide_on_unit_sphere(p);
  }
  for (dvec3& v : p.vertices) v *= semi_axes;
  return {std::move(p.vertices), std::move(p.faces)};
}

TriMesh make_cylinder(double radius, double half_length, double edge_length) {
  require_positive(radius, "radius of a cylinder");
  require_positive(half_length, "half length of a cylinder");
  require_feasible(2.0 * kPi * radius * (radius + 2.0 * half_length), std::max(radius, half_length), edge_length);
  return as_fine_as(edge_length, [&](double step) {
    return cylinder(radius, half_length, pieces(2.0 * kPi * radius, 6.0 * step), pieces(2.0 * half_length, step));
  });
}

TriMesh make_capsule(double radius, double half_length, double edge_length) {
  require_positive(radius, "radius of a capsule");
  require_positive(half_length, "half length of a capsule");
  require_feasible(4.0 * kPi * radius * (radius + half_length), std::max(radius, half_length), edge_length);
  return as_fine_as(edge_length, [&](double step) {
    return capsule(radius, half_length, pieces(0.5 * kPi * radius, step), pieces(2.0 * half_length, step));
  });
}

TriMesh make_drawn_capsule(double radius, double half_length) {
  return capsule(radius, half_length, kDrawnSteps, 1);
}

TriMesh make_drawn_cylinder(double radius, double half_length) {
  RingSurface surface;
  for (const double side : {-1.0, 1.0}) {
    const std::vector<dvec3> pole{{0, 0, side * half_length}};
    if (side < 0) surface.add_ring(pole);
    surface.add_ring(circle(radius, side * half_length, 5 * kDrawnSteps));
    if (side > 0) surface.add_ring(pole);
  }
  return surface.mesh();
}

TriMesh make_drawn_ellipsoid(const dvec3& semi_axes) {
  const TriMesh sphere = capsule(1, 0, kDrawnSteps, 0);
  std::vector<dvec3> vertices = sphere.vertices();
  for (dvec3& v : vertices) v *= semi_axes;
  return {std::move(vertices), sphere.faces()};
}

TriMesh scaled_to_volume(const TriMesh& mesh, double volume) {
  require_positive(volume / mesh.volume(), "ratio of the wanted to the present volume");
  const double factor = std::cbrt(volume / mesh.volume());
  std::vector<dvec3> vertices = mesh.vertices();
  for (dvec3& v : vertices) v = mesh.centroid() + factor * (v - mesh.centroid());
  return {std::move(vertices), mesh.faces()};
}

}  // namespace taxel
