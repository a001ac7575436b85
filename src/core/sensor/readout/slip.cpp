#include "core/sensor/readout/slip.h"

#include "core/base/index.h"

namespace taxel {

void read_slip(const SensorModel& model, const FieldWeights& weights,
               std::span<const StickingFriction* const> frictions, std::vector<double>& slip) {
  slip.assign(at(model.taxel_count()), 0.0);
  std::vector<double> touched(slip.size(), 0.0);
  std::vector<int> discs;
  FieldWeights::AtPoint fields;
  for (const StickingFriction* friction : frictions) {
    if (friction == nullptr) continue;
    for (const StickingFriction::Root& root : friction->roots) {
      const SurfacePoint s = model.skin->closest_point(root.place);
      weights.near(s.position, 0, discs);
      weights.at(s.face, s.position, discs, fields);
      for (const FieldWeights::Weight& w : fields.weights) {
        touched[at(w.taxel)] += w.value * root.area;
        if (root.slips) slip[at(w.taxel)] += w.value * root.area;
      }
    }
  }
  for (std::size_t k = 0; k < slip.size(); ++k)
    if (touched[k] > 0) slip[k] /= touched[k];
}

}  // namespace taxel
