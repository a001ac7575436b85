#include "app/studio/features/measure/measure.h"

#include <cmath>
#include <limits>

#include "core/mesh/geodesic/geodesic_path.h"

namespace taxel::studio {

namespace {

constexpr double kFirstRadius = 1.2, kGrowth = 2.0;  // of the straight distance; from one try to the next
constexpr double kLongest = 16;                      // of the mesh's diagonal: then all of it is tried

}  // namespace

/// Propagates no farther than it must: from the straight distance on, until the target is reached.
ui::MeasuredPtr MeasureWorker::measure(const ui::MeasureRequest& request) {
  if (skin_ != request.skin) {
    skin_ = request.skin;
    unfolded_ = std::make_shared<const UnfoldedMesh>(skin_->mesh_ptr());
    distance_ = std::make_unique<GeodesicDistance>(unfolded_);
  }
  auto out = std::make_shared<ui::Measured>();
  out->request = request;
  out->straight = glm::distance(request.a, request.b);
  const SurfacePoint a = skin_->closest_point(request.a), b = skin_->closest_point(request.b);
  const double longest = kLongest * skin_->mesh().bounds().diagonal();
  double radius = kFirstRadius * glm::distance(a.position, b.position);
  if (!(radius > 0)) {
    out->along = 0;
    return out;
  }
  while (true) {
    distance_->propagate(a.face, a.position, radius);
    out->along = distance_->to(b.face, b.position);
    if (std::isfinite(out->along) || std::isinf(radius)) break;
    radius = radius < longest ? kGrowth * radius : std::numeric_limits<double>::infinity();
  }
  out->path = geodesic_path(*unfolded_, *distance_, a.position, b.face, b.position);
  return out;
}

}  // namespace taxel::studio
