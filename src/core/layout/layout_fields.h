// The settings of a layout, one row each: its place in the file, its label and unit in the window, and the values that
// it accepts. Reading, writing, the list of known keys, the check of values and the inspector go through these rows, so
// that a new setting is a member, a row here, and its description in assets/schema/layout.schema.json.
#pragma once

#include <cstdint>
#include <tuple>
#include <type_traits>

#include "core/base/text/field_spec.h"
#include "core/layout/layout.h"

namespace taxel {

/// How a layout file has a setting.
enum class Presence {
  always,   ///< always written; the default if it is missing
  sparse,   ///< written only if it differs from the default
  required  ///< always written; a file without it is refused
};

/// A setting. `code` and `fix` are those of the Problem that a value outside of `spec.range` gives.
struct LayoutField {
  FieldSpec spec;
  Presence presence = Presence::always;
  const char* code = "";
  const char* fix = "";
  std::uint64_t largest = 0;  ///< limit of a whole number that a user enters
};

/// A setting that is the member `value` of S.
template <class S, class T>
struct FieldRow {
  T S::*value;
  LayoutField field;
};

namespace layout_rows {

using enum FieldQuantity;
using enum FieldRange;
using enum Presence;

/// Largest seed. A double represents every whole number up to 2^53 exactly.
constexpr std::uint64_t kLargestSeed = std::uint64_t{1} << 53U;

/// A row of a value that is no number: a word, a text, a switch, a direction or an object of its own.
template <class S, class T>
constexpr FieldRow<S, T> row(T S::*value, const char* key, const char* label, const char* help,
                             Presence presence = always) {
  return {value, {{key, label, help, FieldQuantity::number}, presence}};
}
/// A row of a number.
template <class S, class T>
constexpr FieldRow<S, T> row(T S::*value, const FieldSpec& spec, Presence presence = always, const char* code = "",
                             const char* fix = "") {
  return {value, {spec, presence, code, fix}};
}

/// A row of a whole number from 0 to `largest`.
template <class S, class T>
constexpr FieldRow<S, T> row(T S::*value, const char* key, const char* label, const char* help, std::uint64_t largest,
                             Presence presence = always) {
  return {value, {{key, label, help, number}, presence, "", "", largest}};
}

/// A length of a repair recipe.
constexpr FieldRow<RepairRecipe, std::optional<double>> repair_row(std::optional<double> RepairRecipe::*value,
                                                                   const char* key, const char* label, const char* help,
                                                                   FieldQuantity quantity = length) {
  return {value,
          {{key, label, help, quantity, positive}, sparse, "repair_out_of_range", "leave it out for its default"}};
}

inline constexpr std::tuple kRepair{
    row(&RepairRecipe::level, "level", "Repair", "How far a repair may go", sparse),
    repair_row(&RepairRecipe::join, "join", "Join", "Largest distance over which rims are joined"),
    repair_row(&RepairRecipe::fill, "fill", "Fill", "Widest hole that is filled without a warning"),
    repair_row(&RepairRecipe::edge, "edge", "Edge", "Edge length of a wrap"),
    repair_row(&RepairRecipe::tolerance, "tolerance", "Tolerance", "Largest simplification error of a wrap"),
    repair_row(&RepairRecipe::refine, "refine", "Refine", "Longest edge of a soft skin, in thicknesses of the pad",
               number)};

inline constexpr std::tuple kMesh{
    row(&MeshRef::file, "file", "Mesh", "Mesh file, relative to the layout file or absolute", required),
    row(&MeshRef::scale, "scale", "Scale", "Factors of the file's coordinates"),
    row(&MeshRef::sha256, "sha256", "SHA-256", "Hash of the mesh file's bytes; empty: not compared"),
    row(&MeshRef::repair, "repair", "Repair", "How the mesh is repaired", sparse)};

inline constexpr std::tuple kFrame{
    row(&SensorFrame::distal, "distal", "Distal", "Where the finger points, in the frame of the mesh file"),
    row(&SensorFrame::pad, "pad", "Pad", "Where it touches, at right angles to distal")};

inline constexpr std::tuple kSampling{
    row(&Sampling::density,
        {"density", "Density", "Samples per area of skin. The paper uses 1 to 10 per mm\u00b2", density, positive},
        always, "density_not_positive", "1e7 per square metre is a good start"),
    row(&Sampling::seed, "seed", "Seed", "The same seed gives the same samples on every machine", kLargestSeed),
    row(&Sampling::weights, "weights", "Weights",
        "Area of skin per sample: an equal part, or the area nearest to it (Voronoi)"),
    row(&Sampling::shells, "shells", "Shells",
        "Closed surfaces that are sampled: outer ones, or those inside of them as well", sparse),
    row(&Sampling::region, "region", "Painted region", "Faces of the mesh that have samples; empty: all", sparse)};

inline constexpr std::tuple kReceptiveField{
    row(&ReceptiveFieldRule::metric, "metric", "Metric",
        "Distances from a taxel's centre: straight (the paper), or along the surface"),
    row(&ReceptiveFieldRule::max_angle_deg,
        {"max_angle_deg", "Largest angle", "Between a taxel's normal and those of its samples. The paper uses 45\u00b0",
         angle}),
    row(&ReceptiveFieldRule::angle_falloff_deg,
        {"angle_falloff_deg", "Roll-off",
         "Weights fade to 0 over this angle below the largest one. 0: a hard cut, as in the paper", angle},
        sparse),
    row(&ReceptiveFieldRule::normals, "normals", "Normals",
        "Of the skin, for the angle: of each face (the paper), or interpolated between the vertices", sparse)};

inline constexpr std::tuple kReadout{
    row(&Readout::aggregate, "aggregate", "Aggregate", "How a taxel's samples make its reading"),
    row(&Readout::method, "method", "Method",
        "Rays from the samples (the paper), or exact integrals over the contact polygons: for weighted_mean, mean and "
        "force",
        sparse),
    row(&Readout::misses, "misses", "Misses", "A ray that meets nothing counts as zero, or is left out"),
    row(&Readout::ray, "ray", "Ray direction", "Against the normal of the skin at each sample, or of the taxel"),
    row(&Readout::max_depth,
        {"max_depth", "Largest depth",
         "How far rays go. 0: twice the thickness of a pad, the largest radius for a star", length, not_negative},
        always, "depth_negative"),
    row(&Readout::shear, "shear", "Shear", "Also record the friction on each taxel", sparse)};

inline constexpr std::tuple kMaterial{
    row(&Material::field, "field", "Field",
        "How pressure grows inside: a pad over a rigid core, or tetrahedra from the centroid (the paper's released "
        "code)"),
    row(&Material::modulus,
        {"modulus", "Modulus", "Hydroelastic modulus: the pressure at full depth. 0: rigid", pressure, not_negative},
        always, "modulus_negative"),
    row(&Material::thickness, {"thickness", "Thickness", "Of the pad. 0: chosen from the size", length, not_negative},
        always, "thickness_negative"),
    row(&Material::dissipation,
        {"dissipation", "Dissipation", "Damping of Hunt and Crossley", inverse_speed, not_negative}, always,
        "dissipation_negative"),
    row(&Material::friction, {"friction", "Friction", "Coefficient of Coulomb", number, not_negative}, always,
        "friction_negative"),
    row(&Material::faces, "faces", "Faces",
        "Which faces of a touching body count: those along the pressure's gradient, so that a thin plate feels its "
        "near face, or all",
        sparse),
    row(&Material::tangential_stiffness,
        {"tangential_stiffness", "Tangential stiffness",
         "Of friction that sticks and slips: shear modulus over thickness. 0: friction has no memory, and held objects "
         "creep",
         pressure_per_length, not_negative},
        sparse, "stiffness_negative"),
    row(&Material::bristles, "bristles", "Bristles", "Points of the skin that remember friction that sticks",
        kMostBristles, sparse),
    row(&Material::law, "law", "Pressure law",
        "Pressure over the modulus as a function of the strain: linear, stiffening, or a table", sparse)};

inline constexpr std::tuple kResponse{
    row(&Response::polynomial, "polynomial", "Polynomial", "Factors of the reading, its square and so on", sparse),
    row(&Response::up_to, "up_to", "Up to", "Reading where the polynomial ends and a straight line begins", sparse),
    row(&Response::points, "points", "Points", "Points of raw reading and response", sparse)};
inline constexpr std::tuple kRelaxationArm{
    row(&RelaxationArm::amplitude, "amplitude", "Amplitude", "Fraction of the reading that is lost in the end",
        required),
    row(&RelaxationArm::time, "time", "Time", "Time constant in seconds", required)};
inline constexpr std::tuple kPlay{
    row(&Play::width, "width", "Loop width", "Unit of the raw readings", required),
    row(&Play::fraction, "fraction", "Loop fraction", "Of the reading that goes through the loop, 0 to 1", required)};
inline constexpr std::tuple kHysteresis{
    row(&Hysteresis::width, "width", "Loop width", "Unit of the raw readings", required),
    row(&Hysteresis::fraction, "fraction", "Loop fraction", "Of the reading that goes through the loop, 0 to 1"),
    row(&Hysteresis::plays, "plays", "Further loops", "Widths and fractions of more play operators", sparse)};
inline constexpr std::tuple kLowPass{row(&LowPass::time, "time", "Time", "Time constant in seconds", sparse),
                                     row(&LowPass::cutoff, "cutoff", "Cut-off", "Frequency in hertz", sparse)};
inline constexpr std::tuple kCrosstalk{
    row(&Crosstalk::fraction, "fraction", "Crosstalk fraction", "Of a neighbour's reading at distance 0, 0 to 1",
        required),
    row(&Crosstalk::reach, "reach", "Crosstalk reach", "Distance of centres from which nothing is added", required)};
inline constexpr std::tuple kQuantisation{
    row(&Quantisation::step, "step", "Step", "Values are whole multiples of it", sparse),
    row(&Quantisation::bits, "bits", "Bits", "2^bits levels over the range", sparse)};
inline constexpr std::tuple kDeadTaxels{
    row(&DeadTaxels::fraction, "fraction", "Dead fraction", "Chance of each taxel, 0 to 1", required),
    row(&DeadTaxels::value, "value", "Dead value", "Unit of the reported value")};
inline constexpr std::tuple kTaxelCalibration{
    row(&TaxelCalibration::id, "id", "Id", "Of the taxel", required),
    row(&TaxelCalibration::tare, "tare", "Tare", "Value that is subtracted", sparse),
    row(&TaxelCalibration::gain, "gain", "Gain", "Reported units per unit of the raw readings", sparse),
    row(&TaxelCalibration::curve, "curve", "Curve", "Points of raw reading and reported value", sparse),
    row(&TaxelCalibration::dead, "dead", "Dead value", "Constant value that the taxel reports", sparse)};
inline constexpr std::tuple kCalibration{
    row(&Calibration::seed, "seed", "Calibration seed", "The same seed gives the same noise and the same dead taxels"),
    row(&Calibration::unit, "unit", "Reported unit", "Unit of the reported values; empty: that of the readings",
        sparse),
    row(&Calibration::response, "response", "Response", "Curve of the sensing element: a polynomial or points", sparse),
    row(&Calibration::relaxation, "relaxation", "Relaxation", "Readings of a constant load decay", sparse),
    row(&Calibration::hysteresis, "hysteresis", "Hysteresis", "Loading and unloading report different values", sparse),
    row(&Calibration::low_pass, "low_pass", "Low pass", "Time constant of a filter of first order", sparse),
    row(&Calibration::crosstalk, "crosstalk", "Crosstalk", "Neighbours' readings are added", sparse),
    row(&Calibration::crosstalk_matrix, "crosstalk_matrix", "Crosstalk matrix",
        "Factors of all readings in each value, taxels in layout order", sparse),
    row(&Calibration::quantisation, "quantisation", "Quantisation", "Levels of the reported values", sparse),
    row(&Calibration::dead, "dead", "Dead taxels", "Some taxels report one value always", sparse),
    row(&Calibration::tare, "tare", "Tare", "Value that the device subtracts from every reading", sparse),
    row(&Calibration::tare_deviation, "tare_deviation", "Tare deviation", "Standard deviation between taxels", sparse),
    row(&Calibration::gain, "gain", "Gain", "Reported units per unit of the raw readings", sparse),
    row(&Calibration::curve, "curve", "Curve", "Points of raw reading and reported value", sparse),
    row(&Calibration::gain_deviation, "gain_deviation", "Gain deviation",
        "Standard deviation between taxels, relative to the gain", sparse),
    row(&Calibration::noise, "noise", "Noise", "Standard deviation between values", sparse),
    row(&Calibration::range, "range", "Range", "Reported values are clamped to this range", sparse),
    row(&Calibration::rate, "rate", "Rate", "Values per second; empty: every step", sparse),
    row(&Calibration::latency, "latency", "Latency", "Delay of the reported values, to the nearest step", sparse),
    row(&Calibration::taxels, "taxels", "Of their own", "Calibrations of single taxels", sparse)};

constexpr const auto& of(std::type_identity<RepairRecipe>) {
  return kRepair;
}
constexpr const auto& of(std::type_identity<MeshRef>) {
  return kMesh;
}
constexpr const auto& of(std::type_identity<SensorFrame>) {
  return kFrame;
}
constexpr const auto& of(std::type_identity<Sampling>) {
  return kSampling;
}
constexpr const auto& of(std::type_identity<ReceptiveFieldRule>) {
  return kReceptiveField;
}
constexpr const auto& of(std::type_identity<Readout>) {
  return kReadout;
}
constexpr const auto& of(std::type_identity<Material>) {
  return kMaterial;
}
constexpr const auto& of(std::type_identity<Response>) {
  return kResponse;
}
constexpr const auto& of(std::type_identity<RelaxationArm>) {
  return kRelaxationArm;
}
constexpr const auto& of(std::type_identity<Play>) {
  return kPlay;
}
constexpr const auto& of(std::type_identity<LowPass>) {
  return kLowPass;
}
constexpr const auto& of(std::type_identity<Hysteresis>) {
  return kHysteresis;
}
constexpr const auto& of(std::type_identity<Crosstalk>) {
  return kCrosstalk;
}
constexpr const auto& of(std::type_identity<Quantisation>) {
  return kQuantisation;
}
constexpr const auto& of(std::type_identity<DeadTaxels>) {
  return kDeadTaxels;
}
constexpr const auto& of(std::type_identity<TaxelCalibration>) {
  return kTaxelCalibration;
}
constexpr const auto& of(std::type_identity<Calibration>) {
  return kCalibration;
}

}  // namespace layout_rows

/// A type of settings that has rows.
template <class S>
concept LayoutSettings = requires {
  layout_rows::of(std::type_identity<S>{});
};

/// Calls visit(field, member) for each setting of S, in the order of the file. `member` is a pointer to a member of S.
template <LayoutSettings S, class Visit>
constexpr void for_each_field(Visit&& visit) {
  std::apply([&](const auto&... row) { (visit(row.field, row.value), ...); }, layout_rows::of(std::type_identity<S>{}));
}

/// Calls visit(key, settings) for the parts of a layout that are JSON objects, in the order of the file, except for the
/// taxels and the calibration.
template <class L, class Visit>
void for_each_part(L& layout, Visit&& visit) {
  visit("mesh", layout.mesh);
  visit("frame", layout.frame);
  visit("sampling", layout.sampling);
  visit("receptive_field", layout.receptive_field);
  visit("readout", layout.readout);
  visit("material", layout.material);
}

}  // namespace taxel
