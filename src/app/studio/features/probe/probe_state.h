// The probe in the hand: what it is, where it was put, how deep.
#pragma once

#include <optional>
#include <string>

#include "core/sensor/probe/probe.h"

namespace taxel::ui {

enum class ProbeKind { sphere, edge, point, mesh };

struct ProbeSettings {
  ProbeKind kind = ProbeKind::sphere;
  ProbeSphere sphere;
  ProbeEdge edge;
  ProbePoint point;
  std::string mesh_file;
  Material material;     ///< modulus 0: rigid
  double depth = 0.001;  ///< [m]
  double roll_deg = 0;
};

struct ProbeState {
  bool on = false;          ///< taken up; without a place yet it presses nothing
  bool held = false;        ///< it follows the pointer over the skin; else it stays where it is, and edits show there
  std::optional<dvec3> at;  ///< on the skin, frame M
  ProbeSettings settings;
  bool sized = false;             ///< the settings were fitted to a sensor, or changed by hand
  bool pressed = false;           ///< the left button went down on it
  bool dragged = false;           ///< and the pointer moved since
  double depth_before = 0;        ///< when it went down [m]
  double largest = 0;             ///< pressure since it was taken up [Pa]
  std::optional<double> latency;  ///< from the last edit to its reading [s]
};

}  // namespace taxel::ui
