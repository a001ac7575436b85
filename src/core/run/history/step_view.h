// The latest step of a simulator without copies: frames are filled from it, and the history packs it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/run/step.h"

namespace taxel {

/// One sensor at the latest step. Pointers are valid until the next step. See SensorStep for the values.
struct SensorView {
  Pose X_WM;
  dvec3 force_W{0}, uncovered_W{0};
  std::span<const double> readings;
  std::vector<const ContactSurface*> surfaces;
  std::vector<SurfaceMotion> motions;
  std::span<const RayHit> hits;
  std::span<const std::int32_t> hit_rays;  ///< rays that hit; empty in view_of()
  std::span<const dvec2> shear;
  std::span<const double> slip;
  std::vector<const StickingFriction*> sticking;
};

/// The latest step of a simulator, or a view of a Step.
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

/// MuJoCo's state after a step. The next step from this state repeats, bit for bit.
struct SimState {
  std::vector<double> integration;  ///< mjSTATE_INTEGRATION
  std::uint64_t step = 0;
  double time = 0, travel = 0;  ///< values of the state that was evaluated
  bool row_due = false;
};

}  // namespace taxel
