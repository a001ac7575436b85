#include "core/run/recording/recording.h"

#include <algorithm>
#include <cmath>

namespace taxel {
namespace {

TaxelSummary summarize_taxel(const Recording& recording, std::size_t sensor, std::size_t taxel) {
  TaxelSummary summary;
  summary.id = recording.sensors[sensor].taxel_ids[taxel];
  summary.name = recording.sensors[sensor].taxel_names[taxel];
  double step = 0;
  for (std::size_t i = 0; i < recording.rows.size(); ++i) {
    const double value = recording.rows[i].sensors[sensor].readings[taxel];
    summary.mean += value / static_cast<double>(recording.rows.size());
    if (value > summary.peak) {
      summary.peak = value;
      summary.peak_travel = recording.rows[i].travel;
    }
    if (i > 0) step = std::max(step, std::abs(value - recording.rows[i - 1].sensors[sensor].readings[taxel]));
  }
  for (const RecordedRow& row : recording.rows)
    if (recording.sensors[sensor].errors)
      summary.largest_error = std::max(summary.largest_error, row.sensors[sensor].errors[taxel]);
  summary.largest_step = summary.peak > 0 ? step / summary.peak : 0;
  return summary;
}

/// Sets the largest changes of the sensor's pose relative to the mocap body since the first row.
void add_deflection(const Recording& recording, std::size_t sensor, RecordedSensorSummary& summary) {
  const auto held = [&](const RecordedRow& row) {
    return recording.mocap[static_cast<std::size_t>(row.step)].inverse() * row.sensors[sensor].X_WM;
  };
  if (recording.rows.empty() || recording.mocap.empty()) return;
  const Pose start = held(recording.rows.front());
  for (const RecordedRow& row : recording.rows) {
    const Pose now = held(row);
    summary.deflection = std::max(summary.deflection, glm::length(now.p - start.p));
    const dquat turn = glm::conjugate(start.q) * now.q;
    const double angle = 2.0 * std::atan2(glm::length(dvec3(turn.x, turn.y, turn.z)), std::abs(turn.w));
    summary.deflection_deg = std::max(summary.deflection_deg, glm::degrees(angle));
  }
}

}  // namespace

std::vector<RecordedSensorSummary> summarize(const Recording& recording) {
  std::vector<RecordedSensorSummary> all;
  for (std::size_t s = 0; s < recording.sensors.size(); ++s) {
    RecordedSensorSummary summary;
    summary.geom = recording.sensors[s].geom;
    double largest = 0;
    for (std::size_t t = 0; t < recording.sensors[s].taxel_ids.size(); ++t) {
      summary.taxels.push_back(summarize_taxel(recording, s, t));
      largest = std::max(largest, summary.taxels.back().peak);
    }
    for (TaxelSummary& taxel : summary.taxels) taxel.responds = taxel.peak > kResponds * largest;
    for (const RecordedRow& row : recording.rows) {
      summary.largest_force = std::max(summary.largest_force, glm::length(row.sensors[s].force_W));
      summary.largest_uncovered = std::max(summary.largest_uncovered, glm::length(row.sensors[s].uncovered_W));
      summary.largest_area = std::max(summary.largest_area, row.sensors[s].area);
    }
    add_deflection(recording, s, summary);
    all.push_back(std::move(summary));
  }
  return all;
}

}  // namespace taxel
