// Statistics of the columns of a data set, with which learners scale their inputs.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/run/parquet/parquet.h"

namespace taxel {

/// Numbers of one component of a column.
struct ComponentStatistics {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
  double mean = 0;
  double squares = 0;  ///< sum of the squared differences from the mean
  std::int64_t count = 0;

  /// Follows one value (Welford 1962).
  void add(double value);
};

struct ColumnStatistics {
  std::string name;
  std::vector<ComponentStatistics> components;
};

/// Adds cells to the statistics of a column. With as many components as each row has values, a component follows its
/// place in the rows; with one component, it follows all values.
void add_cells(const ParquetCells& cells, ColumnStatistics& statistics);

/// Returns the text of meta/stats.json. Columns without values are left out.
std::string statistics_to_json(const std::vector<ColumnStatistics>& columns);

}  // namespace taxel
