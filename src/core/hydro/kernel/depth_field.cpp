#include "core/hydro/kernel/depth_field.h"

namespace taxel {
namespace {

DepthField::Sample sample_of(const dvec3& x, const SignedPoint& nearest, const TriMesh& skin) {
  const double distance = nearest.signed_distance;
  const dvec3 from = x - nearest.point.position;
  // On the skin itself the direction to the nearest point has no digits left.
  const double on_skin = 1e-9 * skin.bounds().diagonal();
  if (!(std::abs(distance) > on_skin))
    return {-distance, -skin.face_normals()[static_cast<std::size_t>(nearest.point.face)]};
  return {-distance, from / -distance};
}

}  // namespace

const MeshIndex& DepthField::index() const {
  std::call_once(built_, [this] { index_ = std::make_unique<const MeshIndex>(skin_); });
  return *index_;
}

NearFaces DepthField::near_faces() const {
  constexpr double kCell = 0.125;  // of the thickness
  return {index(), kCell * thickness_};
}

DepthField::Sample DepthField::at(const dvec3& x, double within) const {
  SignedPoint nearest = index().signed_point(x, within);
  if (nearest.point.face < 0) nearest = index().signed_point(x);  // a bound that rounding made too small
  return sample_of(x, nearest, *skin_);
}

DepthField::Sample DepthField::at(const dvec3& x, NearFaces& near) {
  return sample_of(x, near.index().with_sign(x, near.closest_point(x)), near.index().mesh());
}

}  // namespace taxel
