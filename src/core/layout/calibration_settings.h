// The settings of a layout's calibration (`calibration` in its file), which converts raw readings to the values that a
// device would report. Plain values; core/sensor/calibration.h has the formulas and their order. U is the unit of the
// raw readings ([Pa], or [N] for Aggregate::force), V that of the calibrated values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace taxel {

/// A corner of a piecewise-linear curve.
struct CurvePoint {
  double reading = 0;  ///< reading [U], ascending along a curve
  double value = 0;    ///< reported value [V]
  bool operator==(const CurvePoint&) const = default;
};
using Curve = std::vector<CurvePoint>;  ///< at least two points, or empty if there is no curve

/// Difference between the values while loading and while unloading.
struct Hysteresis {
  double width = 0;     ///< width of the loop between loading and unloading [U]
  double fraction = 1;  ///< fraction of the reading that has hysteresis, 0 to 1
  bool operator==(const Hysteresis&) const = default;
};

/// Influence of the readings of neighbouring taxels.
struct Crosstalk {
  double fraction = 0;  ///< fraction of a neighbour's reading that is added at distance 0
  double reach = 0;     ///< distance of centres from which nothing is added [m]
  bool operator==(const Crosstalk&) const = default;
};

/// Value that is subtracted from a reading.
struct Tare {
  bool first_reading = false;  ///< subtracts each taxel's first reading instead of `value`
  double value = 0;            ///< subtracted value [U]
  bool operator==(const Tare&) const = default;
};

/// Range to which values are clipped.
struct ValueRange {
  double low = 0, high = 0;  ///< limits [V]
  bool operator==(const ValueRange&) const = default;
};

/// Quantisation by a step or by a number of bits. Exactly one of the two is set.
struct Quantisation {
  std::optional<double> step;  ///< distance of levels [V]
  std::optional<int> bits;     ///< 2^bits levels over the range, both ends included
  bool operator==(const Quantisation&) const = default;
};

/// Taxels that report a constant value, chosen at random.
struct DeadTaxels {
  double fraction = 0;  ///< probability that a taxel is dead
  double value = 0;     ///< value that a dead taxel reports [V]
  bool operator==(const DeadTaxels&) const = default;
};

/// Calibration of a single taxel, used instead of the common value and without its random deviation.
struct TaxelCalibration {
  int id = 0;
  std::optional<double> tare;  ///< subtracted value [U]
  std::optional<double> gain;  ///< gain [V/U]
  Curve curve;
  std::optional<double> dead;  ///< constant value that the taxel reports [V]
  bool operator==(const TaxelCalibration&) const = default;
};

/// All settings. A part that is not set does nothing.
struct Calibration {
  std::uint64_t seed = 42;
  std::string unit;  ///< name of V; if empty, the unit of the readings
  std::optional<Hysteresis> hysteresis;
  std::optional<Crosstalk> crosstalk;
  std::optional<Tare> tare;
  double tare_deviation = 0;   ///< standard deviation between taxels [U]
  std::optional<double> gain;  ///< gain [V/U]; 1 if there is neither gain nor curve
  Curve curve;                 ///< curve instead of a gain
  double gain_deviation = 0;   ///< relative standard deviation between taxels
  double noise = 0;            ///< standard deviation between values [V]
  std::optional<ValueRange> range;
  std::optional<Quantisation> quantisation;
  std::optional<double> rate;  ///< sampled values per second
  std::optional<DeadTaxels> dead;
  std::vector<TaxelCalibration> taxels;
  bool operator==(const Calibration&) const = default;
};

}  // namespace taxel
