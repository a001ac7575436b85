// taxel explain: explains where a recorded reading comes from and why it changed.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "app/cli/command_line.h"
#include "app/cli/commands/explain_text.h"
#include "app/cli/recorder.h"
#include "core/run/history/breakpoints.h"
#include "core/sensor/explain/explainer.h"
#include "core/sensor/explain/explanation.h"
#include "core/sim/plugin/plugin_folder.h"

namespace taxel::cli {
namespace {

struct ExplainOptions {
  std::string run, sensor, plugins;
  int taxel = 0;
  double time = 0;
  Breakpoints limits;
};

/// A recorded run and the index of the explained taxel.
struct ExplainedRun : RecordedRun {
  std::size_t taxel = 0;
};

/// Returns the index of the taxel with this id. Throws Error naming the ids.
std::size_t taxel_of(const ExplainedRun& run, int id) {
  const std::vector<int>& ids = run.recording.sensors[run.sensor].taxel_ids;
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end())
    throw Error(run.file, fmt::format("has no taxel {}, its ids are {}", id, fmt::join(ids, ", ")));
  return static_cast<std::size_t>(found - ids.begin());
}

/// Returns the index of the row that is nearest in time, the first one of equally near rows. Throws Error if the time
/// is outside of the recording.
std::size_t row_at(const ExplainedRun& run, double time) {
  const std::vector<RecordedRow>& rows = run.recording.rows;
  if (rows.empty()) throw Error(run.file, "time", "has no rows");
  const auto nearer = [&](const RecordedRow& a, const RecordedRow& b) {
    return std::abs(a.time - time) < std::abs(b.time - time);
  };
  const double last = rows.back().time, step = run.recording.timestep;
  if (time < rows.front().time - step || time > last + step)
    throw Error(run.file, fmt::format("begins at {:.6g} s and ends at {:.6g} s, requested is {:.6g} s",
                                      rows.front().time, last, time));
  return static_cast<std::size_t>(std::min_element(rows.begin(), rows.end(), nearer) - rows.begin());
}

/// Computes the contact of a recorded row from its poses.
SensorStep contact_of(const ExplainedRun& run, std::size_t number) {
  const RecordedRow& row = run.recording.rows[number];
  const RowPoses poses = poses_of(run, row);
  SensorStep step = run.simulator->contact_at(run.sensor, poses.X_WM, poses.X_WG);
  step.time = row.time;
  step.force_W = row.sensors[run.sensor].force_W;
  return step;
}

/// Warns if the recorded reading of the taxel differs from the reading that is computed now. Then the program or the
/// files are not those of the recording.
void compare(const ExplainedRun& run, std::size_t row, const SensorStep& step, Console& console) {
  constexpr double kMaxDifference = 1e-6;  // relative; the scene files of `taxel run` contain rounded numbers
  const double recorded = run.recording.rows[row].sensors[run.sensor].readings[run.taxel];
  const double now = step.readings[run.taxel];
  if (std::abs(recorded - now) > kMaxDifference * std::max(std::abs(recorded), std::abs(now)))
    console.warn(
        fmt::format("{}: the row at {:.6g} s recorded {:.8g}, but its contact now gives {:.8g}: the scene's files or "
                    "the program have changed since the recording",
                    run.file, run.recording.rows[row].time, recorded, now));
}

/// Returns the largest reading of the taxel, or of all taxels of the sensor, in the recording.
double largest_reading(const ExplainedRun& run, const SensorModel& model, bool of_sensor) {
  double largest = reading_floor(model);
  for (const RecordedRow& row : run.recording.rows) {
    const std::vector<double>& readings = row.sensors[run.sensor].readings;
    for (std::size_t k = 0; k < readings.size(); ++k)
      if (of_sensor || k == run.taxel) largest = std::max(largest, std::abs(readings[k]));
  }
  return largest;
}

/// Returns the row at which the reading of the taxel differs most from the row before, or 0 if there is one row.
std::size_t worst_row(const ExplainedRun& run) {
  const auto reading = [&](std::size_t row) { return run.recording.rows[row].sensors[run.sensor].readings[run.taxel]; };
  std::size_t worst = 0;
  double largest = 0;
  for (std::size_t row = 1; row < run.recording.rows.size(); ++row)
    if (const double change = std::abs(reading(row) - reading(row - 1)); change > largest)
      worst = row, largest = change;
  return worst;
}

int run_explain_command(const ExplainOptions& options, Console& console) {
  if (!options.plugins.empty()) load_plugin_folder(options.plugins);
  ExplainedRun run{read_run(options.run, options.sensor)};
  run.taxel = taxel_of(run, options.taxel);
  const std::size_t row = row_at(run, options.time);
  load_scene(run);
  const SensorStep now = contact_of(run, row);
  const std::optional<SensorStep> before = row > 0 ? std::optional(contact_of(run, row - 1)) : std::nullopt;
  compare(run, row, now, console);
  if (before) compare(run, row - 1, *before, console);
  const bool of_sensor = options.limits.of_sensor;
  const ExplainLimits limits{options.limits.jump, options.limits.equal_force,
                             largest_reading(run, *now.model, of_sensor), of_sensor,
                             largest_reading(run, *now.model, true)};
  const std::size_t worst = worst_row(run);
  std::optional<SensorStep> worst_before, worst_now;
  if (worst > 0 && worst != row) worst_before = contact_of(run, worst - 1), worst_now = contact_of(run, worst);
  const StepPair worst_pair{worst_before ? &*worst_before : nullptr, worst_now ? &*worst_now : nullptr};
  const Explanation found =
      Explainer().explain(static_cast<int>(run.taxel), now, before ? &*before : nullptr, limits, nullptr, worst_pair);
  console.result(console.json() ? explanation_to_json(found) : explain_text(found));
  return kDone;
}

}  // namespace

Run add_explain(OptionList& list) {
  const auto options = std::make_shared<ExplainOptions>();
  list.add("RUN", &options->run,
           "Folder that `taxel sweep` or `taxel run` wrote, or its readings.npz; scene.xml must be next to it",
           required());
  list.add("--taxel", &options->taxel, "Id of the taxel", {.unit = "ID", .is_required = true});
  list.add("--time", &options->time, "The row nearest to this time [s]",
           {.unit = "S", .check = finite(), .is_required = true});
  list.add("--sensor", &options->sensor, "Geom of the sensor, if the recording has several sensors", {.unit = "GEOM"});
  list.add("--jump", &options->limits.jump,
           "A change from row to row is a jump above this fraction of the taxel's largest reading in the recording",
           {.check = positive(), .default_text = fmt::format("{}", options->limits.jump)});
  list.add("--of-sensor", &options->limits.of_sensor, "Use the largest reading of all taxels of the sensor instead");
  list.add("--equal-force", &options->limits.equal_force,
           "The force is constant if it changes by at most this fraction",
           {.check = not_negative(), .default_text = fmt::format("{}", options->limits.equal_force)});
  list.add("--plugins", &options->plugins, "Load the plugin libraries of this folder first, as for `taxel run`",
           {.unit = "DIR"});
  return [options](Console& console) { return run_explain_command(*options, console); };
}

}  // namespace taxel::cli
