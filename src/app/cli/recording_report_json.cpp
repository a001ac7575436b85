#include <nlohmann/json.hpp>

#include "app/cli/recording_report.h"
#include "app/vector_json.h"
#include "core/document/scenario/scenario_json.h"
#include "core/layout/words.h"

namespace taxel::cli {
namespace {

using Json = nlohmann::ordered_json;

Json sensor_object(const RecordedSensorSummary& summary, const SensorModel& model) {
  const Layout& layout = model.layout;
  Json json;
  json["geom"] = summary.geom;
  json["layout"] = layout.name;
  json["aggregate"] = to_word(layout.readout.aggregate);
  json["density"] = layout.sampling.density;
  json["seed"] = layout.sampling.seed;
  json["samples"] = model.samples.size();
  json["rays"] = model.rays.size();
  json["largest_force"] = summary.largest_force;
  json["largest_area"] = summary.largest_area;
  if (layout.readout.aggregate == Aggregate::force) json["largest_uncovered"] = summary.largest_uncovered;
  json["deflection"] = summary.deflection;
  json["deflection_deg"] = summary.deflection_deg;
  json["taxels"] = Json::array();
  for (const TaxelSummary& taxel : summary.taxels) {
    json["taxels"].push_back({{"id", taxel.id},
                              {"name", taxel.name},
                              {"peak", taxel.peak},
                              {"peak_travel", taxel.peak_travel},
                              {"largest_step", taxel.largest_step},
                              {"responds", taxel.responds}});
  }
  return json;
}

Json report_object(const RecordingReport& report) {
  Json json;
  json["format"] = "taxel-" + report.command;
  json["version"] = 1;
  if (report.scenario) {
    json["scenario"] = Json::parse(scenario_to_json(*report.scenario));
  } else {
    json["scene"] = report.scene;
    json["seconds"] = report.seconds;
  }
  if (!report.models.empty()) json["seed"] = report.models.front()->layout.sampling.seed;
  const Versions v = versions();
  json["versions"] = {{"taxel", v.taxel}, {"commit", v.commit}, {"mujoco", v.mujoco}};
  json["timestep"] = report.recording.timestep;
  json["steps"] = report.cost.steps;
  json["rows"] = report.recording.rows.size();
  json["sensors"] = Json::array();
  const std::vector<RecordedSensorSummary> sensors = summarize(report.recording);
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    json["sensors"].push_back(sensor_object(sensors[i], *report.models[i]));
    if (sensors[i].taxels.empty() && i < report.touched.size()) json["sensors"].back()["touches"] = report.touched[i];
  }
  return json;
}

}  // namespace

std::string recording_json(const RecordingReport& report) {
  Json json = report_object(report);
  json["model_seconds"] = report.model_seconds;
  json["simulated_seconds"] = report.cost.simulated;
  json["wall_seconds"] = report.cost.wall;
  json["wall_parts"] = {{"surfaces", report.cost.sensors.surfaces},
                        {"forces", report.cost.sensors.forces},
                        {"readings", report.cost.sensors.readings},
                        {"rest", rest_of(report.cost)}};
  json["cpu_seconds"] = report.cost.cpu;
  json["real_time_factor"] = report.cost.simulated / report.cost.wall;
  json["files"] = report.files;
  return text_of(json);
}

std::string sweep_file_json(const RecordingReport& report) {
  return text_of(report_object(report));
}

}  // namespace taxel::cli
