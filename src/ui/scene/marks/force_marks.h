// Arrows of the net forces that contacts exert on sensors.
#pragma once

#include <string>
#include <vector>

#include "ui/scene/sensor_view.h"

namespace taxel::ui {

/// Length of an arrow that the legend names [m].
inline constexpr double kNamedArrow = 0.01;

/// The arrow of one sensor's net force, from the centroid of the pressure.
struct ForceMark {
  int sensor = 0;
  dvec3 base_W{0}, tip_W{0};  ///< ends of the arrow [m]
  double force = 0;           ///< [N]
};

/// Returns the force [N] that an arrow of kNamedArrow means: 1 N, or the smallest larger power of ten at which no
/// arrow of the frame is longer than 0.8 of the diagonal of its sensor.
[[nodiscard]] double force_of_named_arrow(const std::vector<SensorView>& views);

/// Returns the arrows of all sensors in contact, or none if the contact surface is not drawn. Lengths are proportional
/// to forces.
[[nodiscard]] std::vector<ForceMark> force_marks(const SceneInput& input, const std::vector<SensorView>& views);

/// Returns the text at the tip of an arrow: "0.84 N".
[[nodiscard]] std::string force_text(double force);

}  // namespace taxel::ui
