#include "ui/scene/sample_use.h"

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"

namespace taxel::ui {
namespace {

/// Returns the normal with which a sample at `p` is compared: that of the taxel, or of the subtaxel with the smallest
/// Euclidean distance.
dvec3 normal_for(const Taxel& taxel, const dvec3& p) {
  const auto nearer = [&](const Subtaxel& a, const Subtaxel& b) {
    return glm::distance(a.center, p) < glm::distance(b.center, p);
  };
  const auto best = std::min_element(taxel.subtaxels.begin(), taxel.subtaxels.end(), nearer);
  return glm::normalize(best == taxel.subtaxels.end() ? taxel.normal : best->normal);
}

}  // namespace

std::vector<SampleUse> uses_of_sample(const SensorModel& model, int sample) {
  std::vector<SampleUse> uses;
  const SurfaceSample& at = model.samples[static_cast<std::size_t>(sample)];
  for (const int k : model.taxels_of_sample[static_cast<std::size_t>(sample)]) {
    const auto row = static_cast<std::size_t>(k);
    const auto begin = model.fields.entries.begin() + model.fields.first[row];
    const auto end = model.fields.entries.begin() + model.fields.first[row + 1];
    const auto entry = std::lower_bound(begin, end, sample, [](const auto& e, int s) { return e.sample < s; });
    if (entry == end || entry->sample != sample) continue;
    const double angle = angle_deg(at.normal, normal_for(model.layout.taxels[row], at.position));
    uses.push_back({k, entry->distance, angle, entry->weight});
  }
  return uses;
}

}  // namespace taxel::ui
