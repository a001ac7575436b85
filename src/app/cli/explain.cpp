// taxel explain: where a recorded reading comes from, and why it changed.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "app/cli/command.h"
#include "app/cli/explain_report.h"
#include "app/cli/recorded_run.h"
#include "core/run/history/breakpoints.h"
#include "core/sensor/explain/explanation_json.h"
#include "core/sensor/explain/reading_floor.h"
#include "core/sim/plugin/plugin_folder.h"

namespace taxel::cli {
namespace {

struct Options {
  std::string run, sensor, plugins;
  int taxel = 0;
  double time = 0;
  Breakpoints limits;
};

/// Which taxel of a run is asked about.
struct Run : RecordedRun {
  std::size_t taxel = 0;
};

std::size_t taxel_of(const Run& run, int id) {
  const std::vector<int>& ids = run.recording.sensors[run.sensor].taxel_ids;
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end())
    throw Error(run.file, fmt::format("has no taxel {}, its ids are {}", id, fmt::join(ids, ", ")));
  return static_cast<std::size_t>(found - ids.begin());
}

/// The row that is nearest in time; of equal ones the first.
std::size_t row_at(const Run& run, double time) {
  const std::vector<RecordedRow>& rows = run.recording.rows;
  if (rows.empty()) throw Error(run.file, "time", "has no rows");
  const auto nearer = [&](const RecordedRow& a, const RecordedRow& b) {
    return std::abs(a.time - time) < std::abs(b.time - time);
  };
  const double last = rows.back().time, step = run.recording.timestep;
  if (time < rows.front().time - step || time > last + step)
    throw Error(run.file, fmt::format("ends at {:.6g} s and begins at {:.6g} s, asked for is {:.6g} s", last,
                                      rows.front().time, time));
  return static_cast<std::size_t>(std::min_element(rows.begin(), rows.end(), nearer) - rows.begin());
}

/// A row with its contact computed anew from its poses.
struct RebuiltRow {
  PosedContact contact;
  SensorStep step;
};

std::unique_ptr<RebuiltRow> rebuild(const Run& run, std::size_t number) {
  const RecordedRow& row = run.recording.rows[number];
  const RowPoses poses = poses_of(run, row);
  auto out = std::make_unique<RebuiltRow>();
  out->contact = run.simulator->contact_at(run.sensor, poses.X_WM, poses.X_WG);
  out->step.time = row.time;
  out->step.X_WM = poses.X_WM[run.sensor];
  for (const ContactSurface& surface : out->contact.surfaces) out->step.surfaces.push_back(&surface);
  out->step.hits = &out->contact.reading.hits.all();
  out->step.readings = out->contact.reading.values;
  out->step.force_W = row.sensors[run.sensor].force_W;
  return out;
}

/// What the recording says of the taxel must be what the contact reads now; else another program, or other files.
void compare(const Run& run, std::size_t row, const RebuiltRow& rebuilt, Console& console) {
  constexpr double kSame = 1e-6;  // scenes of `taxel run` hold rounded numbers
  const double recorded = run.recording.rows[row].sensors[run.sensor].readings[run.taxel];
  const double now = rebuilt.step.readings[run.taxel];
  if (std::abs(recorded - now) > kSame * std::max(std::abs(recorded), std::abs(now)))
    console.warn(
        fmt::format("{}: the row at {:.6g} s recorded {:.8g}, its contact reads {:.8g} now: the scene's files or "
                    "the program are others than were recorded with",
                    run.file, run.recording.rows[row].time, recorded, now));
}

/// The largest reading of the taxel in the recording, or of the sensor.
double largest_reading(const Run& run, const SensorModel& model, bool of_sensor) {
  double largest = reading_floor(model);
  for (const RecordedRow& row : run.recording.rows) {
    const std::vector<double>& readings = row.sensors[run.sensor].readings;
    for (std::size_t k = 0; k < readings.size(); ++k)
      if (of_sensor || k == run.taxel) largest = std::max(largest, std::abs(readings[k]));
  }
  return largest;
}

int run(const Options& options, Console& console) {
  if (!options.plugins.empty()) load_plugin_folder(options.plugins);
  Run run{read_run(options.run, options.sensor)};
  run.taxel = taxel_of(run, options.taxel);
  const std::size_t row = row_at(run, options.time);
  load_scene(run);
  const auto now = rebuild(run, row);
  const auto before = row > 0 ? rebuild(run, row - 1) : nullptr;
  compare(run, row, *now, console);
  if (before != nullptr) compare(run, row - 1, *before, console);
  const SensorModelPtr& model = run.simulator->scene()->sensors[run.sensor];
  const bool of_sensor = options.limits.of_sensor;
  const ExplainLimits limits{options.limits.jump, options.limits.equal_force, largest_reading(run, *model, of_sensor),
                             of_sensor};
  const Explanation found = Explainer().explain(model, static_cast<int>(run.taxel), now->step,
                                                before != nullptr ? &before->step : nullptr, limits);
  console.result(console.json() ? explanation_to_json(found) : explain_text(found));
  return kDone;
}

}  // namespace

Command add_explain(CLI::App& parent, CommonOptions& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(
      parent, common, "explain",
      "Why a recorded reading is what it is: its samples and polygons, the exact integral, what changed since the row "
      "before, and whether the contact or the method did it",
      "taxel explain result --taxel 3 --time 1.25");
  app->add_option("RUN", options->run,
                  "Folder that `taxel sweep` or `taxel run` wrote, or its readings.npz; scene.xml must lie beside it")
      ->required()
      ->option_text("(required)");
  app->add_option("--taxel", options->taxel, "Id of the taxel")->required()->type_name("ID");
  app->add_option("--time", options->time, "The row nearest to this time [s]")
      ->required()
      ->check(finite())
      ->type_name("S");
  app->add_option("--sensor", options->sensor, "Geom of the sensor, where the recording has several")
      ->type_name("GEOM");
  app->add_option("--jump", options->limits.jump,
                  "A change from row to row is a jump above this part of the taxel's largest reading in the recording")
      ->check(positive())
      ->capture_default_str();
  app->add_flag("--of-sensor", options->limits.of_sensor,
                "Measure against the largest reading of all taxels of the sensor instead");
  app->add_option("--equal-force", options->limits.equal_force,
                  "The force stays where it changes by at most this part of itself")
      ->check(not_negative())
      ->capture_default_str();
  app->add_option("--plugins", options->plugins, "Load the plugin libraries of this folder first, as for `taxel run`")
      ->type_name("DIR");
  return {app, [options](Console& console) { return run(*options, console); }};
}

}  // namespace taxel::cli
