#include "core/sensor/probe/probe.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/hydro/fields/round_mesh.h"
#include "core/layout/tangent_frame.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

constexpr const char* kName = "probe";
constexpr double kSphereEdge = 0.1;  // length of the edges of a tessellated sphere, parts of its radius

[[noreturn]] void refuse(const std::string& message) {
  throw Error("", kName, message);
}

void check_length(double value, const char* what) {
  if (!(value > 0) || !std::isfinite(value)) refuse(fmt::format("{} must be greater than 0, is {}", what, value));
}

void check_angle(double degrees) {
  if (!(degrees > 0 && degrees < 180))
    refuse(fmt::format("angle must be greater than 0 and less than 180 degrees, is {}", degrees));
}

/// Half of an opening angle, as a slope.
double half_slope(double angle_deg) {
  return std::tan(0.5 * angle_deg * kPi / 180);
}

TriMeshPtr make_wedge(const ProbeEdge& edge) {
  const double x = 0.5 * edge.length, z = edge.height, y = z * half_slope(edge.angle_deg);
  return std::make_shared<const TriMesh>(
      std::vector<dvec3>{{-x, 0, 0}, {x, 0, 0}, {-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}},
      std::vector<ivec3>{{0, 3, 2}, {0, 1, 3}, {0, 5, 4}, {0, 4, 1}, {2, 3, 4}, {2, 4, 5}, {0, 2, 5}, {1, 4, 3}});
}

TriMeshPtr make_cone(const ProbePoint& point) {
  constexpr int kSides = 48;
  constexpr double kTurn = 2 * kPi / kSides;
  // A polygon of the circle's area: the volume up to any height is the cone's.
  const double radius = point.height * half_slope(point.angle_deg) * std::sqrt(kTurn / std::sin(kTurn));
  std::vector<dvec3> vertices{dvec3(0), {0, 0, point.height}};
  std::vector<ivec3> faces;
  for (int i = 0; i < kSides; ++i) {
    vertices.emplace_back(radius * std::cos(i * kTurn), radius * std::sin(i * kTurn), point.height);
    const int a = 2 + i, b = 2 + (i + 1) % kSides;
    faces.emplace_back(0, b, a);
    faces.emplace_back(1, a, b);
  }
  return std::make_shared<const TriMesh>(std::move(vertices), std::move(faces));
}

/// The middle of the box around the lowest vertices, which does not depend on how a flat end is cut into triangles.
dvec3 tip_of(const TriMesh& mesh) {
  const double flat = 1e-9 * mesh.bounds().diagonal();
  Aabb lowest;
  for (const dvec3& v : mesh.vertices())
    if (v.z <= mesh.bounds().lo.z + flat) lowest.include(v);
  return {lowest.center().x, lowest.center().y, mesh.bounds().lo.z};
}

Shape of_mesh(TriMeshPtr mesh) {
  Shape shape;
  shape.type = ShapeType::mesh;
  shape.mesh = std::move(mesh);
  return shape;
}

/// A probe presses with a solid, rigid or soft.
TriMeshPtr repaired_probe(const TriMeshPtr& mesh) {
  try {
    const TriMeshPtr solid = repair_mesh(mesh, {}, 0)->mesh;
    if (!solid->closed()) refuse("the mesh must be closed: " + openings(*solid));
    return solid;
  } catch (const Error& e) {
    refuse(e.message());
  }
}

/// A shape in its own frame, and its tip there. One overload per kind of probe.
struct MakeShape {
  dvec3& tip;

  Shape operator()(const ProbeSphere& sphere) const {
    check_length(sphere.radius, "radius");
    tip = {0, 0, -sphere.radius};
    Shape shape;
    shape.size = dvec3(sphere.radius);
    shape.resolution = kSphereEdge * sphere.radius;
    return shape;
  }
  Shape operator()(const ProbeEdge& edge) const {
    check_length(edge.length, "length");
    check_length(edge.height, "height");
    check_angle(edge.angle_deg);
    return of_mesh(make_wedge(edge));
  }
  Shape operator()(const ProbePoint& point) const {
    check_length(point.height, "height");
    check_angle(point.angle_deg);
    return of_mesh(make_cone(point));
  }
  Shape operator()(const ProbeMesh& probe) const {
    if (probe.mesh == nullptr || probe.mesh->face_count() == 0) refuse("the mesh has no triangles");
    const TriMeshPtr solid = repaired_probe(probe.mesh);
    tip = tip_of(*solid);
    return of_mesh(solid);
  }
};

ProbePress::Body make_probe_body(const ProbeShape& shape, const Material& material) {
  ProbePress::Body made;
  const Shape of_body = std::visit(MakeShape{made.tip}, shape);
  made.body = make_body(of_body, material, kName);
  made.mesh = of_body.mesh ? of_body.mesh
                           : std::make_shared<const TriMesh>(make_round_sphere(of_body.size.x, of_body.resolution));
  return made;
}

void check_place(const Probe& probe) {
  if (!(probe.depth >= 0) || !std::isfinite(probe.depth))
    refuse(fmt::format("depth must be 0 or more, is {}", probe.depth));
  if (!std::isfinite(probe.roll_deg)) refuse(fmt::format("roll must be a finite angle, is {}", probe.roll_deg));
  if (!is_finite(probe.point)) refuse("point must be finite");
}

/// The unit direction of the push at a point of the skin.
dvec3 push_direction(const Probe& probe, const dvec3& normal) {
  if (!probe.direction) return -normal;
  const dvec3& d = *probe.direction;
  const double length = glm::length(d);
  if (!(length > 0) || !std::isfinite(length))
    refuse(fmt::format("direction must be finite and not zero, is {}, {}, {}", d.x, d.y, d.z));
  if (!(glm::dot(d, normal) < 0)) refuse("direction must lead into the skin, which faces the same way there");
  return d / length;
}

/// The pose of the probe's frame, its tip at the full depth.
Pose place(const SensorModel& model, const Probe& probe) {
  check_place(probe);
  const SurfacePoint at = model.skin->closest_point(probe.point);
  const dvec3 down = push_direction(probe, model.skin->mesh().face_normals()[static_cast<std::size_t>(at.face)]);
  const TangentFrame tangents = tangent_frame(model.layout.frame, -down);
  const dquat unrolled = glm::quat_cast(dmat3(tangents.e1, tangents.e2, -down));
  const dquat roll = glm::angleAxis(probe.roll_deg * kPi / 180, dvec3(0, 0, 1));
  return {glm::normalize(unrolled * roll), at.position + probe.depth * down};
}

}  // namespace

void press(const SensorModel& model, const Probe& probe, ProbePress& out) {
  const Pose X_MP = place(model, probe);
  if (!model.body->soft() && !probe.material.compliant())
    refuse("modulus must be greater than 0 on a sensor that is rigid itself, is 0");
  const ProbePress::Body made =
      out.bodies.get({probe.shape, probe.material}, [&] { return make_probe_body(probe.shape, probe.material); });
  out.X_MP = X_MP;
  out.mesh = made.mesh;
  out.X_MG = X_MP * Pose{{1, 0, 0, 0}, -made.tip};
  out.surface.clear();
  // The facets of round shapes reach a little over what they stand for, which must not be felt at depth 0.
  if (probe.depth > 0) intersect(*model.body, *made.body, Pose{}, out.X_MG, out.surface, out.workspace);
  out.wrench = pressure_wrench(out.surface);
  const ContactSurface* const surfaces[] = {&out.surface};
  read_sensor(model, surfaces, out.reading);
}

}  // namespace taxel
