// taxel sweep: the fingertip sweep of the paper around any layout.
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/default_layout.h"
#include "app/cli/recording_report.h"
#include "core/base/output_folder.h"
#include "core/project/scenario_json.h"
#include "core/sim/recording/write_recording.h"

namespace taxel::cli {
namespace {

struct NumberFlag {
  const char* name;
  double SweepScenario::*value;
  const char* unit;
  CLI::Validator (*check)();
  const char* text;
};
constexpr std::array<NumberFlag, 9> kFlags{
    {{"--depth", &SweepScenario::depth, "M", positive, "How far below first touch the finger is led [m]"},
     {"--speed", &SweepScenario::speed, "M/S", positive, "Of the mocap body that leads the finger [m/s]"},
     {"--before", &SweepScenario::before, "M", not_negative,
      "Start: lowest point of the finger this far before the edge [m]"},
     {"--past", &SweepScenario::past, "M", not_negative, "End: this far past the edge [m]"},
     {"--tilt", &SweepScenario::tilt_deg, "DEG", finite, "Of the finger's distal axis below the horizontal [degrees]"},
     {"--record-every", &SweepScenario::record_every, "M", positive, "A row per this travel [m]"},
     {"--timestep", &SweepScenario::timestep, "S", positive, "Of the simulation [s]"},
     {"--mass", &SweepScenario::finger_mass, "KG", positive, "Of the finger [kg]"},
     {"--box", &SweepScenario::box_size, "M", positive, "Edge length of the box [m]"}}};

struct Options {
  std::string layout, out, scenario, object;
  std::array<std::optional<double>, kFlags.size()> numbers;
  LayoutOptions over;
  bool tactile_state = false;
};

SweepScenario scenario_of(const Options& options) {
  SweepScenario scenario = options.scenario.empty() ? SweepScenario{} : read_scenario(options.scenario);
  for (std::size_t i = 0; i < kFlags.size(); ++i) {
    scenario.*kFlags[i].value = options.numbers[i].value_or(scenario.*kFlags[i].value);
  }
  if (!options.object.empty()) scenario.object = options.object;
  check_scenario(scenario);
  return scenario;
}

int run(const Options& options, Console& console) {
  const SweepScenario scenario = scenario_of(options);
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);

  const auto start = std::chrono::steady_clock::now();
  const SensorModelPtr model = load_model(options.layout, options.over, console);
  const std::unique_ptr<Simulator> simulator = Simulator::make_sweep(model, scenario);
  const double model_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  RunCost cost;
  const Recording recording = record(*simulator, 0, console, cost);
  RecordingReport report{"sweep", scenario, "", 0, {model}, recording, cost, model_seconds, {}, options.out};
  if (folder) {
    put_recording(*folder, recording, simulator.get(), options.tactile_state);
    folder->write("sweep.json", sweep_file_json(report));
    report.files = folder->commit();
  }
  console.result(console.json() ? recording_json(report) : recording_text(report));
  return kDone;
}

}  // namespace

Command add_sweep(CLI::App& parent, CommonOptions& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* app =
      add_command(parent, common, "sweep", "The fingertip sweep of the paper: a finger slides over the edge of a box",
                  "taxel sweep --layout finger.taxels.json --out result");
  app->add_option("--layout", options->layout, "Layout file (*.taxels.json; default: the built-in fingertip)")
      ->type_name("FILE");
  app->add_option(
         "--out", options->out,
         "Folder for readings.csv, readings.npz, calibrated.csv if the layout has a calibration, shear.csv if it asks "
         "for shear, sweep.json, "
         "scene.xml with its mesh and layout")
      ->type_name("DIR");
  add_tactile_state(*app, options->tactile_state);
  app->add_option("--scenario", options->scenario, "Take the parameters below from a sweep.json; options go over it")
      ->type_name("FILE");
  const SweepScenario defaults;
  for (std::size_t i = 0; i < kFlags.size(); ++i) {
    app->add_option(kFlags[i].name, options->numbers[i], kFlags[i].text)
        ->check(kFlags[i].check())
        ->type_name(kFlags[i].unit)
        ->default_str(fmt::format("{}", defaults.*kFlags[i].value));
  }
  app->add_option("--object", options->object, "Mesh file of the object, in metres (default: a box)")
      ->type_name("FILE");
  add_sampling(*app, options->over);
  add_aggregate(*app, options->over.aggregate);
  return {app, [options](Console& console) { return run(*options, console); }};
}

}  // namespace taxel::cli
