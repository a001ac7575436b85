// The result of `taxel models`.
#pragma once

#include <string>
#include <vector>

#include "core/sensor/compare/reading_models.h"
#include "core/sensor/sensor_model.h"

namespace taxel::cli {

/// One sensor of a recording, read by all models.
struct ModelsReport {
  std::string geom;
  SensorModelPtr model;
  struct Row {
    double time = 0, travel = 0;
    ModelReadings readings;
  };
  std::vector<Row> rows;
};

/// Of one taxel (index), as compare_curve() takes it.
std::vector<double> curve_of(const ModelsReport& report, ReadingModel model, std::size_t taxel);
/// Why a model has no values, or left something out, at its first row where that is so; empty: nothing is.
std::string missing_of(const ModelsReport& report, ReadingModel model);

std::string models_text(const ModelsReport& report);
std::string models_json(const ModelsReport& report);
/// time, travel, then a column MODEL_ID for each model and taxel, in SI; empty where there is no value.
std::string models_csv(const ModelsReport& report);

}  // namespace taxel::cli
