#include "app/studio/frame/sensors_shown.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace taxel::ui {

std::vector<SensorShown> sensors_shown(const RunView& run) {
  std::vector<SensorShown> sensors;
  if (!run.frame || !run.frame->scene) return sensors;
  const SimScene& scene = *run.frame->scene;
  std::size_t first = 0;
  for (std::size_t i = 0; i < run.frame->sensors.size() && i < scene.sensors.size(); ++i) {
    const SensorStep& step = run.frame->sensors[i];
    const SensorModelPtr& model = scene.sensors[i];
    const std::size_t begin = first;
    first += step.readings.size();
    if (!model || model->layout.taxels.empty()) continue;
    const std::string name = i < scene.sensor_geoms.size() && !scene.sensor_geoms[i].empty()
                                 ? scene.sensor_geoms[i]
                                 : fmt::format("sensor {}", i);
    sensors.push_back({static_cast<int>(i), begin, name, model, &step, shown_unit(model->layout.readout.aggregate)});
  }
  return sensors;
}

std::string taxel_label(const std::vector<SensorShown>& sensors, const SensorShown& sensor, int id) {
  return sensors.size() > 1 ? fmt::format("{} {}", sensor.name, id) : std::to_string(id);
}

bool same_unit(const ReadingUnit& a, const ReadingUnit& b) {
  return std::strcmp(a.text, b.text) == 0;
}

ReadingUnit selected_unit(const std::vector<SensorShown>& sensors, const Selection& selection) {
  for (const SensorShown& sensor : sensors)
    if (sensor.index == selection.sensor) return sensor.unit;
  return sensors.front().unit;
}

bool is_selected(const Selection& selection, const TaxelKey& key) {
  return key.sensor == selection.sensor && selection.contains(key.id);
}

void click_taxel_of(Selection& selection, const TaxelKey& key, bool shift) {
  if (selection.sensor != key.sensor) selection = {key.sensor, {}, selection.body};
  click_taxel(selection, key.id, shift);
}

PressureRange range_of(const std::vector<SensorShown>& sensors, const SensorShown& sensor, const RunView& run,
                       const Selection& selection, const PressureRange& selected) {
  if (same_unit(sensor.unit, selected_unit(sensors, selection))) return selected;
  double largest = 0;
  for (const SensorShown& other : sensors) {
    if (!same_unit(other.unit, sensor.unit)) continue;
    for (std::size_t k = 0; k < other.step->readings.size(); ++k) {
      largest = std::max(largest, other.step->readings[k]);
      if (other.first + k < run.all_peaks.size()) largest = std::max(largest, run.all_peaks[other.first + k]);
    }
  }
  return {0, axis_top(largest, sensor.unit), true, selected.colors};
}

}  // namespace taxel::ui
