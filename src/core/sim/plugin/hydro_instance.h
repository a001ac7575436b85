// One sensor of one mjData: its model, its contacts, its readings. Frame M is that of the mesh file.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "core/sensor/readout/reading.h"
#include "core/sim/plugin/pairs/body_contacts.h"
#include "core/sim/plugin/sensor_config.h"

namespace taxel {

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
  [[nodiscard]] BodyContacts& contacts() { return contacts_; }
  [[nodiscard]] const BodyContacts& contacts() const { return contacts_; }
  [[nodiscard]] const std::vector<TouchedGeom>& touched() const { return contacts_.touched(); }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return contacts_.warnings; }

  /// Fills sensordata for the present state.
  void sense(const mjModel& m, mjData& d);
  /// What sense() saw, and what it read. Valid until the next step.
  [[nodiscard]] const Evaluation& sensed() const { return contacts_.sensed(); }
  [[nodiscard]] const SensorReading& reading() const { return reading_; }

 private:
  void check_output_fits(const mjModel& m, const SensorModel& model) const;
  void compare_with_model(const mjModel& m, const Pose& X_GM);
  void read(const mjModel& m, mjData& d);  ///< the surfaces of sensed() into sensordata
  void write_output(mjtNum* out) const;

  SensorConfig config_;
  BodyContacts contacts_;
  SensorModelPtr model_;
  SensorReading reading_;
  std::vector<const ContactSurface*> surfaces_;
  std::vector<SurfaceMotion> motions_;  // parallel to surfaces_ where the layout asks for shear
};

}  // namespace taxel
