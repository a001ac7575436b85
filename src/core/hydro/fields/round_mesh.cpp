// Tessellations of round shapes with the volume of the true shape.
//
// The vertices of a tessellation are on the round shape, so its volume is too small by the order of the edge squared,
// and so are forces, which are proportional to volume where the field is linear. Moving the vertices outward until the
// volume is right takes this error away. A cylinder and the middle of a capsule move across their axis only, so that
// their length stays exact; the caps of a capsule have a factor of their own, found by iterating, since they are curved
// in two directions and lose more.
#include "core/hydro/fields/round_mesh.h"

#include "core/mesh/make/primitives.h"
#include "core/mesh/ring_surface.h"

namespace taxel {
namespace {

/// Volume between some of the faces and the origin.
template <class Chosen>
double volume_below(const TriMesh& mesh, const Chosen& chosen) {
  double six = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (chosen(f)) six += glm::dot(mesh.vertex(f, 0), glm::cross(mesh.vertex(f, 1), mesh.vertex(f, 2)));
  }
  return six / 6.0;
}

/// Moves vertices away from the segment |z| <= half_length of the axis: by `side` if their z is within the segment, by
/// `cap` if it is outside.
TriMesh scaled_about_axis(const TriMesh& mesh, double half_length, double side, double cap) {
  std::vector<dvec3> vertices = mesh.vertices();
  for (dvec3& v : vertices) {
    const dvec3 axis(0, 0, std::clamp(v.z, -half_length, half_length));
    v = axis + (v.z == axis.z ? side : cap) * (v - axis);
  }
  return {std::move(vertices), mesh.faces()};
}

/// A mesh above z = 0 with its image below, joined where z is 0: both halves are cut into triangles alike.
TriMesh with_mirror_image(const TriMesh& upper) {
  std::vector<dvec3> vertices = upper.vertices();
  std::vector<int> image;
  for (int v = 0; v < upper.vertex_count(); ++v) {
    const dvec3& x = upper.vertices()[static_cast<std::size_t>(v)];
    image.push_back(x.z == 0 ? v : static_cast<int>(vertices.size()));
    if (x.z != 0) vertices.emplace_back(x.x, x.y, -x.z);
  }
  std::vector<ivec3> faces = upper.faces();
  const auto of = [&](int v) { return image[static_cast<std::size_t>(v)]; };
  for (const ivec3& f : upper.faces()) faces.emplace_back(of(f.x), of(f.z), of(f.y));
  return {std::move(vertices), std::move(faces)};
}

}  // namespace

TriMesh make_round_sphere(double radius, double edge_length) {
  return make_round_ellipsoid(dvec3(radius), edge_length);
}

TriMesh make_round_capsule(double radius, double half_length, double edge_length) {
  const TriMesh mesh = make_capsule(radius, half_length, edge_length);
  const auto in_cap = [&](int f) {
    return std::abs(mesh.vertex(f, 0).z + mesh.vertex(f, 1).z + mesh.vertex(f, 2).z) > 3 * half_length;
  };
  // The middle part is closed by the two discs that carry the caps.
  double disc = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (!in_cap(f)) continue;
    const auto i = static_cast<std::size_t>(f);
    disc += 0.5 * mesh.face_areas()[i] * std::abs(mesh.face_normals()[i].z);
  }
  const double middle = volume_below(mesh, [&](int f) { return !in_cap(f); }) + 2.0 * disc * half_length / 3.0;
  const double true_middle = 2.0 * kPi * radius * radius * half_length;
  const double true_caps = 4.0 / 3.0 * kPi * radius * radius * radius;
  const double side = std::sqrt(true_middle / middle);
  double cap = side;
  constexpr int kRounds = 20;  // the volume of the caps goes with about the cube of their factor: some rounds do
  for (int round = 0; round < kRounds; ++round) {
    const double volume = scaled_about_axis(mesh, half_length, side, cap).volume();
    cap *= std::cbrt(true_caps / (volume - true_middle));
  }
  return scaled_about_axis(mesh, half_length, side, cap);
}

TriMesh make_round_cylinder(double radius, double half_length, double edge_length) {
  const TriMesh mesh = make_cylinder(radius, half_length, edge_length);
  const double volume = 2.0 * kPi * radius * radius * half_length;
  return scaled_about_axis(mesh, half_length, std::sqrt(volume / mesh.volume()), 1);
}

TriMesh make_round_flat_cylinder(double radius, double half_length, double edge_length) {
  make_cylinder(radius, half_length, edge_length);                                // refuses sizes that cannot be
  const double core = radius - half_length, step = edge_length / std::sqrt(2.0);  // so that diagonals are short enough
  const auto pieces = [&](double length) { return std::max(1, static_cast<int>(std::ceil(length / step))); };
  const int discs = std::max(pieces(core), pieces(2.0 * kPi * radius / 6.0)), side = pieces(half_length);
  // The prism's base, a polygon of n corners on radius R', has the area n/2 R'^2 sin(2 pi/n) = pi R^2.
  const int n = 6 * discs;
  const double outer = radius * std::sqrt(2.0 * kPi / (n * std::sin(2.0 * kPi / n)));
  RingSurface upper;
  const auto add = [&](double r, double z, int count) {
    std::vector<dvec3> ring;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * kPi * i / count;
      ring.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
    upper.add_ring(ring);
  };
  for (int k = 0; k < side; ++k) add(outer, half_length * k / side, n);
  for (int k = side; k > 0; --k) add(core + (outer - core) * k / side, half_length, n);
  for (int k = discs; k >= 0; --k) add(core * k / discs, half_length, std::max(1, 6 * k));
  return with_mirror_image(upper.mesh());
}

TriMesh make_round_ellipsoid(const dvec3& semi_axes, double edge_length) {
  const double volume = 4.0 / 3.0 * kPi * semi_axes.x * semi_axes.y * semi_axes.z;
  return scaled_to_volume(make_ellipsoid(semi_axes, edge_length), volume);
}

}  // namespace taxel
