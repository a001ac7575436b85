// taxel models: reads the contacts of a recording by other models of a taxel.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <ranges>

#include "app/cli/command_line.h"
#include "app/cli/recorder.h"
#include "app/cli/report_writer.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/sensor/compare.h"
#include "core/sim/compare/model_comparison.h"
#include "core/sim/plugin/plugin_folder.h"

namespace taxel::cli {
namespace {

struct ModelsOptions {
  std::string run, sensor, plugins, out;
  int every = 1;
};

/// One sensor of a recording, read by all models.
struct ModelsReport {
  std::string geom;
  SensorModelPtr model;
  ComparedStepList rows;

  [[nodiscard]] const std::vector<Taxel>& taxels() const { return model->layout.taxels; }
  [[nodiscard]] Aggregate aggregate() const { return model->layout.readout.aggregate; }
  /// Why the model has no values, or left something out, in the first row in which it did; otherwise empty.
  [[nodiscard]] std::string missing(ReadingModel by) const {
    for (const ComparedStepPtr& row : rows)
      if (!row->readings[by].missing.empty()) return row->readings[by].missing;
    return "";
  }
  void visit(ReportWriter& w) const;
  [[nodiscard]] std::string text() const;
};

void ModelsReport::visit(ReportWriter& w) const {
  w("sensor", geom);
  w("rows", rows.size());
  w.list("models", kReadingModels, [&](ReportWriter& one, ReadingModel by) {
    const std::string why = missing(by);
    one("model", to_word(by));
    one("unit", unit_of(by, aggregate()));
    one("missing", why.empty() ? std::nullopt : std::optional(why));
  });
  w.list("taxels", std::views::iota(std::size_t{0}, taxels().size()), [&](ReportWriter& taxel, std::size_t k) {
    taxel("id", taxels()[k].id);
    taxel("name", taxels()[k].name);
    taxel.object("models", [&](ReportWriter& models) {
      for (const ReadingModel by : kReadingModels)
        models.object(to_word(by), [c = compare_with_exact(rows, by, k)](ReportWriter& one) {
          one("peak", c.peak);
          one("correlation", c.correlation);
          one("rms", c.rms);
          one("largest_step", c.largest_step);
        });
    });
  });
}

std::string number(const std::optional<double>& value, double scale) {
  return value ? fmt::format("{:.4g}", scale * *value) : "-";
}

std::string ModelsReport::text() const {
  std::string text = fmt::format(
      "{} rows of \"{}\" by other models. Correlation and rms are against the exact integral, rms after the best gain "
      "and as a part of its peak; the largest step from row to row is a part of the model's own peak.\n\n",
      rows.size(), geom);
  text += fmt::format("{:>6} {:<14} {:>12} {:<7} {:>12} {:>8} {:>8}\n", "taxel", "model", "peak", "unit", "correlation",
                      "rms %", "step %");
  std::vector<int> without_reading;
  for (std::size_t k = 0; k < taxels().size(); ++k) {
    std::string lines;
    bool is_read = false;
    for (const ReadingModel by : kReadingModels) {
      const CurveComparison c = compare_with_exact(rows, by, k);
      is_read = is_read || c.peak > 0;
      lines +=
          fmt::format("{:>6} {:<14} {:>12.5g} {:<7} {:>12} {:>8} {:>8.3g}\n", taxels()[k].id, to_word(by), c.peak,
                      unit_of(by, aggregate()), number(c.correlation, 1), number(c.rms, 100), 100 * c.largest_step);
    }
    if (is_read)
      text += lines;
    else
      without_reading.push_back(taxels()[k].id);
  }
  if (!without_reading.empty()) text += fmt::format("\nno reading at taxels {}\n", fmt::join(without_reading, ", "));
  for (const ReadingModel by : kReadingModels)
    if (const std::string why = missing(by); !why.empty()) text += fmt::format("{}: {}\n", to_word(by), why);
  return text;
}

/// Returns time, travel, then a column MODEL_ID for each model and taxel, in SI; a value that is missing is empty.
std::string models_csv(const ModelsReport& report) {
  std::vector<ModelColumns> columns;
  for (const ReadingModel by : kReadingModels)
    columns.push_back(columns_of(by, to_word(by) + std::string("_"), report.model->layout));
  return readings_to_csv(report.rows, columns);
}

/// Computes the contact of a recorded row. All other sensors have only their pose.
Step step_of(const RecordedRun& run, const RecordedRow& row) {
  RowPoses poses = poses_of(run, row);
  Step step;
  step.scene = run.simulator->scene();
  step.sensors.resize(poses.X_WM.size());
  for (std::size_t s = 0; s < step.sensors.size(); ++s) step.sensors[s].X_WM = poses.X_WM[s];
  step.sensors[run.sensor] = run.simulator->contact_at(run.sensor, poses.X_WM, poses.X_WG);
  step.geom_poses = std::move(poses.X_WG);
  return step;
}

int run_models_command(const ModelsOptions& options, Console& console) {
  if (!options.plugins.empty()) load_plugin_folder(options.plugins);
  if (!options.out.empty() && !std::filesystem::is_directory(std::filesystem::absolute(options.out).parent_path()))
    throw Error(options.out, "cannot be written: its folder does not exist");  // before the long computation
  RecordedRun run = read_run(options.run, options.sensor);
  load_scene(run);
  const std::vector<RecordedRow>& rows = run.recording.rows;
  ModelsReport report;
  report.geom = run.recording.sensors[run.sensor].geom;
  report.model = run.simulator->scene()->sensors[run.sensor];
  ModelComparison comparison(run.simulator->scene(), run.sensor);
  for (std::size_t r = 0; r < rows.size(); r += static_cast<std::size_t>(options.every)) {
    console.progress(static_cast<double>(r) / static_cast<double>(rows.size()));
    ComparedStep read{static_cast<std::uint64_t>(rows[r].step), rows[r].time, rows[r].travel,
                      comparison.read(view_of(step_of(run, rows[r]))), false};
    report.rows.push_back(std::make_shared<const ComparedStep>(std::move(read)));
  }
  console.progress(1);
  if (!options.out.empty()) write_file_atomically(options.out, models_csv(report));
  print_report(console, report, JsonStyle::narrow_indents);
  return kDone;
}

}  // namespace

Run add_models(OptionList& list) {
  const auto options = std::make_shared<ModelsOptions>();
  list.add("RUN", &options->run,
           "Folder that `taxel sweep` or `taxel run` wrote, or its readings.npz; scene.xml must be next to it",
           required());
  list.add("--sensor", &options->sensor, "Geom of the sensor, if the recording has several sensors", {.unit = "GEOM"});
  list.add("--every", &options->every, "Evaluate only every Nth row",
           {.unit = "N", .check = positive_number(), .default_text = "1"});
  list.add("--out", &options->out, "Write the curves as CSV: a column for each model and taxel", {.unit = "FILE"});
  list.add("--plugins", &options->plugins, "Load the plugin libraries of this folder first, as for `taxel run`",
           {.unit = "DIR"});
  return [options](Console& console) { return run_models_command(*options, console); };
}

}  // namespace taxel::cli
