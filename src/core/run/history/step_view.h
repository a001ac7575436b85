// What a simulation step left behind, without copies: what a frame is filled from, and what the history records.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/run/step.h"

namespace taxel {

/// One sensor in the step just made. Pointers are valid until the next one.
struct SensorView {
  Pose X_WM;
  dvec3 force_W{0}, uncovered_W{0};  ///< see SensorStep
  std::span<const double> readings;
  std::vector<const ContactSurface*> surfaces;  ///< as the hits number them
  std::vector<SurfaceMotion> motions;           ///< see SensorStep
  std::span<const RayHit> hits;                 ///< by ray
  std::span<const std::int32_t> hit_rays;       ///< those of them that are no misses; of a simulator's own view alone
  std::span<const dvec2> shear;                 ///< see SensorStep
};

/// A step of which nothing is copied.
struct StepView : StepState {
  std::vector<SensorView> sensors;
};

/// Copies a step. Reuses the memory of `to`.
void fill_step(const StepView& now, Step& to);

/// Indices of the rays that hit, for each sensor of a step.
using FilledHits = std::vector<std::vector<std::int32_t>>;
/// Copies a step of a simulator's own view. If `hits` is not empty it names the hits in `to`, which was filled by this
/// function; only rays that hit then or now are written, because most rays miss.
void fill_step(const StepView& now, Step& to, FilledHits& hits);

/// Returns a view of a step, valid as long as `step` is not changed.
StepView view_of(const Step& step);

/// MuJoCo's state after a step, from which the next one goes on the same way, bit for bit.
struct SimState {
  std::vector<double> integration;  ///< mjSTATE_INTEGRATION
  std::uint64_t step = 0;
  double time = 0, travel = 0;  ///< of the state that was evaluated
  bool row_due = false;
};

}  // namespace taxel
