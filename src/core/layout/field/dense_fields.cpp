#include "core/layout/field/dense_fields.h"

#include <algorithm>

#include "core/layout/field/field_disc.h"

namespace taxel {
namespace {

/// Least cosine between the normals of a taxel and of a face with its density. Constants, because a computed cosine
/// differs between machines. The first one lets a field end at the angle limit without a change of the density there,
/// and leaves out the opposite wall.
constexpr double kFrontSide = -0.1, kAllSides = -2.0;
constexpr double kWideAngle = 70.0;  // limit of the angle up to which the front side is enough [degrees]

}  // namespace

double uniform_samples(const Layout& layout, std::size_t count, double area) {
  const bool any_dense = std::any_of(layout.taxels.begin(), layout.taxels.end(),
                                     [&](const Taxel& taxel) { return is_dense(taxel, layout.sampling); });
  return any_dense ? static_cast<double>(sample_count(layout.sampling.density, area)) : static_cast<double>(count);
}

std::vector<DenseDisc> dense_fields(const Layout& layout, const MeshIndex& skin) {
  std::vector<DenseDisc> dense;
  const ReceptiveFieldRule& rule = layout.receptive_field;
  for (const Taxel& taxel : layout.taxels) {
    if (!is_dense(taxel, layout.sampling)) continue;
    for (const FieldDisc& disc : discs_of(taxel)) {
      const dvec3 center = rule.metric == Metric::geodesic ? skin.closest_point(disc.center).position : disc.center;
      dense.push_back(
          {center, disc.normal, disc.radius, rule.max_angle_deg <= kWideAngle ? kFrontSide : kAllSides, taxel.density});
    }
  }
  return dense;
}

void multiply_densities(Layout& layout, double factor) {
  layout.sampling.density *= factor;
  for (Taxel& taxel : layout.taxels) taxel.density *= factor;
}

}  // namespace taxel
