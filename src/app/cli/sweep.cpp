// taxel sweep: the fingertip sweep of the paper around any layout.
#include <fmt/format.h>

#include <array>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/played_scenario.h"
#include "core/project/scenario_json.h"

namespace taxel::cli {
namespace {

struct NumberFlag {
  const char* name;
  double Scenario::*value;
  const char* unit;
  CLI::Validator (*check)();
  const char* text;
};
constexpr std::array<NumberFlag, 9> kFlags{
    {{"--depth", &Scenario::depth, "M", positive, "How far below first touch the finger is led [m]"},
     {"--speed", &Scenario::speed, "M/S", positive, "Of the mocap body that leads the finger [m/s]"},
     {"--before", &Scenario::before, "M", not_negative,
      "Start: lowest point of the finger this far before the edge [m]"},
     {"--past", &Scenario::past, "M", not_negative, "End: this far past the edge [m]"},
     {"--tilt", &Scenario::tilt_deg, "DEG", finite, "Of the finger's distal axis below the horizontal [degrees]"},
     {"--record-every", &Scenario::record_every, "M", positive, "A row per this travel [m]"},
     {"--timestep", &Scenario::timestep, "S", positive, "Of the simulation [s]"},
     {"--mass", &Scenario::finger_mass, "KG", positive, "Of the finger [kg]"},
     {"--box", &Scenario::box_size, "M", positive, "Edge length of the box [m]"}}};

struct Options {
  std::string layout, out, scenario, object;
  std::array<std::optional<double>, kFlags.size()> numbers;
  LayoutOptions over;
  bool tactile_state = false;
};

Scenario scenario_of(const Options& options) {
  Scenario scenario = options.scenario.empty() ? Scenario{} : read_scenario(options.scenario);
  for (std::size_t i = 0; i < kFlags.size(); ++i) {
    scenario.*kFlags[i].value = options.numbers[i].value_or(scenario.*kFlags[i].value);
  }
  if (scenario.kind != ScenarioKind::sweep)
    throw Error(options.scenario,
                fmt::format("is a scenario of the kind \"{}\": `taxel play` runs it", to_word(scenario.kind)));
  if (!options.object.empty()) scenario.object = options.object;
  check_scenario(scenario);
  return scenario;
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
  const Scenario defaults;
  for (std::size_t i = 0; i < kFlags.size(); ++i) {
    app->add_option(kFlags[i].name, options->numbers[i], kFlags[i].text)
        ->check(kFlags[i].check())
        ->type_name(kFlags[i].unit)
        ->default_str(fmt::format("{}", defaults.*kFlags[i].value));
  }
  app->add_option("--object", options->object, "Mesh file of the object, in metres (default: a box)")
      ->type_name("FILE");
  add_skin(*app, options->over.skin);
  add_sampling(*app, options->over);
  add_aggregate(*app, options->over.aggregate);
  return {app, [options](Console& console) {
            return play({"sweep", "sweep.json", scenario_of(*options), options->layout, options->over, options->out,
                         options->tactile_state},
                        console);
          }};
}

}  // namespace taxel::cli
