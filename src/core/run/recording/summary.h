// Summary of a recording: for each taxel whether it responds, how strongly, and how smoothly.
#pragma once

#include <string>
#include <vector>

#include "core/run/recording/recording.h"

namespace taxel {

/// Summary of one taxel.
struct TaxelSummary {
  int id = 0;
  std::string name;
  double peak = 0;         ///< largest reading [Pa], or [N] for Aggregate::force
  double mean = 0;         ///< mean reading over the rows, in the unit of `peak`
  double peak_travel = 0;  ///< travel of the mocap body at the peak [m]
  /// Largest change between two successive rows, as a fraction of `peak`; 0 if the taxel never responds.
  double largest_step = 0;
  double largest_error = 0;  ///< largest error bar of a reading, in the unit of `peak`; 0 without error bars
  bool responds = false;     ///< true if the peak is above kResponds of the largest peak of the sensor
};

/// Summary of one sensor.
struct RecordedSensorSummary {
  std::string geom;
  std::vector<TaxelSummary> taxels;
  double largest_force = 0;  ///< largest length of the contact force [N]
  double largest_area = 0;   ///< largest area of the contact surfaces [m^2]
  /// Largest length of the elastic normal force that no taxel reaches [N]; 0 unless RecordedSensor::force.
  double largest_uncovered = 0;
  /// Largest displacement of the sensor's frame relative to the mocap body since the first row [m].
  double deflection = 0;
  double deflection_deg = 0;  ///< largest rotation of the frame relative to the mocap body since the first row
};

/// Smallest peak of a taxel that responds, as a fraction of the sensor's largest peak.
inline constexpr double kResponds = 0.05;

/// Returns the summary of each sensor of a recording.
std::vector<RecordedSensorSummary> summarize(const Recording& recording);

}  // namespace taxel
