#include "ui/scene/taxels/disc_marks.h"

#include <algorithm>
#include <string_view>

#include "core/layout/words.h"
#include "ui/scene/scene_cast.h"
#include "ui/scene/taxels/marked_taxels.h"

namespace taxel::ui {
namespace {

/// Returns whether the range of the readings, which is in the unit of the selected sensor, is valid for a sensor.
bool has_unit_of_range(const SceneInput& input, const std::vector<SensorView>& views, const SensorView& view) {
  const auto unit = [](const SensorView& of) {
    return std::string_view(reading_unit(of.model->layout.readout.aggregate));
  };
  return std::all_of(views.begin(), views.end(), [&](const SensorView& other) {
    return other.index != input.selected_sensor || unit(other) == unit(view);
  });
}

bool is_behind_another(const std::vector<SensorView>& views, const SensorView& view, int taxel, const dvec3& eye_W) {
  const Taxel& t = view.model->layout.taxels[static_cast<std::size_t>(taxel)];
  const dvec3 p_W = view.X_WM * (t.center + kSightLift * t.radius * glm::normalize(t.normal));
  const double distance = glm::length(p_W - eye_W);
  const Ray ray{eye_W, (p_W - eye_W) / distance, distance};
  return std::any_of(views.begin(), views.end(), [&](const SensorView& other) {
    return other.index != view.index && other.model->skin->cast(in_frame(other.X_WM, ray)).has_value();
  });
}

}  // namespace

DiscMarks disc_marks(const SceneInput& input, const std::vector<SensorView>& views, const SensorView& view,
                     const dvec3& eye_W, float dim) {
  DiscMarks out;
  const Overlays& show = input.overlays;
  if (!show.receptive_fields || !show.reading_discs || view.state == nullptr || !(input.reading_range.hi > 0))
    return out;
  const SensorFields* fields = input.fields ? input.fields->of(view.model) : nullptr;
  if (fields == nullptr || !fields->discs || !has_unit_of_range(input, views, view)) return out;
  const std::vector<double>& readings = view.state->readings;
  std::vector<int> order;
  for (int k = 0; k < view.model->taxel_count() && k < static_cast<int>(readings.size()); ++k)
    if (readings[static_cast<std::size_t>(k)] > 0 && !view.hidden(k)) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return readings[static_cast<std::size_t>(a)] < readings[static_cast<std::size_t>(b)];
  });
  for (const int k : order) {
    const double reading = readings[static_cast<std::size_t>(k)];
    const bool behind = views.size() > 1 && is_behind_another(views, view, k, eye_W);
    append_disc(*fields->discs, k, input.reading_range.color(reading), reading / input.reading_range.hi,
                behind ? dim : 1.0f, out.triangles);
  }
  out.discs = static_cast<int>(order.size());
  return out;
}

}  // namespace taxel::ui
