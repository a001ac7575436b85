// Round shapes by subdivision and by rings of points, height fields, and the fingertip.
//
// Balls and ellipsoids are icosahedra whose triangles are split into four at the middles of their edges, moved onto the
// sphere, until no edge is too long: nearly even triangles without poles. Cylinders and capsules are rings of points, 6
// k or 5 k of them in ring k of a cap, so that triangles are even there, too; the side is a prism. The step is reduced
// until no edge of the result is longer than asked for. Sizes that would give millions of triangles, as after a mistake
// in the unit, are refused first.
//
// A height field is cut as MuJoCo cuts it, from the lower row and column to the higher, and closed by sides and a flat
// base.
#include "core/mesh/make/primitives.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/base/math.h"
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

namespace {

void check(const HeightField& field) {
  if (field.rows < 2 || field.columns < 2)
    throw Error(fmt::format("a height field needs 2 rows and 2 columns, not {} x {}", field.rows, field.columns));
  const auto count = static_cast<std::size_t>(field.rows) * static_cast<std::size_t>(field.columns);
  if (field.elevation.size() != count)
    throw Error(fmt::format("{} elevations for {} x {} points", field.elevation.size(), field.rows, field.columns));
  for (const double size : {field.size.x, field.size.y, field.size.z, field.base}) {
    if (!(size > 0) || !std::isfinite(size))
      throw Error(fmt::format("sizes and base of a height field must be positive, not {}", size));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double height = field.elevation[i] * field.size.z;
    if (!std::isfinite(height) || !(height > -field.base))
      throw Error(fmt::format("elevation {} must be finite and above the base, is {}", i, field.elevation[i]));
  }
}

/// Returns the points of the grid's rim, counter-clockwise seen from above.
std::vector<int> rim_of(int rows, int columns) {
  std::vector<int> rim;
  for (int c = 0; c < columns; ++c) rim.push_back(c);
  for (int r = 1; r < rows; ++r) rim.push_back(r * columns + columns - 1);
  for (int c = columns - 2; c >= 0; --c) rim.push_back((rows - 1) * columns + c);
  for (int r = rows - 2; r > 0; --r) rim.push_back(r * columns);
  return rim;
}

}  // namespace

TriMesh make_height_field(const HeightField& field) {
  check(field);
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (int r = 0; r < field.rows; ++r) {
    for (int c = 0; c < field.columns; ++c) {
      const double height = field.elevation[static_cast<std::size_t>(r * field.columns + c)] * field.size.z;
      vertices.emplace_back(2 * field.size.x / (field.columns - 1) * c - field.size.x,
                            2 * field.size.y / (field.rows - 1) * r - field.size.y, height);
    }
  }
  for (int r = 0; r + 1 < field.rows; ++r) {
    for (int c = 0; c + 1 < field.columns; ++c) {
      const int low = r * field.columns + c, right = low + 1, up = low + field.columns, high = up + 1;
      faces.emplace_back(low, right, high);
      faces.emplace_back(low, high, up);
    }
  }
  const std::vector<int> rim = rim_of(field.rows, field.columns);
  const int foot = static_cast<int>(vertices.size()), count = static_cast<int>(rim.size()), middle = foot + count;
  for (const int i : rim) {
    const dvec3& top = vertices[static_cast<std::size_t>(i)];
    vertices.emplace_back(top.x, top.y, -field.base);
  }
  vertices.emplace_back(0, 0, -field.base);
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count, a = rim[static_cast<std::size_t>(i)], b = rim[static_cast<std::size_t>(next)];
    faces.emplace_back(foot + i, foot + next, b);
    faces.emplace_back(foot + i, b, a);
    faces.emplace_back(middle, foot + next, foot + i);
  }
  return {std::move(vertices), std::move(faces)};
}

// The project's own fingertip. The surface is a stack of superellipse sections
//
//   |x / a(z)|^q + |(y - y0) / b(z)|^q = 1,   a(z) = A sqrt(1 - (z/L)^m),
//
// with separate height b and exponents q, m for the pad (y < y0) and the nail side (y > y0): the sections shrink
// smoothly to the tip, which is round because of the square root. The parameters were fitted to the twelve taxel
// centres and normals published for the original finger (formats of the paper's sensor file): the surface is within
// 0.3 mm and 6 degrees of them. A rounded rim joins the flat base. Lengths here are in millimetres, those of the mesh
// in metres.

namespace {

constexpr double kLength = 30.5;      // L
constexpr double kCenterY = 0.9;      // y0
constexpr double kRimRadius = 1.5;    // radius between side and base
constexpr double kTargetEdge = 1.42;  // target edge length: about 2000 triangles

struct Axis {
  double size, power;  // A and m
};
constexpr Axis kSide{8.9, 6.0}, kPad{8.0, 4.4}, kNail{7.5, 3.0};
constexpr double kPadExponent = 2.1, kNailExponent = 2.5;  // q

/// One section across the finger.
struct Section {
  double side = 0, pad = 0, nail = 0;  // half widths
  double z = 0;
};

double half_width(const Axis& axis, double z) {
  return axis.size * std::sqrt(std::max(0.0, 1.0 - std::pow(z / kLength, axis.power)));
}

Section section_at(double z) {
  return {half_width(kSide, z), half_width(kPad, z), half_width(kNail, z), z};
}

Section shrunk(const Section& s, double by) {
  return {s.side - by, s.pad - by, s.nail - by, s.z};
}

/// The meridian in three stretches, each for u in [0, 1]: base disc from its centre, rounded rim, side up to the tip.
Section base_section(double u) {
  const Section rim = shrunk(section_at(0), kRimRadius);
  return {u * rim.side, u * rim.pad, u * rim.nail, 0};
}
Section rim_section(double u) {
  const double angle = 0.5 * kPi * u;
  return shrunk(section_at(kRimRadius * (1 - std::cos(angle))), kRimRadius * (1 - std::sin(angle)));
}
Section side_section(double u) {
  return section_at(kRimRadius + (kLength - kRimRadius) * std::sin(0.5 * kPi * u));
}

/// Returns the mean distance between two neighbouring sections over the side, pad and nail meridians.
double step_length(const Section& a, const Section& b) {
  const double dz = b.z - a.z;
  return (2 * std::hypot(b.side - a.side, dz) + std::hypot(b.pad - a.pad, dz) + std::hypot(b.nail - a.nail, dz)) / 4;
}

/// Returns the sections along one stretch without the first one, evenly spaced by mean arc length, at most about
/// `spacing` apart.
template <class Stretch>
std::vector<Section> evenly(const Stretch& stretch, double spacing) {
  constexpr int kSamples = 2000;
  std::vector<double> length(kSamples + 1, 0.0);
  for (int i = 1; i <= kSamples; ++i)
    length[at(i)] = length[at(i - 1)] + step_length(stretch(static_cast<double>(i - 1) / kSamples),
                                                    stretch(static_cast<double>(i) / kSamples));
  const int count = std::max(1, static_cast<int>(std::lround(length.back() / spacing)));
  std::vector<Section> sections;
  for (int k = 1, i = 0; k <= count; ++k) {
    const double wanted = length.back() * k / count;
    while (i + 1 < kSamples && length[at(i + 1)] < wanted) ++i;
    const double part = (wanted - length[at(i)]) / (length[at(i + 1)] - length[at(i)]);
    sections.push_back(stretch(k == count ? 1.0 : (i + part) / kSamples));
  }
  return sections;
}

/// Returns a point of the right half of a section. The angle is -pi/2 at the pad's ridge, 0 at the side, pi/2 on the
/// nail.
dvec3 section_point(const Section& s, double angle) {
  const double c = std::max(0.0, std::cos(angle)), n = std::sin(angle);
  const double power = 2.0 / (n < 0 ? kPadExponent : kNailExponent);
  const double height = n < 0 ? -s.pad * std::pow(-n, power) : s.nail * std::pow(n, power);
  return {s.side * std::pow(c, power), kCenterY + height, s.z};
}

/// Converts to metres on a grid of nanometres, so that coordinates are equal on every machine and short in a file.
dvec3 to_grid(const dvec3& p_mm) {
  return glm::round(p_mm * 1.0e6) / 1.0e9 + 0.0;
}

/// Returns points of the right half of a section, evenly spaced by arc length. The number of steps changes only if the
/// steps would differ too much from kTargetEdge: aligned rings make no valleys along the straight part.
std::vector<dvec3> half_ring(const Section& s, int& steps) {
  constexpr int kSamples = 2000;
  std::vector<dvec3> points(kSamples + 1);
  std::vector<double> length(kSamples + 1, 0.0);
  for (int i = 0; i <= kSamples; ++i) {
    points[at(i)] = section_point(s, kPi * (static_cast<double>(i) / kSamples - 0.5));
    if (i > 0) length[at(i)] = length[at(i - 1)] + glm::distance(points[at(i - 1)], points[at(i)]);
  }
  constexpr double kShortest = 0.8, kLongest = 1.1;  // smallest and largest edge length as a fraction of kTargetEdge
  const double step = length.back() / (steps * kTargetEdge);
  if (step < kShortest || step > kLongest)
    steps = std::max(3, static_cast<int>(std::lround(length.back() / kTargetEdge)));
  std::vector<dvec3> ring;
  for (int k = 0, i = 0; k <= steps; ++k) {
    const double wanted = length.back() * k / steps;
    while (i + 1 < kSamples && length[at(i + 1)] < wanted) ++i;
    const double part = std::clamp((wanted - length[at(i)]) / (length[at(i + 1)] - length[at(i)]), 0.0, 1.0);
    ring.push_back(to_grid(glm::mix(points[at(i)], points[at(i + 1)], part)));
  }
  ring.front().x = ring.back().x = 0;
  return ring;
}

}  // namespace

TriMesh make_fingertip() {
  const double spacing = kTargetEdge * std::sqrt(0.75);  // rows of equilateral triangles
  std::vector<Section> sections = evenly(base_section, spacing);
  for (const Section& s : evenly(rim_section, spacing)) sections.push_back(s);
  for (const Section& s : evenly(side_section, spacing)) sections.push_back(s);
  sections.pop_back();  // the tip, a point
  MirroredRingSurface surface;
  surface.add_half_ring({to_grid({0, kCenterY, 0})});
  int steps = 1;
  for (const Section& s : sections) surface.add_half_ring(half_ring(s, steps));
  surface.add_half_ring({to_grid({0, kCenterY, kLength})});
  return surface.mesh();
}

}  // namespace taxel
