#include "app/validate/flat_patch.h"

#include "core/mesh/make/primitives.h"

namespace taxel {

Layout FlatPatch::layout(double samples, std::uint64_t seed, SampleWeights weights) {
  Layout layout;
  layout.mesh.file = "plate";
  layout.sampling.density = samples / (kPi * kRadius * kRadius);
  layout.sampling.seed = seed;
  layout.sampling.weights = weights;
  layout.material.thickness = 0.8 * kThickness;
  layout.readout.max_depth = kThickness;
  for (int j = -3; j <= 3; ++j) {
    for (int i = -3; i <= 3; ++i) {
      Taxel taxel;
      taxel.id = static_cast<int>(layout.taxels.size());
      taxel.center = dvec3(0.00201 * i, 0.00203 * j, 0.5 * kThickness);
      taxel.radius = kRadius;
      layout.taxels.push_back(taxel);
    }
  }
  return layout;
}

SensorModelPtr FlatPatch::model(const Layout& layout) {
  const auto plate = std::make_shared<TriMesh>(make_box(dvec3(kHalf, kHalf, 0.5 * kThickness)));
  return build_sensor_model(layout, plate, "", "plate");
}

}  // namespace taxel
