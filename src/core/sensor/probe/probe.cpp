#include "core/sensor/probe/probe.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/hydro/fields/round_mesh.h"
#include "core/layout/sensor_frame.h"

namespace taxel {

Shape mesh_shape(TriMeshPtr mesh) {
  Shape shape;
  shape.type = ShapeType::mesh;
  shape.mesh = std::move(mesh);
  return shape;
}

void refuse_probe(const std::string& message) {
  throw Error("", "probe", message);
}

void check_probe_length(double value, const char* name) {
  if (!(value > 0) || !std::isfinite(value)) refuse_probe(fmt::format("{} must be greater than 0, is {}", name, value));
}

double half_slope(double angle_deg) {
  if (!(angle_deg > 0 && angle_deg < 180))
    refuse_probe(fmt::format("angle must be greater than 0 and less than 180 degrees, is {}", angle_deg));
  return std::tan(0.5 * angle_deg * kPi / 180);
}

namespace {

constexpr const char* kName = "probe";

ProbePress::Body make_probe_body(const ProbeShape& shape, const Material& material) {
  const ProbeForm form = std::visit([](const auto& one) { return one.body(); }, shape);
  const Shape& of_body = form.shape;
  return {make_body(of_body, material, kName),
          of_body.mesh ? of_body.mesh
                       : std::make_shared<const TriMesh>(make_round_sphere(of_body.size.x, of_body.resolution)),
          form.tip};
}

void check_place(const Probe& probe) {
  if (!(probe.depth >= 0) || !std::isfinite(probe.depth))
    refuse_probe(fmt::format("depth must be 0 or more, is {}", probe.depth));
  if (!std::isfinite(probe.roll_deg)) refuse_probe(fmt::format("roll must be a finite angle, is {}", probe.roll_deg));
  if (!is_finite(probe.point)) refuse_probe("point must be finite");
}

/// Returns the unit direction of the push at a point of the skin.
dvec3 push_direction(const Probe& probe, const dvec3& normal) {
  if (!probe.direction) return -normal;
  const dvec3& d = *probe.direction;
  const double length = glm::length(d);
  if (!(length > 0) || !std::isfinite(length))
    refuse_probe(fmt::format("direction must be finite and not zero, is {}, {}, {}", d.x, d.y, d.z));
  if (!(glm::dot(d, normal) < 0)) refuse_probe("direction must lead into the skin, which faces the same way there");
  return d / length;
}

/// Returns the pose X_MP of the probe, with its tip at the full depth.
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
  if (!model.body) throw Error("the mesh has no pressure field yet: add a taxel, or decimate the mesh");
  if (!model.body->soft() && !probe.material.compliant())
    refuse_probe("modulus must be greater than 0 on a sensor that is rigid itself, is 0");
  const ProbePress::Body made =
      out.bodies.get({probe.shape, probe.material}, [&] { return make_probe_body(probe.shape, probe.material); });
  out.X_MP = X_MP;
  out.mesh = made.mesh;
  out.X_MG = X_MP * Pose{{1, 0, 0, 0}, -made.tip};
  out.surface.clear();
  // The facets of round shapes are slightly outside of the exact shape and must not touch at depth 0.
  if (probe.depth > 0) intersect(*model.body, *made.body, Pose{}, out.X_MG, out.surface, out.workspace);
  out.wrench = pressure_wrench(out.surface);
  const ContactSurface* const surfaces[] = {&out.surface};
  read_sensor(model, surfaces, out.reading);
}

}  // namespace taxel
