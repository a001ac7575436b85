#include "core/sensor/probe/shapes/probe_form.h"

#include <fmt/format.h>

#include "core/base/error.h"

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

}  // namespace taxel
