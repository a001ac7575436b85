// The calibration of a layout, `calibration` in its file: how a device would report the raw readings. Plain values; the
// formulas and their order stand in core/sensor/calibration.h. U is the unit of the raw readings ([Pa], or [N] for
// Aggregate::force), V that of the calibrated values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace taxel {

/// A corner of a piecewise-linear curve.
struct CurvePoint {
  double reading = 0;  ///< [U], ascending along a curve
  double value = 0;    ///< [V]
  bool operator==(const CurvePoint&) const = default;
};
using Curve = std::vector<CurvePoint>;  ///< at least two points; empty: none

struct Hysteresis {
  double width = 0;     ///< width of the loop between loading and unloading [U]
  double fraction = 1;  ///< fraction of the reading that has hysteresis, 0 to 1
  bool operator==(const Hysteresis&) const = default;
};

struct Crosstalk {
  double fraction = 0;  ///< fraction of a neighbour's reading that is added at distance 0
  double reach = 0;     ///< distance of centres from which nothing is added [m]
  bool operator==(const Crosstalk&) const = default;
};

struct Tare {
  bool first_reading = false;  ///< each taxel's reading at the start; otherwise `value`
  double value = 0;            ///< [U]
  bool operator==(const Tare&) const = default;
};

struct ValueRange {
  double low = 0, high = 0;  ///< [V]
  bool operator==(const ValueRange&) const = default;
};

/// One of the two is given.
struct Quantisation {
  std::optional<double> step;  ///< [V]
  std::optional<int> bits;     ///< 2^bits levels over the range, both ends included
  bool operator==(const Quantisation&) const = default;
};

struct DeadTaxels {
  double fraction = 0;  ///< chance of each taxel
  double value = 0;     ///< value that a dead taxel reports [V]
  bool operator==(const DeadTaxels&) const = default;
};

/// Calibration of a single taxel, used instead of the common value and without its random deviation.
struct TaxelCalibration {
  int id = 0;
  std::optional<double> tare;  ///< [U]
  std::optional<double> gain;  ///< [V/U]
  Curve curve;
  std::optional<double> dead;  ///< reports this always [V]
  bool operator==(const TaxelCalibration&) const = default;
};

struct Calibration {
  std::uint64_t seed = 42;
  std::string unit;  ///< name of V; empty: that of the readings
  std::optional<Hysteresis> hysteresis;
  std::optional<Crosstalk> crosstalk;
  std::optional<Tare> tare;
  double tare_deviation = 0;   ///< standard deviation between taxels [U]
  std::optional<double> gain;  ///< [V/U]; none, and no curve: 1
  Curve curve;                 ///< instead of a gain
  double gain_deviation = 0;   ///< standard deviation between taxels, relative
  double noise = 0;            ///< standard deviation between values [V]
  std::optional<ValueRange> range;
  std::optional<Quantisation> quantisation;
  std::optional<double> rate;  ///< values per second
  std::optional<DeadTaxels> dead;
  std::vector<TaxelCalibration> taxels;
  bool operator==(const Calibration&) const = default;
};

}  // namespace taxel
