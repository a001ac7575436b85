// A probe pressed on the layout that is edited: what is wished, and what came of it. Drawn and read as a sensor of a
// simulation is.
#pragma once

#include <memory>
#include <string>

#include "core/run/frame.h"
#include "core/sensor/probe/probe.h"

namespace taxel::ui {

struct ProbeWish {
  Probe probe;
  std::string mesh_file;  ///< of a ProbeMesh, whose mesh is read from there; else empty
  bool operator==(const ProbeWish&) const = default;
};

struct PressedProbe {
  SensorModelPtr model;  ///< pressed on; never null
  ProbeWish wish;
  std::string problem;  ///< why it cannot be pressed; then nothing below counts
  TriMeshPtr mesh;      ///< the probe as drawn
  Pose X_MG;            ///< of that mesh
  SensorStep state;     ///< sensor at rest, with frame M equal to the world frame
  double force = 0;     ///< of the pressure on the sensor [N]
  double area = 0;      ///< of the contact surface [m^2]
  double largest = 0;   ///< pressure [Pa]
  int polygons = 0;
};
using PressedProbePtr = std::shared_ptr<const PressedProbe>;

}  // namespace taxel::ui
