// The readings of one contact by several models of a taxel, a comparison of their curves, and the choice of the contact
// that a second layout reads. Plain values.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// A model of a taxel: see docs/theory/sensor.md, "Other models of the same contact".
enum class ReadingModel {
  reading,       ///< layout as it is
  star,          ///< layout with a star field
  weighted_sum,  ///< sum of w p over the layout's own hits
  exact,         ///< exact reading (field_integral.h)
  tactile,       ///< depth by MuJoCo's `<tactile>` sensor
  touch,         ///< normal force by one of MuJoCo's `<touch>` sensors for each taxel
  finer,         ///< layout as it is, with bodies whose edges are half as long
  second         ///< another layout in the place of the sensor
};
/// The models that are compared with each other for any layout.
inline constexpr std::array kReadingModels{ReadingModel::reading, ReadingModel::star,    ReadingModel::weighted_sum,
                                           ReadingModel::exact,   ReadingModel::tactile, ReadingModel::touch};

/// Returns the word of a model in files: "reading", "star", "weighted_sum", "exact", "tactile", "touch", "finer" or
/// "second".
const char* to_word(ReadingModel model);
/// Returns the SI unit of a model's values: the unit of the layout's readings, or the model's own.
const char* unit_of(ReadingModel model, Aggregate aggregate);

/// The readings of one contact by one model.
struct ModelReading {
  ReadingModel model = ReadingModel::reading;
  std::vector<double> values;  ///< one per taxel in unit_of(); NaN for a missing value
  std::string missing;         ///< why values are missing or incomplete, or empty
  [[nodiscard]] bool has(std::size_t taxel) const;
};

/// The readings of one contact by several models.
struct ModelReadings {
  std::vector<ModelReading> models;  ///< each model at most once
  std::vector<double> bars;          ///< error bar of each reading, in its unit; empty if not measured

  /// Returns the readings of a model; without values and without a reason if that model has not read the contact.
  [[nodiscard]] const ModelReading& operator[](ReadingModel model) const;
};

/// A comparison of a curve with the exact one.
struct CurveComparison {
  double peak = 0;          ///< largest value, in its unit
  double largest_step = 0;  ///< largest step between neighbours, as a fraction of `peak`
  /// Pearson's correlation. Empty if one of the curves is constant.
  std::optional<double> correlation;
  /// Root of the mean square of g c - e with the best gain g, as a fraction of the exact curve's peak. Empty if that
  /// peak is 0.
  std::optional<double> rms;
};

/// Compares two curves with one value per step. Steps with a NaN are excluded.
CurveComparison compare_curve(std::span<const double> curve, std::span<const double> exact);

/// The readings of one step of a run.
struct ComparedStep {
  std::uint64_t step = 0;
  double time = 0, travel = 0;  ///< [s], [m]
  ModelReadings readings;
  bool after_gap = false;  ///< rows of the run are missing between the previous step of a list and this one
};
using ComparedStepPtr = std::shared_ptr<const ComparedStep>;
using ComparedStepList = std::vector<ComparedStepPtr>;

/// Returns the readings of one taxel (index) over steps; NaN for steps without a value.
std::vector<double> model_curve(std::span<const ComparedStepPtr> steps, ReadingModel model, std::size_t taxel);

/// Compares the curve of one taxel (index) over steps with the exact one.
CurveComparison compare_with_exact(std::span<const ComparedStepPtr> steps, ReadingModel model, std::size_t taxel);

/// The columns of one model in a table: `prefix` and the id of each taxel.
struct ModelColumns {
  ReadingModel model = ReadingModel::reading;
  std::string prefix;
  std::vector<int> ids;  ///< ids of the taxels, in layout order
};
/// Returns the columns of the taxels of a layout.
ModelColumns columns_of(ReadingModel model, const std::string& prefix, const Layout& layout);
/// Returns a table with time, travel and these columns, one row per step, in SI units. A value that is missing is
/// empty; every number is in the shortest form that reads back exactly.
std::string readings_to_csv(std::span<const ComparedStepPtr> steps, std::span<const ModelColumns> columns);

/// The contact that a second layout reads.
enum class SecondContact {
  recorded,  ///< surfaces of the first layout, as they were recorded
  own        ///< surfaces of the second layout's own body, in the recorded poses
};

}  // namespace taxel
