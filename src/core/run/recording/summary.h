// What a recording says at a glance: who responded, how strongly, how smoothly.
#pragma once

#include <string>
#include <vector>

#include "core/run/recording/recording.h"

namespace taxel {

struct TaxelSummary {
  int id = 0;
  std::string name;
  double peak = 0;          ///< largest reading [Pa], or [N] for Aggregate::force
  double mean = 0;          ///< of the rows, in the same unit
  double peak_travel = 0;   ///< where it was [m]
  double largest_step = 0;  ///< largest change between two rows, as a part of the own peak; 0 where nothing was read
  bool responds = false;    ///< peak above 5 % of the largest of the sensor
};

struct RecordedSensorSummary {
  std::string geom;
  std::vector<TaxelSummary> taxels;
  double largest_force = 0;  ///< length of the contact force [N]
  double largest_area = 0;   ///< [m^2]
  double largest_uncovered =
      0;  ///< length of the elastic normal force that no taxel reaches; 0 unless RecordedSensor::force [N]
  double deflection = 0;  ///< largest way by which the sensor's frame lagged its mocap body, against the first row [m]
  double deflection_deg = 0;  ///< the same as an angle
};

/// Fraction of the sensor's largest peak above which a taxel counts as responding.
inline constexpr double kResponds = 0.05;

std::vector<RecordedSensorSummary> summarize(const Recording& recording);

}  // namespace taxel
