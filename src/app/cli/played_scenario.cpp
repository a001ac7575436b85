#include "app/cli/played_scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <ranges>

#include "app/cli/command_layout.h"
#include "app/cli/signals.h"
#include "app/version/version.h"
#include "core/base/output.h"
#include "core/document/scenario/scenario.h"
#include "core/layout/words.h"
#include "core/run/recording/recording.h"
#include "core/sim/host/write_recording.h"
#include "core/sim/scene/scenario_scene.h"

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
  const auto* sweep = std::get_if<scenarios::Sweep>(&s.motion);
  if (sweep == nullptr) return fmt::format("{} of {}: {}\n", to_word(s.kind()), layout, rows);
  return fmt::format("sweep of {} over {}: {}, {} m deep, {} m/s, tilt {} degrees\n", layout, object_text(s), rows,
                     sweep->depth, sweep->speed, sweep->tilt_deg);
}

/// Returns the lines of a soft geom without taxels.
std::string contact_text(const RecordedSensorSummary& sensor, const std::vector<std::string>& touched) {
  constexpr std::size_t kMaxNames = 12;
  std::vector<std::string> names(touched.begin(),
                                 touched.begin() + static_cast<std::ptrdiff_t>(std::min(touched.size(), kMaxNames)));
  if (touched.size() > kMaxNames) names.push_back(fmt::format("{} more", touched.size() - kMaxNames));
  return fmt::format("{}: soft, without taxels; contact with {}; force up to {:.4g} N on {:.4g} m^2\n", sensor.geom,
                     names.empty() ? "nothing" : fmt::format("{}", fmt::join(names, ", ")), sensor.largest_force,
                     sensor.largest_area);
}

/// Returns how far the sensor's frame moved: relative to the mocap body, or in the world if that stayed where it was.
std::string motion_text(const RecordedSensorSummary& sensor, const std::vector<Pose>& mocap) {
  if (!(sensor.deflection > 0)) return "";
  const auto differs = [&](const Pose& pose) { return pose.p != mocap.front().p || pose.q != mocap.front().q; };
  const bool is_led = std::any_of(mocap.begin(), mocap.end(), differs);
  return fmt::format(", {} up to {:.3g} m and {:.3g} degrees", is_led ? "deflection from the mocap body" : "moved",
                     sensor.deflection, sensor.deflection_deg);
}

std::string sensor_text(const RecordedSensorSummary& sensor, const RecordedSensor& about,
                        const std::vector<Pose>& mocap) {
  const std::string bar = about.errors ? fmt::format("{:>12} ", fmt::format("error [{}]", about.reading_unit)) : "";
  std::string text =
      fmt::format("{}: {:>6}  {:<14} {:>12} {}{:>10} {:>13}  {}\n", sensor.geom, "taxel", "name",
                  fmt::format("peak [{}]", about.reading_unit), bar, "at [m]", "largest step", "responds");
  const std::string indent(sensor.geom.size() + 2, ' ');
  for (const TaxelSummary& taxel : sensor.taxels) {
    const std::string error = about.errors ? fmt::format("{:>12.3g} ", taxel.largest_error) : "";
    text += fmt::format("{}{:>6}  {:<14} {:>12.6g} {}{:>10.4f} {:>11.2f} %  {}\n", indent, taxel.id, taxel.name,
                        taxel.peak, error, taxel.peak_travel, 100 * taxel.largest_step, taxel.responds ? "yes" : "");
  }
  text += fmt::format("{}force up to {:.4g} N on {:.4g} m^2", indent, sensor.largest_force, sensor.largest_area);
  if (about.force) text += fmt::format(", up to {:.4g} N that no taxel reaches", sensor.largest_uncovered);
  return text + motion_text(sensor, mocap) + "\n";
}

/// Returns the wall time that no sensor used [s].
double rest_of(const RunCost& cost) {
  return cost.wall - cost.sensors.surfaces - cost.sensors.forces - cost.sensors.readings;
}

/// Writes the keyframe and the names of the files that lead a scene, as the options of `taxel run`.
void visit_lead(ReportWriter& w, const LeadRequest& lead) {
  const auto write_name = [&w](const char* key, const std::string& file) {
    const std::filesystem::path path(file);
    if (!file.empty()) w(key, (path.has_filename() ? path : path.parent_path()).filename().string());  // not of "run/"
  };
  if (!lead.keyframe.empty()) w("keyframe", lead.keyframe);
  write_name("ctrl", lead.files.controls);
  write_name("mocap", lead.files.mocaps);
  write_name("replay", lead.files.run);
}

void visit_sensor(ReportWriter& w, const RecordedSensorSummary& summary, const SensorModel& model, bool errors) {
  const Layout& layout = model.layout;
  w("geom", summary.geom);
  w("layout", layout.name);
  w("aggregate", to_word(layout.readout.aggregate));
  w("density", layout.sampling.density);
  w("seed", layout.sampling.seed);
  w("samples", model.samples.size());
  w("rays", model.rays.size());
  w("largest_force", summary.largest_force);
  w("largest_area", summary.largest_area);
  if (layout.readout.aggregate == Aggregate::force) w("largest_uncovered", summary.largest_uncovered);
  w("deflection", summary.deflection);
  w("deflection_deg", summary.deflection_deg);
  w.list("taxels", summary.taxels, [errors](ReportWriter& one, const TaxelSummary& taxel) {
    one("id", taxel.id);
    one("name", taxel.name);
    one("peak", taxel.peak);
    one("peak_travel", taxel.peak_travel);
    one("largest_step", taxel.largest_step);
    if (errors) one("largest_error", taxel.largest_error);
    one("responds", taxel.responds);
  });
}

}  // namespace

void RecordingReport::visit_reproducible(ReportWriter& w) const {
  w("format", "taxel-" + command);
  w("version", 1);
  if (scenario) {
    w.object("scenario", [&](ReportWriter& object) { object.keys_of(scenario_to_json(*scenario)); });
  } else {
    w("scene", scene);
    w("seconds", seconds);
    visit_lead(w, lead);
  }
  if (!models.empty()) w("seed", models.front()->layout.sampling.seed);
  w.object("versions", [v = versions()](ReportWriter& object) {
    object("taxel", v.taxel);
    object("commit", v.commit);
    object("mujoco", v.mujoco);
  });
  w("timestep", recording.timestep);
  w("steps", cost.steps);
  w("rows", recording.rows.size());
  const std::vector<RecordedSensorSummary> sensors = summarize(recording);
  w.list("sensors", std::views::iota(std::size_t{0}, sensors.size()), [&](ReportWriter& sensor, std::size_t i) {
    visit_sensor(sensor, sensors[i], *models[i], recording.sensors[i].errors);
    if (sensors[i].taxels.empty() && i < touched.size()) sensor("touches", touched[i]);
  });
}

void RecordingReport::visit(ReportWriter& w) const {
  visit_reproducible(w);
  w("model_seconds", model_seconds);
  w("simulated_seconds", cost.simulated);
  w("wall_seconds", cost.wall);
  w.object("wall_parts", [&](ReportWriter& parts) {
    parts("surfaces", cost.sensors.surfaces);
    parts("forces", cost.sensors.forces);
    parts("readings", cost.sensors.readings);
    parts("rest", rest_of(cost));
  });
  w("cpu_seconds", cost.cpu);
  w("real_time_factor", cost.simulated / cost.wall);
  w("files", files);
}

std::string sweep_file_json(const RecordingReport& report) {
  ReportWriter writer;
  report.visit_reproducible(writer);
  return writer.text();
}

std::string RecordingReport::text() const {
  std::string text = head_text(*this);
  const std::vector<RecordedSensorSummary> sensors = summarize(recording);
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const bool contact = sensors[i].taxels.empty() && i < touched.size();
    text +=
        contact ? contact_text(sensors[i], touched[i]) : sensor_text(sensors[i], recording.sensors[i], recording.mocap);
  }
  text += fmt::format("{:.2f} s for samples and contact model\n", model_seconds);
  text += fmt::format("{:.2f} s ({:.2f} s of processor time) for {:.3f} s simulated: {:.2f} times real time\n",
                      cost.wall, cost.cpu, cost.simulated, cost.simulated / cost.wall);
  const auto percent = [&](double part) { return fmt::format("{:.0f} %", 100 * part / cost.wall); };
  const bool has_errors = std::ranges::any_of(recording.sensors, [](const RecordedSensor& s) { return s.errors; });
  text += fmt::format("of it contact surfaces {}, forces {}, rays and readings {}, {} {}\n",
                      percent(cost.sensors.surfaces), percent(cost.sensors.forces), percent(cost.sensors.readings),
                      has_errors ? "MuJoCo, recording and error bars" : "MuJoCo and recording", percent(rest_of(cost)));
  if (!files.empty()) text += fmt::format("wrote {}: {}\n", folder, fmt::join(files, " "));
  return text;
}

bool warn_of_depth(const Scenario& scenario, const SensorModel& model, Console& console) {
  const double* depth = find_number(scenario, "depth");
  if (depth == nullptr) return false;
  const dvec3 size = model.mesh->bounds().extent();
  const double smallest = std::min({size.x, size.y, size.z});
  const Material& material = model.layout.material;
  // The default thickness of a pad is an eighth of the smallest extent (hydro_body.cpp).
  const double pad = material.thickness > 0 ? material.thickness : 0.125 * smallest;
  const bool is_pad = material.compliant() && material.field == FieldKind::pad;
  if (*depth > smallest)
    console.warn(fmt::format("/depth: {} m is deeper than the sensor is thick, {:.3g} m: the readings are not valid",
                             *depth, smallest));
  else if (is_pad && *depth > pad)
    console.warn(
        fmt::format("/depth: {} m is deeper than the pad is thick, {:.3g} m: beyond the pad the pressure goes "
                    "on with p = (E/H) x depth, which no material does",
                    *depth, pad));
  return *depth > smallest || (is_pad && *depth > pad);
}

int play(const PlayedScenario& played, Console& console) {
  std::optional<OutputFolder> folder;
  if (!played.out.empty()) folder.emplace(played.out);

  const auto start = std::chrono::steady_clock::now();
  const SensorModelPtr model = load_model(played.layout, played.over, console);
  check_has_taxels(*model, played.layout);
  warn_of_depth(played.scenario, *model, console);
  const std::unique_ptr<Simulator> simulator = Simulator::make_scenario(model, played.scenario);
  const double model_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const FinishOnSignal finish;
  KeptRun kept(played.out, console);
  return kept.run([&] {
    RunCost cost;
    const Recording recording =
        record(*simulator, 0, console, cost, &kept, played.error_bars ? error_bars_of(*simulator, console) : nullptr);
    RecordingReport report{played.command, played.scenario, "", 0,         {model}, recording,
                           cost,           model_seconds,   {}, played.out};
    report.files = kept.commit(folder, recording, [&](OutputFolder& into) {
      put_recording(into, recording, simulator.get(), played.extra, {played.file, sweep_file_json(report)});
    });
    print_report(console, report);
    return FinishOnSignal::exit_status(kDone);
  });
}

}  // namespace taxel::cli
