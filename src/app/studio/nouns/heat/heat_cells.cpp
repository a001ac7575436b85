#include "app/studio/nouns/heat/heat_cells.h"

#include <algorithm>
#include <cmath>

#include "core/sensor/readout/reading.h"

namespace taxel::ui {

namespace {

/// Returns the largest recorded reading of each taxel of all sensors.
std::vector<double> largest_recorded(const HistoryLanes& lanes) {
  std::vector<double> largest(lanes.reading_count, 0.0);
  for (std::size_t row = 0; row < lanes.rows(); ++row) {
    const std::span<const double> readings = lanes.readings_of(row);
    for (std::size_t k = 0; k < readings.size(); ++k) largest[k] = std::max(largest[k], readings[k]);
  }
  return largest;
}

}  // namespace

std::vector<HeatRow> heat_rows(const HistoryLanes& lanes, const std::vector<SensorShown>& sensors,
                               const Selection& selection, bool responding_only) {
  std::vector<HeatRow> rows;
  const std::vector<double> largest = responding_only ? largest_recorded(lanes) : std::vector<double>{};
  const auto largest_of = [&](const ReadingUnit& unit) {
    double most = 0;
    for (const SensorShown& sensor : sensors)
      for (std::size_t k = 0; same_unit(sensor.unit, unit) && k < sensor.taxels().size(); ++k)
        if (sensor.first + k < largest.size()) most = std::max(most, largest[sensor.first + k]);
    return most;
  };
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    const SensorShown& sensor = sensors[s];
    const double least = responding_only ? kTaxelResponds * largest_of(sensor.unit) : 0.0;
    for (std::size_t k = 0; k < sensor.taxels().size() && sensor.first + k < lanes.reading_count; ++k) {
      const TaxelKey key{sensor.index, sensor.taxels()[k].id};
      if (responding_only && !(largest[sensor.first + k] > least) && !is_selected(selection, key)) continue;
      rows.push_back({key, taxel_label(sensors, sensor, key.id), s, sensor.first + k});
    }
  }
  return rows;
}

std::optional<std::size_t> HeatPlaces::row_at(float y) const {
  const auto above = std::upper_bound(tops.begin(), tops.end(), y);
  if (above == tops.begin()) return std::nullopt;
  const auto at = static_cast<std::size_t>(above - tops.begin()) - 1;
  return y < tops[at] + row ? std::optional(at) : std::nullopt;
}

HeatPlaces place_rows(const std::vector<HeatRow>& rows, float height, float least, float most, float gap) {
  HeatPlaces places;
  if (rows.empty()) return places;
  const std::size_t groups = rows.back().sensor - rows.front().sensor + 1;
  const float gaps = gap * static_cast<float>(groups - 1);
  places.row = std::clamp((height - gaps) / static_cast<float>(rows.size()), least, most);
  float y = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && rows[i].sensor != rows[i - 1].sensor) y += gap;
    places.tops.push_back(y);
    y += places.row;
  }
  places.height = y;
  return places;
}

HeatCells heat_cells(const HistoryLanes& lanes, const std::vector<HeatRow>& rows, std::size_t columns) {
  HeatCells cells;
  const std::size_t steps = lanes.rows();
  cells.columns = std::clamp<std::size_t>(columns, 1, steps);
  cells.steps.resize(rows.size() * cells.columns);
  for (std::size_t column = 0; column < cells.columns; ++column) {
    const std::size_t first = column * steps / cells.columns, last = (column + 1) * steps / cells.columns;
    for (std::size_t r = 0; r < rows.size(); ++r)
      cells.steps[r * cells.columns + column] = static_cast<std::uint32_t>(first);
    for (std::size_t step = first + 1; step < last; ++step) {
      const std::span<const double> readings = lanes.readings_of(step);
      for (std::size_t r = 0; r < rows.size(); ++r) {
        std::uint32_t& largest = cells.steps[r * cells.columns + column];
        if (readings[rows[r].reading] > lanes.readings_of(largest)[rows[r].reading])
          largest = static_cast<std::uint32_t>(step);
      }
    }
  }
  return cells;
}

int heat_level(const PressureRange& range, double reading) {
  if (!(range.hi > range.lo) || !(reading > range.lo)) return 0;
  const double part = std::min(1.0, (reading - range.lo) / (range.hi - range.lo));
  return std::max(1, static_cast<int>(std::ceil(kHeatLevels * part)));
}

std::vector<HeatRun> heat_runs(const HistoryLanes& lanes, const std::vector<HeatRow>& rows, const HeatCells& cells,
                               const std::vector<PressureRange>& ranges) {
  std::vector<HeatRun> runs;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    HeatRun run{r, 0, 0, 0};
    for (std::size_t column = 0; column < cells.columns; ++column) {
      const double reading = lanes.readings_of(cells.step(r, column))[rows[r].reading];
      const int level = heat_level(ranges[rows[r].sensor], reading);
      if (level != run.level) {
        if (run.level > 0) runs.push_back(run);
        run.first = column;
        run.level = level;
      }
      run.last = column + 1;
    }
    if (run.level > 0) runs.push_back(run);
  }
  return runs;
}

}  // namespace taxel::ui
