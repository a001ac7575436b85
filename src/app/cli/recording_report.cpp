#include "app/cli/recording_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace taxel::cli {
namespace {

std::string object_text(const Scenario& scenario) {
  if (!scenario.object.empty()) return scenario.object;
  if (scenario.shape == ObjectShape::edge) return "an edge that points up";
  return fmt::format("the edge of a {}", to_word(scenario.shape));
}

std::string head_text(const RecordingReport& report) {
  const std::string rows = fmt::format("{} rows of {} steps of {} s", report.recording.rows.size(), report.cost.steps,
                                       report.recording.timestep);
  if (!report.scenario) return fmt::format("run of {}: {}\n", report.scene, rows);
  const Scenario& s = *report.scenario;
  const std::string& name = report.models.front()->layout.name;
  const std::string layout = name.empty() ? "a layout without a name" : "\"" + name + "\"";
  if (s.kind != ScenarioKind::sweep) return fmt::format("{} of {}: {}\n", to_word(s.kind), layout, rows);
  return fmt::format("sweep of {} over {}: {}, {} m deep, {} m/s, tilt {} degrees\n", layout, object_text(s), rows,
                     s.depth, s.speed, s.tilt_deg);
}

/// A soft geom without taxels.
std::string contact_text(const RecordedSensorSummary& sensor, const std::vector<std::string>& touched) {
  constexpr std::size_t kMaxNames = 12;
  std::vector<std::string> names(touched.begin(),
                                 touched.begin() + static_cast<std::ptrdiff_t>(std::min(touched.size(), kMaxNames)));
  if (touched.size() > kMaxNames) names.push_back(fmt::format("{} more", touched.size() - kMaxNames));
  return fmt::format("{}: soft, without taxels; contact with {}; force up to {:.4g} N on {:.4g} m^2\n", sensor.geom,
                     names.empty() ? "nothing" : fmt::format("{}", fmt::join(names, ", ")), sensor.largest_force,
                     sensor.largest_area);
}

std::string sensor_text(const RecordedSensorSummary& sensor, const RecordedSensor& about) {
  std::string text = fmt::format("{}: {:>6}  {:<14} {:>12} {:>10} {:>13}  {}\n", sensor.geom, "taxel", "name",
                                 fmt::format("peak [{}]", about.reading_unit), "at [m]", "largest step", "responds");
  const std::string indent(sensor.geom.size() + 2, ' ');
  for (const TaxelSummary& taxel : sensor.taxels) {
    text += fmt::format("{}{:>6}  {:<14} {:>12.6g} {:>10.4f} {:>11.2f} %  {}\n", indent, taxel.id, taxel.name,
                        taxel.peak, taxel.peak_travel, 100 * taxel.largest_step, taxel.responds ? "yes" : "");
  }
  text += fmt::format("{}force up to {:.4g} N on {:.4g} m^2", indent, sensor.largest_force, sensor.largest_area);
  if (about.force) text += fmt::format(", up to {:.4g} N that no taxel reaches", sensor.largest_uncovered);
  if (sensor.deflection > 0) {
    text += fmt::format(", deflection from the mocap body up to {:.3g} m and {:.3g} degrees", sensor.deflection,
                        sensor.deflection_deg);
  }
  return text + "\n";
}

}  // namespace

double rest_of(const RunCost& cost) {
  return cost.wall - cost.sensors.surfaces - cost.sensors.forces - cost.sensors.readings;
}

std::string recording_text(const RecordingReport& report) {
  std::string text = head_text(report);
  const std::vector<RecordedSensorSummary> sensors = summarize(report.recording);
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const bool contact = sensors[i].taxels.empty() && i < report.touched.size();
    text +=
        contact ? contact_text(sensors[i], report.touched[i]) : sensor_text(sensors[i], report.recording.sensors[i]);
  }
  const RunCost& cost = report.cost;
  text += fmt::format("{:.2f} s for samples and contact model\n", report.model_seconds);
  text += fmt::format("{:.2f} s ({:.2f} s of processor time) for {:.3f} s simulated: {:.2f} times real time\n",
                      cost.wall, cost.cpu, cost.simulated, cost.simulated / cost.wall);
  const auto percent = [&](double seconds) { return fmt::format("{:.0f} %", 100 * seconds / cost.wall); };
  text += fmt::format("of it contact surfaces {}, forces {}, rays and readings {}, MuJoCo and recording {}\n",
                      percent(cost.sensors.surfaces), percent(cost.sensors.forces), percent(cost.sensors.readings),
                      percent(rest_of(cost)));
  if (!report.files.empty()) text += fmt::format("wrote {}: {}\n", report.folder, fmt::join(report.files, " "));
  return text;
}

}  // namespace taxel::cli
