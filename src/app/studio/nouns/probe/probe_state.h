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
  double depth = 0.001;                                             ///< indentation depth [m]
  double roll_deg = 0;

  [[nodiscard]] const ProbeShape& shape() const { return shapes[chosen]; }
  [[nodiscard]] const ProbeSphere& sphere() const {
    return std::get<ProbeSphere>(shapes[ProbeShape(ProbeSphere{}).index()]);
  }
};

/// The part of the probe's state that another document resets.
struct PlacedProbe {
  bool on = false;                ///< the tool is active; without a place the probe does not press
  bool held = false;              ///< the probe follows the pointer over the skin
  std::optional<dvec3> at;        ///< place on the skin, frame M
  bool sized = false;             ///< the settings were fitted to the sensor
  bool pressed = false;           ///< the left button was pressed on the probe
  bool dragged = false;           ///< the pointer has moved since the press
  double largest = 0;             ///< largest pressure since the activation [Pa]
  double largest_reading = 0;     ///< largest reading since the activation, in SI units
  std::optional<double> latency;  ///< time from the last edit to its reading [s]
};

struct ProbeState : PlacedProbe {
  using PerDocument = PlacedProbe;
  ProbeSettings settings;
};

}  // namespace taxel::ui
