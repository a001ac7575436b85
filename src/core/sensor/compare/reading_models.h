// One contact as several models of a taxel read it, and how alike their curves are. Plain values.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// What each is: docs/theory.md, "Other models of the same contact".
enum class ReadingModel {
  reading,       ///< the layout as it is
  star,          ///< the layout with a star field
  weighted_sum,  ///< sum of w p over the layout's own hits
  exact,         ///< the layout's aggregate as an integral
  tactile,       ///< depth by MuJoCo's `<tactile>` sensor
  touch          ///< normal force by one of MuJoCo's `<touch>` sensors for each taxel
};
inline constexpr std::array kReadingModels{ReadingModel::reading, ReadingModel::star,    ReadingModel::weighted_sum,
                                           ReadingModel::exact,   ReadingModel::tactile, ReadingModel::touch};

/// A stable word: "reading", "star", "weighted_sum", "exact", "tactile", "touch".
const char* to_word(ReadingModel model);
/// In which its values are: that of the layout's readings, or its own. SI.
const char* unit_of(ReadingModel model, Aggregate aggregate);

/// What one model says of one step.
struct ModelReading {
  std::vector<double> values;  ///< by taxel, unit_of(); NaN where there is none
  std::string missing;         ///< why a value, or all of them, are missing or left something out; empty: nothing is
  [[nodiscard]] bool has(std::size_t taxel) const;
};

/// What all of them say.
struct ModelReadings {
  std::array<ModelReading, kReadingModels.size()> by_model;
  [[nodiscard]] ModelReading& operator[](ReadingModel m) { return by_model[static_cast<std::size_t>(m)]; }
  [[nodiscard]] const ModelReading& operator[](ReadingModel m) const { return by_model[static_cast<std::size_t>(m)]; }
};

/// A curve beside the exact one.
struct CurveComparison {
  double peak = 0;          ///< largest value, in its unit
  double largest_step = 0;  ///< between neighbours, as a part of `peak`
  /// Pearson's; none where one of the two does not change.
  std::optional<double> correlation;
  /// Root of the mean square of g c - e, with the gain g that makes it least, as a part of the exact curve's peak;
  /// none where that is 0.
  std::optional<double> rms;
};

/// Both by step; steps where one of the two is NaN are left out of what compares them, and of the largest step.
CurveComparison compare_curve(std::span<const double> curve, std::span<const double> exact);

}  // namespace taxel
