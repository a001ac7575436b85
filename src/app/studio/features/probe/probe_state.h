// The state of the probe tool: shape, place and depth of the probe.
#pragma once

#include <optional>
#include <vector>

#include "core/base/text/alternatives.h"
#include "core/sensor/probe/probe.h"

namespace taxel::ui {

struct ProbeSettings {
  std::size_t chosen = 0;                                           ///< index of the shape in `shapes`
  std::vector<ProbeShape> shapes = each_alternative<ProbeShape>();  ///< last values of each shape
  Material material;                                                ///< modulus 0 for a rigid probe
  double depth = 0.001;                                             ///< [m]
  double roll_deg = 0;

  [[nodiscard]] const ProbeShape& shape() const { return shapes[chosen]; }
  [[nodiscard]] const ProbeSphere& sphere() const {
    return std::get<ProbeSphere>(shapes[ProbeShape(ProbeSphere{}).index()]);
  }
};

struct ProbeState {
  bool on = false;          ///< the tool is active; without a place the probe does not press
  bool held = false;        ///< the probe follows the pointer over the skin
  std::optional<dvec3> at;  ///< place on the skin, frame M
  ProbeSettings settings;
  bool sized = false;             ///< the settings were fitted to the sensor
  bool pressed = false;           ///< the left button was pressed on the probe
  bool dragged = false;           ///< the pointer has moved since the press
  double depth_before = 0;        ///< depth at the press [m]
  double largest = 0;             ///< largest pressure since the activation [Pa]
  std::optional<double> latency;  ///< time from the last edit to its reading [s]
};

}  // namespace taxel::ui
