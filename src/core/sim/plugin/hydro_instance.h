// One sensor of one mjData: what it touches, the surfaces of the state last evaluated, its readings.
//
// Frame M is that of the mesh file; wrenches act on the sensor, about M's origin, in M's axes.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <string>
#include <vector>

#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"
#include "core/sensor/reading.h"
#include "core/sim/plugin/broad_phase.h"
#include "core/sim/plugin/sensor_config.h"
#include "core/sim/plugin/sensor_pairs.h"
#include "core/sim/sensor_times.h"

namespace taxel {

/// A geom that the sensor touches.
struct TouchedGeom {
  int geom = -1;
  HydroBodyPtr body;  ///< null: a sensor that has no model yet, or none that can be touched
  PairProperties properties;
  Pose X_GB;                    ///< of the body's frame: the geom's own; of a sensor that of its mesh file
  PairRole role;                ///< towards a sensor on the geom
  bool mujoco_too = false;      ///< MuJoCo's own contact of the pair was seen: reported once
  unsigned step_checks = 0;     ///< how often the time step was to be checked
  bool step_too_large = false;  ///< the contact was seen to be too stiff for the time step: reported once
  bool at_core = false;         ///< the geom was seen to press through to the pad's core: reported once
};

/// A pair in one state.
struct PairState {
  Pose X_WB;               ///< of the other body's frame
  Twist V;                 ///< of the sensor relative to it, at M's origin, frame M
  Twist V_rub;             ///< the same where `wrench` was found: of the step's end where that is implicit
  ContactSurface surface;  ///< frame M
  Wrench wrench;           ///< on the sensor
};

/// All pairs of a sensor in one state.
struct Evaluation {
  bool valid = false;
  Pose X_WM;
  std::vector<PairState> pairs;   ///< parallel to touched(); of those that are not near only surface and wrench count
  std::vector<std::size_t> near;  ///< numbers of the pairs that may touch, ascending; all others are empty
};

class HydroInstance {
 public:
  /// Reads the configuration and compiles the layout, or waits for hand_over() where it says so. Throws Error.
  HydroInstance(const mjModel& m, int instance);
  /// For mj_copyData: the same sensor in the same state. What only speeds up a step starts empty.
  HydroInstance(const HydroInstance& other);
  HydroInstance& operator=(const HydroInstance&) = delete;

  /// Takes a compiled sensor with as many taxels as the output was sized for. Throws Error.
  void hand_over(const mjModel& m, SensorModelPtr model);
  /// The same with a sensor of the same body: what was sensed last is read anew by it. Throws Error.
  void replace_samples(const mjModel& m, mjData& d, SensorModelPtr model);

  [[nodiscard]] const SensorConfig& config() const { return config_; }
  [[nodiscard]] const SensorModelPtr& model() const { return model_; }  ///< null before hand_over()
  [[nodiscard]] int index() const { return instance_; }
  [[nodiscard]] const std::vector<TouchedGeom>& touched() const { return touched_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  /// Poses, twists and surfaces of the present state of `d`; wrenches are zeroed.
  /// Pairs that another sensor computes stay empty: sense() takes them from there.
  Evaluation& evaluate(const mjModel& m, mjData& d);
  /// The state that evaluate() saw last.
  [[nodiscard]] Evaluation& latest() { return slots_[latest_]; }
  /// latest() if it is of the present state, else that state evaluated, its wrenches without implicit step.
  Evaluation& present(const mjModel& m, mjData& d);

  /// Takes the body of a sensor that this one touches; to be called again when that gets another. Throws Error where
  /// both are rigid and the geom was named.
  void link(const mjModel& m, const HydroInstance& other);

  /// Fills sensordata for the present state.
  void sense(const mjModel& m, mjData& d);
  /// What sense() saw, and what it read. Valid until the next step.
  [[nodiscard]] const Evaluation& sensed() const { return slots_[sensed_]; }
  [[nodiscard]] const SensorReading& reading() const { return reading_; }

  /// True at the first call for a pair and at every `every`th.
  bool time_to_check_step(std::size_t pair, unsigned every) { return touched_[pair].step_checks++ % every == 0; }
  /// Reports, once, that a pair's contact is stiffer than the time step bears; `largest` is the step it does [s].
  void note_step_too_large(const mjModel& m, std::size_t pair, double largest);

  /// Forgets all states.
  void reset();

  /// Time spent so far; a copy begins at 0.
  SensorTimes times;
  /// Set by the plugin when a callback failed: reported once, then the sensor reads zero.
  std::string failure;

 private:
  void check_output_fits(const mjModel& m, const SensorModel& model) const;
  void compile_others(const mjModel& m);
  TouchedGeom compile_other(const mjModel& m, int geom);
  void link_all(const mjModel& m, mjData& d);
  void mirror_pairs(const mjModel& m, mjData& d);
  /// Number of the pair with a geom; touched().size() where there is none.
  [[nodiscard]] std::size_t pair_with(int geom) const;
  void compare_with_model(const mjModel& m);
  void note_pressed_through();
  void note_mujoco_contacts(const mjModel& m, const mjData& d);
  void clear_pairs(Evaluation& e) const;
  void locate(const mjModel& m, const mjData& d, Evaluation& e) const;
  [[nodiscard]] bool fresh(const mjModel& m, const mjData& d);
  void read(const mjModel& m, mjData& d);  ///< the surfaces of sensed() into sensordata
  void write_output(mjtNum* out);

  int instance_ = -1;
  SensorConfig config_;
  std::vector<DeclaredSensor> declared_;
  SensorModelPtr model_;
  Pose X_GM_;
  std::vector<TouchedGeom> touched_;  // ascending by geom
  std::vector<std::size_t> sensors_;  // numbers of those that are sensors
  BroadPhase broad_phase_;            // numbers as touched_
  std::vector<std::string> warnings_;
  std::array<Evaluation, 2> slots_;  // one may still be shown as sensed() while RK4 evaluates further
  std::size_t latest_ = 0, sensed_ = 0;
  Evaluation probe_;
  IntersectWorkspace workspace_;
  SensorReading reading_;
  std::vector<const ContactSurface*> surfaces_;
  std::vector<SurfaceMotion> motions_;  // parallel to surfaces_ where the layout asks for shear
};

}  // namespace taxel
