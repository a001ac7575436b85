// Which instance computes a contact between two sensors: both feel one surface, and one wrench moves their bodies.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "core/sim/plugin/sensor_config.h"

namespace taxel {

/// A sensor that the model declares.
struct DeclaredSensor {
  int instance = -1;
  SensorConfig config;
};

/// The sensors declared for the plugin of `instance`, itself among them, ascending. Left out is one whose configuration
/// cannot be read: its own init says why.
std::vector<DeclaredSensor> declared_sensors(const mjModel& m, int instance);

/// Adds to `config.others` the geoms of sensors that touch this one: what is touched touches.
void add_sensors_that_touch(const std::vector<DeclaredSensor>& sensors, SensorConfig& config);

/// How a sensor and a geom that it touches share their contact.
struct PairRole {
  int sensor = -1;        ///< instance of the sensor on the touched geom; -1: an ordinary geom
  bool mirrored = false;  ///< that sensor computes the surface and the wrench, this one takes both from there
  bool applies = true;    ///< the wrench moves bodies: once per pair of geoms
};

/// The role of sensor `self` towards `geom`. Of two sensors that one computes the pair which applies forces, else the
/// one whose geom's name comes first. Where several sensors lie on one geom, the first that applies forces, else the
/// first, stands for it; the others compute their pairs with sensors for themselves and move nothing.
PairRole pair_role(const std::vector<DeclaredSensor>& sensors, int self, const SensorConfig& config, int geom);

}  // namespace taxel
