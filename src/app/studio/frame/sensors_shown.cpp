#include "app/studio/frame/sensors_shown.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "ui/scene/scene_parts.h"
#include "ui/widgets/format.h"

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
    sensors.push_back({static_cast<int>(i), begin, label_of_sensor(scene, i), model, &step,
                       shown_unit(model->layout.readout.aggregate), &scene});
  }
  return sensors;
}

std::vector<SensorPlace> places_of(const std::vector<SensorShown>& sensors, const RunView& run) {
  std::vector<SensorPlace> places(sensors.size());
  if (!run.frame || !run.frame->scene) return places;
  const SimScene& scene = *run.frame->scene;
  const std::vector<SceneBody>& bodies = scene.controls.bodies;
  std::vector<int> body_of(scene.sensors.size(), 0);
  for (const SceneGeom& geom : scene.geoms)
    if (geom.sensor >= 0 && static_cast<std::size_t>(geom.sensor) < body_of.size() &&
        static_cast<std::size_t>(geom.body_index) < bodies.size())
      body_of[static_cast<std::size_t>(geom.sensor)] = geom.body_index;
  std::vector<char> bears(bodies.size(), 0);    // whether the body or one below it has a sensor
  std::vector<int> branches(bodies.size(), 0);  // number of children that bear sensors
  for (const SensorShown& sensor : sensors) {
    for (int body = body_of[static_cast<std::size_t>(sensor.index)]; body > 0;) {
      const auto at = static_cast<std::size_t>(body);
      if (std::exchange(bears[at], 1) != 0) break;
      body = bodies[at].parent;
      ++branches[static_cast<std::size_t>(body)];
    }
  }
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    int body = body_of[static_cast<std::size_t>(sensors[s].index)];
    const auto parent = [&] { return bodies[static_cast<std::size_t>(body)].parent; };
    while (body > 0 && parent() > 0 && branches[static_cast<std::size_t>(parent())] == 1) body = parent();
    places[s] = {body, body_of[static_cast<std::size_t>(sensors[s].index)]};
  }
  return places;
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

std::string force_text(const Viewer& viewer, const Shown& shown, int decimals) {
  const SensorStep* step = shown.state(viewer);
  if (step == nullptr) return "";
  const std::string force = fmt::format("{:.{}f} N", glm::length(step->force_W), decimals);
  if (!shown.shows_scene(viewer)) return force;
  const std::vector<SensorShown> sensors = sensors_shown(shown.run);
  const auto found = std::ranges::find(sensors, step, &SensorShown::step);
  return sensors.size() > 1 && found != sensors.end() ? found->name + ": " + force : force;
}

void click_taxel_of(Selection& selection, const TaxelKey& key, bool shift) {
  if (selection.sensor != key.sensor) selection = {key.sensor, {}, selection.body, true};
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

namespace {

bool is_same(const ReadingUnit& a, const ReadingUnit& b) {
  return std::string_view(a.text) == b.text;
}

double largest_of(const std::vector<double>& readings) {
  return readings.empty() ? 0.0 : std::max(0.0, *std::max_element(readings.begin(), readings.end()));
}

/// Returns the largest reading in the displayed step, and since the start of all sensors that read in `unit`.
double largest_reading(const Viewer& viewer, const Shown& shown, const ReadingUnit& unit) {
  const SensorStep* state = shown.state(viewer);
  double largest = state != nullptr ? largest_of(state->readings) : 0.0;
  if (viewer.mode == Mode::layout) return std::max(largest, viewer.readings.probed);
  if (!shown.run.frame || !shown.run.frame->scene) return largest;
  const std::vector<SensorModelPtr>& models = shown.run.frame->scene->sensors;
  const std::vector<double>& peaks = shown.run.sensor_peaks;
  for (std::size_t s = 0; s < models.size() && s < peaks.size(); ++s)
    if (models[s] && is_same(shown_unit(models[s]->layout.readout.aggregate), unit))
      largest = std::max(largest, peaks[s]);
  return largest;
}

}  // namespace

void update_range(App& app, double largest_of_run) {
  PressureRange& range = app.viewer->range;
  if (!range.automatic) return;
  const bool probed = app.shown->document.probe && app.viewer->mode == Mode::layout;
  range.lo = 0;
  range.hi = std::max(kLeastRange, nice_ceiling(probed ? app.viewer->readings.probed_pressure : largest_of_run));
}

ReadingUnit unit_of_readings(const Viewer& viewer, const Shown& shown) {
  const SensorModelPtr model = shown.model(viewer);
  return model ? shown_unit(model->layout.readout.aggregate) : ReadingUnit{};
}

bool reads_pressures(const Viewer& viewer, const Shown& shown) {
  return unit_of_readings(viewer, shown).pressure;
}

bool shares_range(const Viewer& viewer, const Shown& shown) {
  return viewer.readings.linked && reads_pressures(viewer, shown);
}

PressureRange reading_range(const Viewer& viewer, const Shown& shown) {
  if (shares_range(viewer, shown)) return viewer.range;
  const ReadingUnit unit = unit_of_readings(viewer, shown);
  const std::optional<LockedReadings>& locked = viewer.readings.locked;
  if (locked && is_same(locked->unit, unit)) return {0, locked->hi, false, viewer.range.colors};
  return {0, axis_top(largest_reading(viewer, shown, unit), unit), true, viewer.range.colors};
}

void toggle_reading_lock(Viewer& viewer, const Shown& shown) {
  const PressureRange now = reading_range(viewer, shown);
  viewer.readings.locked.reset();
  if (now.automatic) viewer.readings.locked = LockedReadings{now.hi, unit_of_readings(viewer, shown)};
}

}  // namespace taxel::ui
