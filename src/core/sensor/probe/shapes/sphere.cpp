#include "core/sensor/probe/probe.h"

namespace taxel {

ProbeForm ProbeSphere::body() const {
  constexpr double kEdge = 0.1;  // length of the edges of a tessellated sphere, relative to its radius
  check_probe_length(radius, "radius");
  ProbeForm form{{}, {0, 0, -radius}};
  form.shape.size = dvec3(radius);
  form.shape.resolution = kEdge * radius;
  return form;
}

}  // namespace taxel
