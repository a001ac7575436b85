// Fields of the medial axes of MuJoCo's primitives, and of stars.
//
// The depth of a point in a box, capsule or cylinder grows from the skin to the medial axis: a smaller box without
// extent in one direction, a segment, a disc. So each triangle of the skin and the points of the axis that its corners
// belong to are a prism, split into three tets, with p = 0 at the skin and p = E on the axis. The depth is linear on
// most of them, and its error is that of the tessellation. Prisms end in an edge or a point where corners share a point
// of the axis; such tets without volume are left out. The star of any mesh and the sphere are prisms that all end in
// one point.
//
// Pitfall: corners that belong to one point compute it with different rounding, and must get one number, or the tets
// would not share their faces. Points of a lattice of 1e-9 of the size are equal, and a point at the border of a cell
// looks into the next one. Theory: docs/theory/hydro.md, "Pressure fields".
#include <fmt/format.h>

#include <map>
#include <tuple>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/fields/round_mesh.h"
#include "core/hydro/fields/tet_geometry.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

/// A tet whose volume is less than this fraction of its skin edge cubed is flat: it is in the medial axis.
constexpr double kFlatVolume = 1e-9;

void require_modulus(double modulus) {
  if (!(modulus > 0) || !std::isfinite(modulus))
    throw Error(fmt::format("modulus of a soft body must be positive, not {}", modulus));
}

bool is_flat(const std::vector<dvec3>& x, const ivec4& t) {
  const dvec3& o = x[at(t[0])];
  const dvec3 a = x[at(t[1])] - o, b = x[at(t[2])] - o, c = x[at(t[3])] - o;
  const double size = std::max({glm::length(a), glm::length(b), glm::length(c)});
  return std::abs(glm::dot(glm::cross(a, b), c)) <= kFlatVolume * size * size * size;
}

/// Numbers the points of the medial axis. Points that differ by rounding alone have one number.
class AxisPoints {
 public:
  explicit AxisPoints(double size) : cell_(1e-9 * size) {}

  /// Returns the number of a point, counted from 0 in the order of first calls.
  int number(const dvec3& p) {
    // Roundings of one point are in one cell of the lattice, or in two cells if the point is at their border.
    const dvec3 u = p / cell_;
    constexpr double kBorder = 1e-3;
    for (int i = 0; i < 8; ++i) {
      const dvec3 side(i & 1 ? kBorder : -kBorder, i & 2 ? kBorder : -kBorder, i & 4 ? kBorder : -kBorder);
      const auto entry = numbers_.find(key(u + side));
      if (entry != numbers_.end()) return entry->second;
    }
    numbers_.emplace(key(u), static_cast<int>(points_.size()));
    points_.push_back(p);
    return static_cast<int>(points_.size()) - 1;
  }
  [[nodiscard]] const std::vector<dvec3>& points() const { return points_; }

 private:
  using Key = std::tuple<long long, long long, long long>;
  static Key key(const dvec3& u) { return {std::llround(u.x), std::llround(u.y), std::llround(u.z)}; }

  double cell_;
  std::map<Key, int> numbers_;
  std::vector<dvec3> points_;
};

/// Prisms from the skin, p = 0, to the points of the medial axis that its vertices belong to, p = E. Vertices that
/// belong to one point share it.
template <class AxisPoint>
PressureFieldPtr fill_to_axis(const TriMesh& skin, double modulus, const AxisPoint& axis_point) {
  require_modulus(modulus);
  std::vector<dvec3> vertices = skin.vertices();
  std::vector<int> inner;
  AxisPoints axis(skin.bounds().diagonal());
  for (const dvec3& v : skin.vertices()) inner.push_back(skin.vertex_count() + axis.number(axis_point(v) + 0.0));
  vertices.insert(vertices.end(), axis.points().begin(), axis.points().end());
  std::vector<double> pressure(vertices.size(), modulus);
  std::fill_n(pressure.begin(), skin.vertices().size(), 0.0);
  std::vector<ivec4> tets;
  for (const ivec3& f : skin.faces()) {
    const ivec3 on_axis(inner[at(f.x)], inner[at(f.y)], inner[at(f.z)]);
    const PrismTets prism = split_prism(f, on_axis, on_axis);
    for (int i = 0; i < prism.count; ++i) {
      if (!is_flat(vertices, prism.tets[at(i)])) tets.push_back(prism.tets[at(i)]);
    }
  }
  return std::make_shared<const PressureField>(std::move(vertices), std::move(tets), std::move(pressure),
                                               FieldReport{});
}

}  // namespace

PressureFieldPtr make_box_field(const dvec3& half_size, double modulus) {
  const dvec3 core = half_size - std::min({half_size.x, half_size.y, half_size.z});
  return fill_to_axis(make_box(half_size), modulus, [&](const dvec3& v) { return glm::clamp(v, -core, core); });
}

PressureFieldPtr make_capsule_field(double radius, double half_length, double modulus, double edge_length) {
  const TriMesh skin = make_round_capsule(radius, half_length, edge_length);
  return fill_to_axis(skin, modulus,
                      [&](const dvec3& v) { return dvec3(0, 0, std::clamp(v.z, -half_length, half_length)); });
}

PressureFieldPtr make_cylinder_field(double radius, double half_length, double modulus, double edge_length) {
  if (!(radius > half_length)) {  // the axis is a segment
    const double core = half_length - radius;
    return fill_to_axis(make_round_cylinder(radius, half_length, edge_length), modulus,
                        [&](const dvec3& v) { return dvec3(0, 0, std::clamp(v.z, -core, core)); });
  }
  const double core = radius - half_length;  // a disc
  return fill_to_axis(make_round_flat_cylinder(radius, half_length, edge_length), modulus, [&](const dvec3& v) {
    const double r = std::hypot(v.x, v.y), shrink = r > core ? core / r : 1.0;
    return dvec3(shrink * v.x, shrink * v.y, 0);
  });
}

PressureFieldPtr make_ellipsoid_field(const dvec3& semi_axes, double modulus, double edge_length) {
  const TriMesh skin = make_round_ellipsoid(semi_axes, edge_length);
  return fill_to_axis(skin, modulus, [](const dvec3&) { return dvec3(0); });
}

namespace {

void require_positive(double value, const char* what) {
  if (!(value > 0) || !std::isfinite(value)) throw Error(fmt::format("{} must be positive, not {}", what, value));
}

/// Tets from `center`, where p = modulus, to every face, where p = 0.
PressureFieldPtr make_cone_field(const TriMesh& mesh, const dvec3& center, double modulus) {
  std::vector<dvec3> vertices = mesh.vertices();
  std::vector<double> pressure(vertices.size(), 0.0);
  const int apex = static_cast<int>(vertices.size());
  vertices.push_back(center);
  pressure.push_back(modulus);
  std::vector<ivec4> tets;
  tets.reserve(mesh.faces().size());
  int flat = 0;
  for (const ivec3& f : mesh.faces()) {
    const dvec3 &a = vertices[static_cast<std::size_t>(f.x)], &b = vertices[static_cast<std::size_t>(f.y)];
    const dvec3& c = vertices[static_cast<std::size_t>(f.z)];
    if (glm::dot(glm::cross(b - a, c - a), center - a) == 0) {
      ++flat;
      continue;
    }
    tets.push_back({f.x, f.z, f.y, apex});  // the face's normal points away from the apex
  }
  FieldReport report;
  if (flat > 0)
    report.notes.push_back(fmt::format("{} faces lie in a plane through the centroid and have no tet", flat));
  auto field =
      std::make_shared<PressureField>(std::move(vertices), std::move(tets), std::move(pressure), std::move(report));
  return field;
}

}  // namespace

PressureFieldPtr make_star_field(const TriMeshPtr& mesh, double modulus) {
  require_positive(modulus, "modulus of a star field");
  if (!mesh->closed()) throw Error("a star field needs a closed mesh; this one is open: " + openings(*mesh));
  return make_cone_field(*mesh, mesh->centroid(), modulus);
}

PressureFieldPtr make_sphere_field(double radius, double modulus, double edge_length) {
  require_positive(radius, "radius of a soft sphere");
  require_positive(modulus, "modulus of a soft sphere");
  return make_cone_field(make_round_sphere(radius, edge_length), dvec3(0), modulus);
}

}  // namespace taxel
