// The taxels that the table lists, with their places in the compiled model.
#pragma once

#include <vector>

#include "app/studio/frame/shown.h"
#include "app/studio/nouns/table/taxel_values.h"

namespace taxel::ui {

/// The taxels of the table in this frame.
struct Table {
  const Project* project;  ///< the edited project, or null
  const Layout& layout;
  const SensorModel& model;   ///< compiled model, which may be older than the layout
  const SensorStep* sensor;   ///< state of the sensor, or null in LAYOUT
  std::vector<int> in_model;  ///< index in the model of each taxel of the layout, or -1
  std::vector<int> samples;   ///< number of samples of each taxel of the layout
  bool edited = false;
  ValueColumns values = {};
};

Table table_of(const Viewer& viewer, const Shown& shown, const Layout& layout, const SensorModel& model);

}  // namespace taxel::ui
