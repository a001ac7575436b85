// A taxel layout: plain values with the content of a `*.taxels.json` file. Lengths are in metres in the frame M of the
// mesh file (after `scale`), angles in degrees if the name says so.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/material.h"
#include "core/base/math.h"
#include "core/base/shared_value.h"
#include "core/mesh/repair/repair_recipe.h"

namespace taxel {

// The settings of a layout's calibration (`calibration` in its file), which converts raw readings to the values that a
// device would report. Plain values; core/sensor/calibration.h has the formulas and their order. U is the unit of the
// raw readings ([Pa], or [N] for Aggregate::force), V that of the calibrated values.

/// A corner of a piecewise-linear curve.
struct CurvePoint {
  double reading = 0;  ///< reading [U], ascending along a curve
  double value = 0;    ///< reported value [V]
  bool operator==(const CurvePoint&) const = default;
};
using Curve = std::vector<CurvePoint>;  ///< at least two points, or empty if there is no curve

/// Curve of the sensing element, before all parts that depend on time: a polynomial or points. Exactly one of the two
/// is set.
struct Response {
  std::vector<double> polynomial;  ///< factors of the reading, its square and so on, at most kMostPowers
  double up_to = 0;                ///< reading up to which the polynomial is valid [U]; a straight line follows
  Curve points;                    ///< ascending readings and values, both in U
  bool operator==(const Response&) const = default;
};
inline constexpr std::size_t kMostPowers = 4;  ///< largest power of Response::polynomial

/// A part of the reading that decays while the load is constant.
struct RelaxationArm {
  double amplitude = 0;  ///< fraction of the reading that is lost in the end, 0 to 1
  double time = 0;       ///< time constant [s]
  bool operator==(const RelaxationArm&) const = default;
};

/// A further play operator of the hysteresis.
struct Play {
  double width = 0;     ///< width of its loop [U]
  double fraction = 0;  ///< fraction of the reading that goes through it, 0 to 1
  bool operator==(const Play&) const = default;
};

/// Difference between the values while loading and while unloading. The reading has the remaining fraction unchanged.
struct Hysteresis {
  double width = 0;     ///< width of the loop between loading and unloading [U]
  double fraction = 1;  ///< fraction of the reading that has hysteresis, 0 to 1
  std::vector<Play> plays;
  bool operator==(const Hysteresis&) const = default;
};

/// Low pass of first order. Exactly one of the two is set.
struct LowPass {
  std::optional<double> time;    ///< time constant [s]
  std::optional<double> cutoff;  ///< frequency at which the amplitude falls to 1 / sqrt(2) [Hz]
  bool operator==(const LowPass&) const = default;
};

/// Row k has the factors of the readings of all taxels in the value of taxel k, both in layout order.
using CrosstalkMatrix = std::vector<std::vector<double>>;

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
  std::optional<Response> response;
  std::vector<RelaxationArm> relaxation;
  std::optional<Hysteresis> hysteresis;
  std::optional<LowPass> low_pass;
  std::optional<Crosstalk> crosstalk;
  CrosstalkMatrix crosstalk_matrix;  ///< square, instead of `crosstalk`; empty if there is none
  std::optional<Tare> tare;
  double tare_deviation = 0;   ///< standard deviation between taxels [U]
  std::optional<double> gain;  ///< gain [V/U]; 1 if there is neither gain nor curve
  Curve curve;                 ///< curve instead of a gain
  double gain_deviation = 0;   ///< relative standard deviation between taxels
  double noise = 0;            ///< standard deviation between values [V]
  std::optional<ValueRange> range;
  std::optional<Quantisation> quantisation;
  std::optional<double> rate;  ///< sampled values per second
  double latency = 0;          ///< delay of the reported values [s], to the nearest step
  std::optional<DeadTaxels> dead;
  std::vector<TaxelCalibration> taxels;
  bool operator==(const Calibration&) const = default;
};

enum class Metric { euclidean, geodesic };
enum class FieldNormals { face, interpolated };
enum class Misses { zero, omit };
enum class SampleWeights { equal, voronoi };
enum class Shells { outer, all };
enum class RayDirection { surface_normal, taxel_normal };
enum class Aggregate { weighted_mean, weighted_sum, mean, nearest, max, force };
enum class ReadingMethod { samples, exact };

struct Subtaxel {
  dvec3 center{0}, normal{0, 0, 1};
  double radius = 0.0;
  bool operator==(const Subtaxel&) const = default;
};

struct Taxel {
  int id = 0;
  std::string name;
  dvec3 center{0};        ///< centre [m], frame M
  dvec3 normal{0, 0, 1};  ///< outward normal of any length
  double radius = 0.006;  ///< radius of the receptive field [m]
  std::vector<Subtaxel> subtaxels;
  double density = 0.0;  ///< samples per m^2 in the field if above Sampling::density; 0 if not set
  bool operator==(const Taxel&) const = default;
};

struct MeshRef {
  std::string file;  ///< path, relative to the layout file or absolute
  dvec3 scale{1.0};
  std::string sha256;     ///< hash of the mesh file's bytes; unchecked if empty
  RepairRecipe repair{};  ///< settings of the repair of the mesh
  bool operator==(const MeshRef&) const = default;
};

/// The direction in which the finger points and the direction of its touching side, in frame M; unit vectors at right
/// angles.
struct SensorFrame {
  dvec3 distal{0, 0, 1}, pad{0, -1, 0};
  bool operator==(const SensorFrame&) const = default;
};

/// Faces of the loaded mesh, ascending.
using FaceSet = SharedValue<std::vector<int>>;

struct Sampling {
  double density = 1.0e7;  ///< samples per m^2
  std::uint64_t seed = 42;
  SampleWeights weights = SampleWeights::equal;
  Shells shells = Shells::outer;  ///< `all` also samples shells inside others (cavities and islands)
  FaceSet region{};               ///< sensing region: only these faces have samples; all faces if empty
  bool operator==(const Sampling&) const = default;
};

struct ReceptiveFieldRule {
  Metric metric = Metric::euclidean;
  double max_angle_deg = 45.0;
  double angle_falloff_deg = 0.0;             ///< width of the roll-off below max_angle_deg; 0 cuts the field there
  FieldNormals normals = FieldNormals::face;  ///< normals of the skin that the angle refers to
  bool operator==(const ReceptiveFieldRule&) const = default;
};

struct Readout {
  Aggregate aggregate = Aggregate::weighted_mean;
  ReadingMethod method = ReadingMethod::samples;  ///< rays from samples, or integrals over the contact polygons
  Misses misses = Misses::zero;
  RayDirection ray = RayDirection::surface_normal;
  double max_depth = 0.0;  ///< [m]; 0 means twice the thickness (pad) or the largest radius (star)
  bool shear = false;      ///< also records the friction on each taxel
  bool operator==(const Readout&) const = default;
};

struct Layout {
  std::string name;
  MeshRef mesh;
  SensorFrame frame;
  Sampling sampling;
  ReceptiveFieldRule receptive_field;
  Readout readout;
  Material material{FieldKind::pad, 5.0e4, 0.002, 5.0, 0.5};
  std::vector<Taxel> taxels;  ///< taxels in the order of the readings
  std::optional<Calibration> calibration;
  /// Unknown keys of the file, as JSON pointer and JSON text. They are written back at the same places.
  std::map<std::string, std::string> unknown;
  bool operator==(const Layout&) const = default;
};

}  // namespace taxel
