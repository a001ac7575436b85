// taxel models: the contacts of a recording as other models of a taxel read them.
#include <fmt/format.h>

#include <memory>

#include "app/cli/command.h"
#include "app/cli/models_report.h"
#include "app/cli/recorded_run.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/sim/compare/model_comparison.h"
#include "core/sim/plugin/plugin_folder.h"

namespace taxel::cli {
namespace {

struct Options {
  std::string run, sensor, plugins, out;
  int every = 1;
};

/// A row's contact computed anew, as a frame has it.
std::vector<SensorFrameState> states_of(const RecordedRun& run, const RowPoses& poses) {
  std::vector<SensorFrameState> states(poses.X_WM.size());
  for (std::size_t s = 0; s < states.size(); ++s) states[s].X_WM = poses.X_WM[s];
  SensorFrameState& state = states[run.sensor];
  PosedContact contact = run.simulator->contact_at(run.sensor, poses.X_WM, poses.X_WG);
  state.surfaces = std::move(contact.surfaces);
  state.hits = contact.reading.hits.all();
  state.readings = std::move(contact.reading.values);
  return states;
}

int run(const Options& options, Console& console) {
  if (!options.plugins.empty()) load_plugin_folder(options.plugins);
  if (!options.out.empty() && !std::filesystem::is_directory(std::filesystem::absolute(options.out).parent_path()))
    throw Error(options.out, "cannot be written: its folder does not exist");  // told before the work
  RecordedRun run = read_run(options.run, options.sensor);
  load_scene(run);
  const std::vector<RecordedRow>& rows = run.recording.rows;
  ModelsReport report;
  report.geom = run.recording.sensors[run.sensor].geom;
  report.model = run.simulator->scene()->sensors[run.sensor];
  ModelComparison comparison(run.simulator->scene(), run.sensor);
  for (std::size_t r = 0; r < rows.size(); r += static_cast<std::size_t>(options.every)) {
    console.progress(static_cast<double>(r) / static_cast<double>(rows.size()));
    const RowPoses poses = poses_of(run, rows[r]);
    report.rows.push_back({rows[r].time, rows[r].travel, comparison.read(states_of(run, poses), poses.X_WG)});
  }
  console.progress(1);
  if (!options.out.empty()) write_file_atomically(options.out, models_csv(report));
  console.result(console.json() ? models_json(report) : models_text(report));
  return kDone;
}

}  // namespace

Command add_models(CLI::App& parent, CommonOptions& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(
      parent, common, "models",
      "The contacts of a recording as other models of a taxel read them: a star field, the weighted sum, the exact "
      "integral, MuJoCo's <tactile> depth, one MuJoCo touch site for each taxel",
      "taxel models result --every 4 --out models.csv");
  app->add_option("RUN", options->run,
                  "Folder that `taxel sweep` or `taxel run` wrote, or its readings.npz; scene.xml must lie beside it")
      ->required()
      ->option_text("(required)");
  app->add_option("--sensor", options->sensor, "Geom of the sensor, where the recording has several")
      ->type_name("GEOM");
  app->add_option("--every", options->every, "Only every Nth row")
      ->check(CLI::PositiveNumber)
      ->type_name("N")
      ->capture_default_str();
  app->add_option("--out", options->out, "Write the curves as CSV: a column for each model and taxel")
      ->type_name("FILE");
  app->add_option("--plugins", options->plugins, "Load the plugin libraries of this folder first, as for `taxel run`")
      ->type_name("DIR");
  return {app, [options](Console& console) { return run(*options, console); }};
}

}  // namespace taxel::cli
