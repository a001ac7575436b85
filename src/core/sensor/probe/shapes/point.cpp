#include "core/sensor/probe/probe.h"

namespace taxel {

ProbeForm ProbePoint::body() const {
  constexpr int kSides = 48;
  constexpr double kTurn = 2 * kPi / kSides;
  check_probe_length(height, "height");
  // A polygon with the area of the circle: the volume up to any height is that of the round cone.
  const double radius = height * half_slope(angle_deg) * std::sqrt(kTurn / std::sin(kTurn));
  std::vector<dvec3> vertices{dvec3(0), {0, 0, height}};
  std::vector<ivec3> faces;
  for (int i = 0; i < kSides; ++i) {
    vertices.emplace_back(radius * std::cos(i * kTurn), radius * std::sin(i * kTurn), height);
    const int a = 2 + i, b = 2 + (i + 1) % kSides;
    faces.emplace_back(0, b, a);
    faces.emplace_back(1, a, b);
  }
  return {mesh_shape(std::make_shared<const TriMesh>(std::move(vertices), std::move(faces))), dvec3(0)};
}

}  // namespace taxel
