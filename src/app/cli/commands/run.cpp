// taxel run: runs any MuJoCo scene with its tactile sensors.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

#include "app/cli/command_layout.h"
#include "app/cli/command_line.h"
#include "app/cli/played_scenario.h"
#include "app/cli/signals.h"
#include "core/base/output.h"
#include "core/layout/formats/layout_format.h"
#include "core/run/lead.h"
#include "core/sim/host/scene_run.h"
#include "core/sim/host/write_recording.h"
#include "core/sim/plugin/plugin_folder.h"
#include "core/sim/simulator.h"

namespace taxel::cli {
namespace {

/// Adds --keyframe, --ctrl, --mocap and --replay.
void add_lead(OptionList& list, LeadRequest& request) {
  list.add("--keyframe", &request.keyframe, "Start at this keyframe of the scene: its name, or its number from 0",
           {.unit = "NAME|NUMBER"});
  list.add("--ctrl", &request.files.controls,
           "Lead actuators by a table (CSV): a column `time` [s] from the start of the run, and a column for each led "
           "actuator by its name. Values between two rows are linear; the first and the last are held. Other actuators "
           "keep their control of the start",
           {.unit = "TABLE"});
  list.add("--mocap", &request.files.mocaps,
           "Lead mocap bodies by a table, as --ctrl: columns BODY_x, BODY_y, BODY_z [m] and, for the orientation, "
           "BODY_qw, BODY_qx, BODY_qy, BODY_qz; without BODY_ in a scene with one mocap body",
           {.unit = "TABLE"});
  list.add("--replay", &request.files.run,
           "Lead the first mocap body by the poses of a recorded run: a folder that `taxel sweep`, `play` or `run` "
           "wrote, or its readings.npz",
           {.unit = "RUN", .excludes = {"--mocap"}});
}

/// Loads the keyframe and leads the scene of the file `scene`. Prints notes and warnings about the files. Returns the
/// length of a run up to the last row of the files [s]; 0 if no file leads. Throws Error for bad input.
double lead_scene(Simulator& simulator, const LeadRequest& request, const std::string& scene, Console& console) {
  const SceneLeadPtr lead = lead_simulator(simulator, request, scene);
  if (lead == nullptr) return 0;
  for (const std::string& note : lead->notes) console.warn(note);
  const double timestep = simulator.scene()->timestep;
  return static_cast<double>(steps_of(*lead, timestep)) * timestep;
}

constexpr double kDefaultSeconds = 1;  // length of a run that no file leads [s]

struct RunOptions {
  std::string scene, plugins, out;
  std::vector<std::string> layouts, geoms, bodies;
  std::string others, sisters = "replace";
  SkinChoice skin;
  ReadoutChoice readout;
  std::optional<double> seconds;
  LeadRequest lead;
  ExtraFiles extra;
  bool error_bars = false;
};

/// Returns the pairs of layout and geom. Layouts of other programs that name their geom need no --geom. Throws Error if
/// the options do not form pairs.
std::vector<SceneAttachment> attachments_of(const RunOptions& options) {
  if (!options.geoms.empty() && !options.bodies.empty()) throw Error("run", "--body", "excludes --geom");
  const std::vector<std::string>& places = options.bodies.empty() ? options.geoms : options.bodies;
  const bool are_geoms_named =
      places.empty() && std::all_of(options.layouts.begin(), options.layouts.end(),
                                    [](const std::string& file) { return is_foreign_layout(file); });
  if (options.layouts.size() != places.size() && !are_geoms_named)
    throw Error("run", "--layout and --geom must be given equally often");
  if (options.layouts.empty() && (!options.others.empty() || options.sisters != "replace"))
    throw Error("run", "--others and --sisters go with --layout");
  if (options.layouts.size() != 1 && options.skin != SkinChoice{})
    throw Error("run", "--mesh, --scale and --sensor go with one --layout");
  std::vector<SceneAttachment> attachments;
  for (std::size_t i = 0; i < options.layouts.size(); ++i) {
    if (options.skin != SkinChoice{} && !is_foreign_layout(options.layouts[i]))
      throw Error(options.layouts[i], "has a mesh: --mesh, --scale and --sensor are only for layouts without a mesh");
    const std::string place = are_geoms_named ? "" : places[i];
    const bool is_body = !options.bodies.empty();
    attachments.push_back({is_body ? "" : place, options.layouts[i], options.skin, is_body ? place : "", options.others,
                           options.sisters == "keep"});
  }
  return attachments;
}

/// Records the run, writes its files and prints the report. Returns the exit status.
int record_and_write(const RunOptions& options, double seconds, Simulator& simulator, double model_seconds,
                     std::optional<OutputFolder>& folder, KeptRun& kept, Console& console) {
  const SimScene& scene = *simulator.scene();
  RunCost cost;
  const Recording recording = record(simulator, seconds, console, cost, &kept,
                                     options.error_bars ? error_bars_of(simulator, console) : nullptr);
  const std::string scene_name = std::filesystem::path(options.scene).filename().string();
  RecordingReport report{"run",     std::nullopt, scene_name,    seconds, scene.sensors,
                         recording, cost,         model_seconds, {},      options.out};
  for (const std::vector<TouchedBody>& touched : scene.touched) {
    std::vector<std::string>& names = report.touched.emplace_back();
    for (const TouchedBody& one : touched) names.push_back(one.name);
  }
  report.lead = options.lead;
  report.files = kept.commit(folder, recording, [&](OutputFolder& into) {
    put_recording(into, recording, &simulator, options.extra, {"sweep.json", sweep_file_json(report)});
  });
  print_report(console, report);
  return FinishOnSignal::exit_status(kDone);
}

int run_run_command(const RunOptions& options, Console& console) {
  const std::vector<SceneAttachment> attachments = attachments_of(options);
  if (!options.plugins.empty()) load_plugin_folder(options.plugins);
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);

  const auto start = std::chrono::steady_clock::now();
  const std::unique_ptr<Simulator> simulator = Simulator::load(options.scene, attachments, options.readout);
  const double model_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const SimScene& scene = *simulator->scene();
  if (scene.sensors.empty()) {
    const bool is_urdf = std::filesystem::path(options.scene).extension() == ".urdf";
    throw Error(options.scene,
                std::string("declares no taxel.sensor and no taxel.contact; attach a layout with --layout and --geom") +
                    (is_urdf ? " (for taxels that are links of this URDF, --layout takes the URDF, too)" : ""));
  }
  for (const SensorModelPtr& model : scene.sensors) {
    Problems problems = model->problems;  // repairs of meshes are among the warnings of the simulator
    std::erase_if(problems, [](const Problem& p) { return p.code.starts_with("repair_"); });
    console.report(problems);
  }
  const double led_seconds = lead_scene(*simulator, options.lead, options.scene, console);
  const double seconds = options.seconds.value_or(led_seconds > 0 ? led_seconds : kDefaultSeconds);
  if (!(seconds >= 0.5 * scene.timestep))  // record() rounds to whole steps
    throw Error(
        "run", fmt::format("--seconds: must be at least half of the time step, {} s, is {} s: no row would be recorded",
                           scene.timestep, seconds));
  const FinishOnSignal finish;
  KeptRun kept(options.out, console);
  return kept.run([&] { return record_and_write(options, seconds, *simulator, model_seconds, folder, kept, console); });
}

}  // namespace

Run add_run(OptionList& list) {
  const auto options = std::make_shared<RunOptions>();
  list.add("SCENE", &options->scene, "MuJoCo scene (.xml), or a URDF", required());
  list.add("--layout", &options->layouts, "Attach this layout (*.taxels.json, .yaml, .csv) ...", {.unit = "FILE"});
  list.add(
      "--geom", &options->geoms,
      "... to the geom of this name, or with this label, such as \"rh_ffdistal, plastic_visual\", if it has no name; "
      "both may be given again, in pairs. A .yaml that names its geom needs no "
      "--geom, and uses the geom's mesh and scale if --mesh is not given",
      {.unit = "NAME"});
  list.add("--body", &options->bodies, "... or to the mesh of this body", {.unit = "NAME"});
  list.add(
      "--others", &options->others,
      "Geoms that the attached skins touch, separated by commas (default: all that MuJoCo lets collide with a geom of "
      "the skin's body)",
      {.unit = "NAMES"});
  list.add(
      "--sisters", &options->sisters,
      "Collision geoms of the body that lie within an attached skin: \"replace\" their contacts by those of the skin, "
      "or \"keep\" them",
      {.unit = "WORD", .check = one_of({"replace", "keep"}), .default_text = "replace"});
  add_skin(list, options->skin);
  add_readout(list, options->readout);
  list.add("--plugins", &options->plugins,
           "Load the plugin libraries of this folder first: those of MuJoCo (its folder `plugin`, with signed distance "
           "functions) or your own",
           {.unit = "DIR"});
  list.add("--seconds", &options->seconds,
           "How long to run [s]; a row every step. Default: to the last row of --ctrl, --mocap or --replay",
           {.unit = "S", .check = positive(), .default_text = fmt::format("{}", kDefaultSeconds)});
  add_lead(list, options->lead);
  list.add(
      "--out", &options->out,
      "Folder for the files that `taxel sweep` writes: readings.csv, readings.npz, sweep.json (here: scene, seeds, "
      "versions), scene.xml with its meshes and layouts",
      {.unit = "DIR"});
  add_extra_files(list, options->extra);
  add_error_bars(list, options->error_bars);
  return [options](Console& console) { return run_run_command(*options, console); };
}

}  // namespace taxel::cli
