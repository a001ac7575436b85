// A probe pressed on the edited layout: the request and its result. It is drawn and read like a sensor of a simulation.
#pragma once

#include <memory>
#include <string>

#include "core/run/frame.h"
#include "core/sensor/probe/probe.h"

namespace taxel::ui {

struct PressedProbe {
  SensorModelPtr model;  ///< model on which the probe is pressed; never null
  Probe probe;           ///< the requested probe; a ProbeMesh has its file only
  std::string problem;   ///< reason why pressing failed, or empty; if set, the rest is not valid
  TriMeshPtr mesh;       ///< mesh of the probe for drawing
  Pose X_MG;             ///< pose of the probe's mesh
  SensorStep state;      ///< state of the model at rest, with its frame M as the world
  double force = 0;      ///< force of the pressure on the sensor [N]
  double area = 0;       ///< area of the contact surface [m^2]
  double largest = 0;    ///< largest pressure [Pa]
  int polygons = 0;
};
using PressedProbePtr = std::shared_ptr<const PressedProbe>;

}  // namespace taxel::ui
