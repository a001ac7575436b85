// What a simulation step left behind, without copies: what a frame is filled from, and what the history records.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/run/sim_frame.h"

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

struct StepView {
  std::shared_ptr<const SimScene> scene;
  std::uint64_t step = 0;
  double time = 0, travel = 0;
  bool finished = false;
  std::vector<Pose> geom_poses;
  std::vector<SensorView> sensors;
  std::vector<HeldPoints> held;
  MarkPoses mark_poses;
  StepFacts facts;
};

/// Copies what a viewer needs. Keeps the memory of `frame`.
void fill_frame(const StepView& now, SimFrame& frame);

/// The rays of each sensor that hit in a frame.
using FilledHits = std::vector<std::vector<std::int32_t>>;
/// The same from a simulator's own view into a frame that was filled so before, where `hits` is not empty: of rays,
/// most of which miss, only those that hit then or now are touched.
void fill_frame(const StepView& now, SimFrame& frame, FilledHits& hits);

/// The step of a frame that has all of it, valid as long as the frame is.
StepView view_of(const SimFrame& frame);

/// MuJoCo's state after a step, from which the next one goes on the same way, bit for bit.
struct SimState {
  std::vector<double> integration;  ///< mjSTATE_INTEGRATION
  std::uint64_t step = 0;
  double time = 0, travel = 0;  ///< of the state that was evaluated
  bool row_due = false;
};

}  // namespace taxel
