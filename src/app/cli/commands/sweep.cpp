// taxel sweep: runs the fingertip sweep of the paper around any layout.
#include <fmt/format.h>

#include <array>
#include <memory>

#include "app/cli/played_scenario.h"
#include "core/document/scenario/scenario.h"

namespace taxel::cli {
namespace {

/// An option that sets a number of the scenario.
struct NumberFlag {
  const char* name;
  const char* key;  ///< key of the number in the scenario
  const char* unit;
  Check (*check)();
  const char* text;
};
constexpr std::array<NumberFlag, 10> kFlags{
    {{"--depth", "depth", "M", positive, "Depth of the finger's lowest point below the top of the object [m]"},
     {"--speed", "speed", "M/S", positive, "Speed of the mocap body that leads the finger [m/s]"},
     {"--before", "before", "M", not_negative,
      "Start: lowest point of the finger this far before the edge, 0.012 on a box; on an edge at least as far as the "
      "finger touches [m]"},
     {"--past", "past", "M", not_negative, "End: this far past the edge, as --before [m]"},
     {"--tilt", "tilt_deg", "DEG", finite, "Angle of the finger's distal axis below the horizontal [degrees]"},
     {"--record-every", "record_every", "M", positive, "Travel between two recorded rows [m]"},
     {"--timestep", "timestep", "S", positive, "Time step of the simulation [s]"},
     {"--mass", "finger_mass", "KG", positive, "Mass of the finger [kg]"},
     {"--box", "box_size", "M", positive, "Edge length of the box [m]"},
     {"--edge-radius", "edge_radius", "M", positive, "Radius of the round on the edge [m]"}}};

struct SweepOptions {
  std::string layout, out, scenario, object;
  std::array<std::optional<double>, kFlags.size()> numbers;
  LayoutOptions over;
  ExtraFiles extra;
  bool error_bars = false;
};

/// Returns the scenario before any number of an option replaces its own.
Scenario base_of(const SweepOptions& options) {
  if (options.over.as_in_the_paper) return default_scenario(kKind<scenarios::Paper>);
  Scenario scenario = options.scenario.empty() ? Scenario{} : read_scenario(options.scenario);
  if (options.object.empty()) return scenario;
  const std::optional<ObjectShape> shape = from_word<ObjectShape>(options.object);
  return shape ? with_shape(scenario, *shape) : with_object(scenario, options.object);
}

/// Sets the number of an option. Throws Error if the scenario does not use the number.
void set_number(Scenario& scenario, const NumberFlag& flag, double value) {
  double* number = find_number(scenario, flag.key);
  if (number == nullptr) {
    if (find_number(with_shape(scenario, ObjectShape::edge), flag.key) != nullptr)
      throw Error("", flag.name, "is used by the object \"edge\" only");
    throw Error("", flag.name, fmt::format("is not used by the kind \"{}\"", to_word(scenario.kind())));
  }
  *number = value;
}

/// Returns the scenario that the options describe. Throws Error if it is not valid or is of another kind.
Scenario scenario_of(const SweepOptions& options) {
  Scenario scenario = base_of(options);
  if (!scenario.is<scenarios::Sweep>() && !scenario.is<scenarios::Paper>())
    throw Error(options.scenario,
                fmt::format("is a scenario of the kind \"{}\": `taxel play` runs it", to_word(scenario.kind())));
  for (std::size_t i = 0; i < kFlags.size(); ++i)
    if (options.numbers[i]) set_number(scenario, kFlags[i], *options.numbers[i]);
  check_scenario(scenario);
  return scenario;
}

}  // namespace

Run add_sweep(OptionList& list) {
  const auto options = std::make_shared<SweepOptions>();
  list.add("--layout", &options->layout, "Layout file (*.taxels.json; default: the built-in fingertip)",
           {.unit = "FILE"});
  list.add("--out", &options->out,
           "Folder for readings.csv, readings.npz, calibrated.csv if the layout has a calibration, shear.csv if it has "
           "shear readings, sweep.json, scene.xml with its mesh and layout",
           {.unit = "DIR"});
  add_extra_files(list, options->extra);
  add_error_bars(list, options->error_bars);
  list.add("--scenario", &options->scenario, "Read the parameters below from a sweep.json; options replace them",
           {.unit = "FILE"});
  const Scenario defaults;
  for (std::size_t i = 0; i < kFlags.size(); ++i)
    list.add(kFlags[i].name, &options->numbers[i], kFlags[i].text,
             {.unit = kFlags[i].unit,
              .check = kFlags[i].check(),
              .default_text = fmt::format("{}", *find_number(defaults, kFlags[i].key))});
  list.add(
      "--object", &options->object,
      "edge (default: a box with an edge that points up), box (over its edge and onto its top), plate, sphere, or a "
      "mesh file in metres",
      {.unit = "NAME|FILE"});
  list.add(
      "--as-in-the-paper", &options->over.as_in_the_paper,
      "The paper's released demo on this layout: its path over its box, star field, 1e6 samples per m^2 of equal "
      "weight, modulus 5e4 Pa, dissipation 5 s/m, friction 0.3, and faces along the gradient, as in Drake 1.8 (which "
      "drops faces beyond 112.5 degrees at once)",
      {.excludes = {"--scenario", "--object"}});
  add_skin(list, options->over.skin);
  add_sampling(list, options->over);
  add_readout(list, options->over.readout);
  return [options](Console& console) {
    return play({"sweep", "sweep.json", scenario_of(*options), options->layout, options->over, options->out,
                 options->extra, options->error_bars},
                console);
  };
}

}  // namespace taxel::cli
