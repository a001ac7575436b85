#include "core/sensor/probe/probe.h"

namespace taxel {

ProbeForm ProbeEdge::body() const {
  check_probe_length(length, "length");
  check_probe_length(height, "height");
  const double x = 0.5 * length, z = height, y = z * half_slope(angle_deg);
  return {
      mesh_shape(std::make_shared<const TriMesh>(
          std::vector<dvec3>{{-x, 0, 0}, {x, 0, 0}, {-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}},
          std::vector<ivec3>{{0, 3, 2}, {0, 1, 3}, {0, 5, 4}, {0, 4, 1}, {2, 3, 4}, {2, 4, 5}, {0, 2, 5}, {1, 4, 3}})),
      dvec3(0)};
}

}  // namespace taxel
