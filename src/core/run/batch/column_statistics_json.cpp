#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/base/text/json_text.h"
#include "core/run/batch/column_statistics.h"

namespace taxel {

void ComponentStatistics::add(double value) {
  min = std::min(min, value);
  max = std::max(max, value);
  ++count;
  const double before = value - mean;
  mean += before / static_cast<double>(count);
  squares += before * (value - mean);
}

void add_cells(const ParquetCells& cells, ColumnStatistics& statistics) {
  const std::size_t width = statistics.components.size();
  const auto add = [&]<class Value>(const std::vector<Value>& values) {
    if constexpr (!std::is_same_v<Value, std::string>)
      for (std::size_t i = 0; i < values.size(); ++i)
        statistics.components[i % width].add(static_cast<double>(values[i]));
  };
  if (width > 0) std::visit(add, cells.values);
}

std::string statistics_to_json(const std::vector<ColumnStatistics>& columns) {
  using Json = nlohmann::ordered_json;
  Json all = Json::object();
  for (const ColumnStatistics& column : columns) {
    if (column.components.empty() || column.components.front().count == 0) continue;
    Json min = Json::array(), max = Json::array(), mean = Json::array(), deviation = Json::array();
    for (const ComponentStatistics& component : column.components) {
      min.push_back(component.min);
      max.push_back(component.max);
      mean.push_back(component.mean);
      deviation.push_back(std::sqrt(component.squares / static_cast<double>(component.count)));
    }
    all[column.name] = {
        {"min", min}, {"max", max}, {"mean", mean}, {"std", deviation}, {"count", {column.components.front().count}}};
  }
  return json_text(all);
}

}  // namespace taxel
