// A displayed step of several sensors, without a window.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/studio/frame/sensors_shown.h"

namespace taxel::ui::test {

/// A sensor whose taxels have the ids 1, 2, ... in the order of `readings`.
struct FrameSensor {
  std::string name;
  std::vector<double> readings;
  Aggregate aggregate = Aggregate::weighted_mean;
};

/// Returns a run that displays step `lanes->steps.back()`, or step 0 without recorded steps.
inline RunView run_of(const std::vector<FrameSensor>& sensors,
                      const std::shared_ptr<const HistoryLanes>& lanes = nullptr) {
  const auto frame = std::make_shared<SimFrame>();
  const auto scene = std::make_shared<SimScene>();
  RunView run;
  for (const FrameSensor& sensor : sensors) {
    const auto model = std::make_shared<SensorModel>();
    model->layout.readout.aggregate = sensor.aggregate;
    for (std::size_t k = 0; k < sensor.readings.size(); ++k) {
      Taxel taxel;
      taxel.id = static_cast<int>(k) + 1;
      model->layout.taxels.push_back(taxel);
      model->fields.first.push_back(10 * static_cast<int>(k + 1));
    }
    SensorStep step;
    step.model = model;
    step.readings = sensor.readings;
    frame->sensors.push_back(step);
    scene->sensors.push_back(model);
    scene->sensor_geoms.push_back(sensor.name);
    run.all_peaks.insert(run.all_peaks.end(), sensor.readings.begin(), sensor.readings.end());
  }
  frame->scene = scene;
  frame->history.lanes = lanes ? lanes : std::make_shared<HistoryLanes>();
  run.frame = frame;
  return run;
}

/// Returns recorded steps 0, 1, ... of 1 ms with these readings of all sensors, one row per step.
inline std::shared_ptr<HistoryLanes> lanes_of(const std::vector<std::vector<double>>& rows) {
  const auto lanes = std::make_shared<HistoryLanes>();
  lanes->reading_count = rows.front().size();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    lanes->steps.push_back({r, 1e-3 * static_cast<double>(r), 0, 0});
    lanes->readings.append(rows[r].data(), rows[r].data() + rows[r].size());
  }
  return lanes;
}

}  // namespace taxel::ui::test
