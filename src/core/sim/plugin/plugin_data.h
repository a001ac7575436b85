// One instance of `taxel.sensor` or `taxel.contact` of one mjData, with its state: the bodies that it declares, their
// contacts, and the readings of a sensor. Frame M is that of the mesh file.
#pragma once

#include <mujoco/mujoco.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/sensor/readout/reading.h"
#include "core/sim/plugin/pairs/body_contacts.h"
#include "core/sim/plugin/plugin_config.h"
#include "core/sim/plugin/reported_values.h"
#include "core/sim/plugin/shared/shared_parts.h"

namespace taxel {

/// One `taxel.sensor` instance of one mjData: its model, its contacts and its readings.
class HydroInstance {
 public:
  /// Reads the configuration and compiles the layout. If the configuration names no layout, the model comes by
  /// hand_over(). Throws Error if a key or the layout is not valid.
  HydroInstance(const mjModel& m, int instance);
  /// Copies a sensor with its state, for mj_copyData. Memory that only speeds up a step starts empty.
  HydroInstance(const HydroInstance& other);
  HydroInstance& operator=(const HydroInstance&) = delete;

  /// Sets the compiled model. Throws Error if the number of taxels does not fit the size of the output.
  void hand_over(const mjModel& m, SensorModelPtr model);
  /// Replaces the model by another one of the same body, and reads the last sensed state again. Reported values begin
  /// again if the taxels or their calibration differ. Throws Error if the number of taxels does not fit the size of the
  /// output, or the calibration that of the state.
  void replace_samples(const mjModel& m, mjData& d, SensorModelPtr model);

  [[nodiscard]] const SensorConfig& config() const { return config_; }
  [[nodiscard]] const SensorModelPtr& model() const { return model_; }  ///< model, or null before hand_over()
  [[nodiscard]] BodyContacts& contacts() { return contacts_; }
  [[nodiscard]] const BodyContacts& contacts() const { return contacts_; }
  [[nodiscard]] const std::vector<TouchedGeom>& touched() const { return contacts_.touched(); }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return contacts_.warnings; }

  /// Evaluates the contacts of the present state. Its readings are made by read_sensors().
  void sense(const mjModel& m, mjData& d);
  /// From now on the plugin senses and does not read, for programs that look at few steps: they call
  /// read_sensors().
  void defer_readings() { defers_ = true; }
  [[nodiscard]] bool defers() const { return defers_; }
  [[nodiscard]] bool is_unread() const { return is_unread_; }  ///< whether reading() is older than sensed()
  /// Reads the last sensed state and fills sensordata. Several sensors of one mjData may do so at the same time.
  void read(const mjModel& m, mjData& d);
  /// Contacts of the last sensed state. Valid until the next step.
  [[nodiscard]] const Evaluation& sensed() const { return contacts_.sensed(); }
  /// Readings of the last sensed state. Valid until the next step.
  [[nodiscard]] const SensorReading& reading() const { return reading_; }
  /// Share of each taxel's field that slips in the last sensed state; empty without bristles. Valid until the next
  /// step.
  [[nodiscard]] const std::vector<double>& slip() const { return slip_; }
  /// Stores the state of the reported values at the end of a step.
  void advance(const mjModel& m, mjData& d);

 private:
  void check_output_fits(const mjModel& m, const SensorModel& model) const;
  void set_field_weights();
  void set_reported_values(const mjModel& m, const SensorModel& next);
  void read_slip_of_taxels();
  void write_output(mjtNum* out) const;

  SensorConfig config_;
  BodyContacts contacts_;
  SensorModelPtr model_;
  WarningsPtr compared_;  // warnings about the geom's mesh, shared with other data
  SensorReading reading_;
  std::vector<const ContactSurface*> surfaces_;
  std::vector<SurfaceMotion> motions_;  // parallel to surfaces_; empty if the layout has no shear readings
  std::shared_ptr<const FieldWeights> field_weights_;  // for slip_; null without bristles
  std::vector<double> slip_;
  std::optional<ReportedValues> reported_;  // not set unless the output has calibrated values
  bool defers_ = false;
  bool is_unread_ = false;
};

/// Reads the sensors of one mjData, several side by side where that is faster, and fills sensordata. A sensor that
/// cannot be read gets the reason as its contacts().failure.
void read_sensors(const mjModel& m, mjData& d, std::span<HydroInstance* const> sensors);

/// The parts of the sensors of a model that take longest to build. Instances find them as long as somebody has them.
struct CompiledSensors {
  std::vector<SensorModelPtr> models;
  std::vector<WarningsPtr> comparisons;
};

/// Compiles the layouts of all sensors of a model side by side, because MuJoCo makes their instances one after another.
/// A layout that cannot be compiled is left out: its own instance reports the reason.
CompiledSensors compile_side_by_side(const mjModel& m);

/// One `taxel.contact` instance of one mjData: the soft geoms that it declares, with their contacts but without taxels.
class ContactInstance {
 public:
  /// Reads the configuration and builds the bodies. Throws Error if a key is not valid.
  ContactInstance(const mjModel& m, int instance);

  [[nodiscard]] const ContactConfig& config() const { return config_; }
  [[nodiscard]] std::vector<BodyContacts>& bodies() { return bodies_; }  ///< one per entry of config().bodies

  /// Retains the present state of all bodies and fills sensordata.
  void sense(const mjModel& m, mjData& d);

 private:
  int instance_ = -1;
  ContactConfig config_;
  std::vector<BodyContacts> bodies_;
};

}  // namespace taxel
