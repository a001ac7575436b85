#include "app/studio/nouns/inspector/model_summary.h"

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"

namespace taxel::ui {

ModelSummary summarize(const SensorModelPtr& model) {
  ModelSummary summary;
  summary.model = model;
  if (!model) return summary;
  summary.skin_area = model->skin->mesh().area();
  for (std::size_t i = 0; i < model->samples.size(); ++i) {
    const std::size_t taxels = i < model->taxels_of_sample.size() ? model->taxels_of_sample[i].size() : 0;
    if (taxels > 0) {
      ++summary.used_samples;
      summary.used_area += model->samples[i].area;
    }
    if (taxels > 1) ++summary.shared_samples;
  }
  for (int k = 0; k < model->taxel_count(); ++k) {
    const auto row = static_cast<std::size_t>(k);
    const Taxel& taxel = model->layout.taxels[row];
    const SurfacePoint nearest = model->skin->closest_point(taxel.center);
    const dvec3& skin_normal = model->skin->mesh().face_normals()[static_cast<std::size_t>(nearest.face)];
    summary.samples_of_taxel.push_back(model->fields.first[row + 1] - model->fields.first[row]);
    summary.distance_to_skin.push_back(nearest.distance);
    summary.angle_to_skin_deg.push_back(angle_deg(taxel.normal, skin_normal));
  }
  return summary;
}

}  // namespace taxel::ui
