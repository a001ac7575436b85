// What is asked about a reading, and what was found: see core/sensor/explain.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/sensor/explain/explanation.h"

namespace taxel::ui {

/// A taxel of the simulation, in the step that is shown.
struct ExplainRequest {
  int sensor = 0;
  int taxel = 0;  ///< id
  bool operator==(const ExplainRequest&) const = default;
};

/// What was found for a step.
struct ExplainedStep {
  ExplainRequest request;
  std::uint64_t step = 0;
  Explanation explanation;
  std::string problem;  ///< why there is none; empty: there is
};
using ExplainedPtr = std::shared_ptr<const ExplainedStep>;

/// A polygon of a sensor's contact surfaces, as hits number them.
struct PolygonNumber {
  int surface = 0, polygon = 0;
  bool operator==(const PolygonNumber&) const = default;
};

struct ExplainState {
  ExplainedPtr explained;                ///< explanation of the displayed step or of one before, or null
  std::optional<PolygonNumber> polygon;  ///< selected: in the table, the scatter and the view; of `step` alone
  std::uint64_t step = 0;
  bool wants_focus = false;  ///< the panel comes to the front in the next picture
};

}  // namespace taxel::ui
