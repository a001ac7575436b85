// The requested and the computed explanation of a reading; see core/sensor/explain.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/sensor/explain/explanation.h"

namespace taxel::ui {

/// A taxel of the simulation in the displayed step.
struct ExplainRequest {
  int sensor = 0;
  int taxel = 0;  ///< id of the taxel
  bool operator==(const ExplainRequest&) const = default;
};

/// The result of a request for one step.
struct ExplainedStep {
  ExplainRequest request;
  std::uint64_t step = 0;
  Explanation explanation;
  std::string problem;  ///< reason why there is no explanation; empty if there is one
};
using ExplainedPtr = std::shared_ptr<const ExplainedStep>;

/// A polygon of a sensor's contact surfaces, with the numbers that hits use.
struct PolygonNumber {
  int surface = 0, polygon = 0;
  bool operator==(const PolygonNumber&) const = default;
};

struct ExplainState {
  ExplainedPtr explained;                ///< explanation of the displayed or an earlier step, or null
  std::optional<PolygonNumber> polygon;  ///< polygon of `step` selected in table, scatter plot and view
  std::uint64_t step = 0;
  bool wants_focus = false;  ///< whether the panel comes to the front in the next frame
  /// After a remedy: the run begins again when the simulation reads by another model than this one. Null otherwise.
  SensorModelPtr rerun_without;
};

}  // namespace taxel::ui
