#include "app/studio/nouns/table/sensor_rows.h"

#include <algorithm>
#include <string>

namespace taxel::ui {

namespace {

bool passes_filter(const std::string& filter, const SensorShown& sensor, const Taxel& taxel) {
  return filter.empty() || std::to_string(taxel.id).find(filter) != std::string::npos ||
         contains_word(taxel.name, filter) || contains_word(sensor.name, filter);
}

int samples_of(const SensorShown& sensor, std::size_t taxel) {
  const auto& first = sensor.model->fields.first;
  return static_cast<int>(first[taxel + 1] - first[taxel]);
}

double reading_of(const SensorShown& sensor, std::size_t taxel) {
  return taxel < sensor.step->readings.size() ? sensor.unit.scale * sensor.step->readings[taxel] : 0.0;
}

double shear_of(const SensorShown& sensor, std::size_t taxel) {
  return taxel < sensor.step->shear.size() ? sensor.unit.scale * glm::length(sensor.step->shear[taxel]) : 0.0;
}

double slip_of(const SensorShown& sensor, std::size_t taxel) {
  return taxel < sensor.step->slip.size() ? sensor.step->slip[taxel] : 0.0;
}

/// Returns whether a row comes before another one in ascending order of a column.
bool comes_before(TableColumn column, const std::vector<SensorShown>& sensors, const SensorRow& a, const SensorRow& b) {
  const SensorShown &first = sensors[a.sensor], &second = sensors[b.sensor];
  switch (column) {
    case TableColumn::sensor:
      return first.name < second.name;
    case TableColumn::name:
      return first.taxels()[a.taxel].name < second.taxels()[b.taxel].name;
    case TableColumn::samples:
      return samples_of(first, a.taxel) < samples_of(second, b.taxel);
    case TableColumn::reading:
      return reading_of(first, a.taxel) < reading_of(second, b.taxel);
    case TableColumn::shear:
      return shear_of(first, a.taxel) < shear_of(second, b.taxel);
    case TableColumn::slip:
      return slip_of(first, a.taxel) < slip_of(second, b.taxel);
    default:
      return first.taxels()[a.taxel].id < second.taxels()[b.taxel].id;
  }
}

}  // namespace

std::vector<SensorRow> sensor_rows(const TableState& table, const std::vector<SensorShown>& sensors) {
  std::vector<SensorRow> rows;
  for (std::size_t s = 0; s < sensors.size(); ++s)
    for (std::size_t k = 0; k < sensors[s].taxels().size(); ++k)
      if (passes_filter(table.filter, sensors[s], sensors[s].taxels()[k])) rows.push_back({s, k});
  if (!table.sorted) return rows;
  std::stable_sort(rows.begin(), rows.end(), [&](const SensorRow& a, const SensorRow& b) {
    return table.descending ? comes_before(*table.sorted, sensors, b, a) : comes_before(*table.sorted, sensors, a, b);
  });
  return rows;
}

}  // namespace taxel::ui
