// Marks of the rays of a reading.
#include "ui/scene/marks/marks.h"

namespace taxel::ui {
namespace {

constexpr int kMaxHits = 700, kMaxSelectedHits = 350, kMaxMisses = 250;
constexpr double kMinRaySpacing = 1.0;  // smallest distance of rays [pixel]; closer rays cover each other
constexpr double kMissedRayPart = 0.3;  // length of a miss as a fraction of the allowed depth
constexpr float kHitWidth = 1.1f, kMissWidth = 1.0f;

/// Spreads ray numbers evenly over 32 bits, so that the rays below a power of two are a spread-out subset
/// (Knuth 6.4, multiplicative hashing with the golden ratio).
std::uint32_t spread(int ray) {
  return (static_cast<std::uint32_t>(ray) * 2654435769u) >> 8;
}

/// Returns the smallest power of two by which `count` rays must be thinned to stay below `most`, as a mask.
std::uint32_t thinning_mask(int count, int most) {
  std::uint32_t step = 1;
  while (count / static_cast<int>(step) > most) step *= 2;
  return step - 1;
}

/// Returns how many of `count` rays are far enough apart, at most `most`.
int most_shown(int count, double spacing, int most) {
  return std::clamp(static_cast<int>(std::ceil(part_apart(spacing, kMinRaySpacing) * count)), 1, most);
}

std::vector<char> wanted_rays(const SensorView& view, bool all) {
  const SensorModel& model = *view.model;
  std::vector<char> wanted(model.rays.size(), all ? 1 : 0);
  if (all) return wanted;
  for (int k = 0; k < model.fields.taxel_count(); ++k) {
    const auto index = static_cast<std::size_t>(k);
    const bool responds = index < view.state->readings.size() && view.state->readings[index] > 0;
    if (view.selected_taxel >= 0 ? k != view.selected_taxel : !responds) continue;
    for (int e = model.fields.first[index]; e < model.fields.first[index + 1]; ++e) {
      wanted[static_cast<std::size_t>(model.readout_table.ray_of_entry[static_cast<std::size_t>(e)])] = 1;
    }
  }
  return wanted;
}

}  // namespace

RayMarks ray_marks(const SensorView& view, bool all, const PressureRange& range, const Look& look, double spacing) {
  RayMarks out;
  if (view.state == nullptr || view.state->hits.size() != view.model->rays.size()) return out;
  const std::vector<char> wanted = wanted_rays(view, all);
  const std::vector<RayHit>& hits = view.state->hits;
  int hit_count = 0, miss_count = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i] != 0) ++(hits[i].surface >= 0 ? hit_count : miss_count);
  }
  const int most_hits = view.selected_taxel >= 0 && !all ? kMaxSelectedHits : kMaxHits;
  const std::uint32_t hit_mask = thinning_mask(hit_count, most_shown(hit_count, spacing, most_hits)),
                      miss_mask = thinning_mask(miss_count, most_shown(miss_count, spacing, kMaxMisses));
  const std::uint32_t hit_color = pack(look.ray_hit), miss_color = pack(look.ray_miss);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const bool hit = hits[i].surface >= 0;
    if (wanted[i] == 0 || (spread(static_cast<int>(i)) & (hit ? hit_mask : miss_mask)) != 0) continue;
    const SensorRay& ray = view.model->rays[i];
    if (!hit) {
      const dvec3 end = ray.origin + kMissedRayPart * ray.max_depth * ray.direction;
      out.misses.push_back(segment(ray.origin, end, kMissWidth, miss_color));
      continue;
    }
    const dvec3 end = ray.origin + hits[i].depth * ray.direction;
    out.hits.push_back(segment(ray.origin, end, kHitWidth, hit_color));
    out.dots.push_back(point_mark(end, dvec3(0), 1.0, pack(range.color(hits[i].pressure))));
  }
  return out;
}

}  // namespace taxel::ui
