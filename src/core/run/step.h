// One simulation step: its scene, poses, sensors and facts; and the rows of a run's readings that are made of steps,
// for plots and bars. Plain values, free of MuJoCo.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/run/scene.h"
#include "core/sensor/sensor_model.h"
#include "core/sensor/sensor_step.h"

namespace taxel {

/// Identifies a step of a session: equal steps were read by the same models of the same scene.
struct StepId {
  std::uint64_t run = 0;   ///< number of runs that were started before, SimFrame::runs
  std::uint64_t step = 0;  ///< number of the step in its run
  std::uint64_t model_edition = 0;
  bool operator==(const StepId&) const = default;
};

/// All values of a step except those of its sensors.
struct StepState {
  std::shared_ptr<const SimScene> scene;
  std::uint64_t step = 0;        ///< number of the step in its run
  double time = 0;               ///< time of the evaluated state [s]
  double travel = 0;             ///< distance of the mocap body from its start, or along its path [m]
  bool finished = false;         ///< the end of the scenario is reached
  std::vector<Pose> geom_poses;  ///< X_WG, parallel to scene->geoms
  std::vector<ConstraintPoints> constraint_points;
  MarkPoses mark_poses;  ///< poses of scene->marks
  StepFacts facts;
};

/// A step with all its sensors.
struct Step : StepState {
  std::vector<SensorStep> sensors;  ///< parallel to scene->sensors
  /// Returns the index of a sensor's first reading in rows that have the readings of all sensors.
  [[nodiscard]] std::size_t first_reading(std::size_t sensor) const {
    std::size_t first = 0;
    for (std::size_t s = 0; s < sensor; ++s) first += sensors[s].readings.size();
    return first;
  }
};
using StepPtr = std::shared_ptr<const Step>;

// The latest step of a simulator without copies: frames are filled from it, and the history packs it.

/// One sensor at the latest step. Pointers are valid until the next step. See SensorStep for the values.
struct SensorView {
  Pose X_WM;
  dvec3 force_W{0}, uncovered_W{0};
  dvec3 torque_W{0};  ///< torque of `force_W` about M's origin [N m]; zero in view_of()
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

/// The readings of one recorded row. A sweep has a row for every 0.1 mm, other runs have one for every step.
struct TraceRow {
  double time = 0, travel = 0;   ///< [s], [m]
  std::vector<double> readings;  ///< readings of all sensors, one sensor after the other
  /// Quality of the samples; preview if any sensor used preview samples, which are replaced later.
  SampleQuality quality = SampleQuality::polished;
  /// Magnitude of each taxel's shear, parallel to `readings`; 0 for sensors without shear, empty if no sensor has it.
  std::vector<double> shear = {};
  /// Share of each field that slips, 0 to 1, parallel to `readings`; 0 for sensors whose friction does not stick,
  /// empty if none does.
  std::vector<double> slip = {};
};

/// All rows of a run so far.
struct Trace {
  std::vector<TraceRow> rows;
  /// Changes when rows are removed. Of two copies with the same edition, the longer one continues the shorter one.
  std::uint64_t edition = 0;
};

/// Returns the row of a step: readings, and shear and slip of the sensors that have them.
[[nodiscard]] TraceRow trace_row_of(const StepView& step, SampleQuality quality);

}  // namespace taxel
