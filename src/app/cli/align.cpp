// taxel align: a recording of a real sensor laid over a run.
#include <fmt/format.h>

#include <memory>

#include "app/cli/align_report.h"
#include "app/cli/command.h"
#include "app/cli/recorded_sensor.h"
#include "core/base/files.h"
#include "core/run/real/real_recording.h"
#include "core/run/recording/npz.h"

namespace taxel::cli {
namespace {

struct Options {
  std::string run, real, map, save_map, sensor, out;
  std::optional<double> shift;
  bool common = false, no_offset = false;
};

/// As the file says, or as the table's names tell.
ColumnMapping mapping_of(const Options& options, const std::string& text, const TaxelSeries& run, Console& console) {
  ColumnMapping mapping = options.map.empty() ? guess_mapping(text, run.taxel_ids) : read_mapping(options.map);
  if (options.map.empty()) {
    std::string guessed;
    for (const TaxelColumn& taxel : mapping.taxels)
      guessed += fmt::format(", \"{}\" is taxel {}", taxel.column, taxel.taxel);
    console.note(fmt::format(
        "{}: guessed: time is {}{}; --save-map writes it down to be corrected", options.real,
        mapping.time.empty() ? fmt::format("even, {} rows a second", mapping.rate) : "\"" + mapping.time + "\"",
        guessed));
  }
  if (!options.save_map.empty()) write_file_atomically(options.save_map, mapping_to_json(mapping));
  return mapping;
}

void expect_known_taxels(const ColumnMapping& mapping, const TaxelSeries& run, const std::string& file) {
  for (std::size_t i = 0; i < mapping.taxels.size(); ++i) {
    const int id = mapping.taxels[i].taxel;
    if (std::find(run.taxel_ids.begin(), run.taxel_ids.end(), id) == run.taxel_ids.end())
      throw Error(file, fmt::format("/taxels/{}/taxel", i), fmt::format("the run has no taxel {}", id));
  }
}

int run(const Options& options, Console& console) {
  const std::string file = recording_file(options.run).string();
  const Recording recording = read_recording(options.run);
  const TaxelSeries series = series_of(recording, sensor_of(recording, options.sensor, file));
  const std::string text = read_file(options.real);
  const ColumnMapping mapping = mapping_of(options, text, series, console);
  const RealRecording real = parse_real_recording(text, mapping, options.real);
  expect_known_taxels(mapping, series, options.map.empty() ? options.real : options.map);
  for (const std::string& note : real.notes) console.note(options.real + ": " + note);

  AlignReport report{file, options.real, series.unit, mapping.unit, 0, {}, {options.common, !options.no_offset},
                     {},   real.notes};
  if (!options.shift) {
    report.alignment = align(series, real.series);
    if (!report.alignment)
      throw Error(options.real,
                  "cannot be aligned: no shift lays half of the shorter one over the other with readings "
                  "that change; give it by --shift");
  }
  report.shift = options.shift ? *options.shift : report.alignment->shift;
  report.fits = fit_gains(series, real.series, report.shift, report.options);
  if (!options.out.empty())
    write_file_atomically(options.out, aligned_csv(series, real.series, report.shift, report.fits));
  console.result(console.json() ? align_json(report) : align_text(report));
  return kDone;
}

}  // namespace

Command add_align(CLI::App& parent, CommonOptions& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* app =
      add_command(parent, common, "align",
                  "A recording of a real sensor laid over a run: the shift of its times, and gain and offset "
                  "of each taxel by least squares",
                  "taxel align result real.csv --map real.recmap.json --out aligned.csv");
  app->add_option("RUN", options->run, "Folder that `taxel sweep` or `taxel run` wrote, or its readings.npz")
      ->required()
      ->option_text("(required)");
  app->add_option("REAL", options->real, "Table of the real sensor (CSV)")->required()->option_text("(required)");
  app->add_option("--map", options->map,
                  "What its columns mean (*.recmap.json; default: guessed from their names, and told)")
      ->type_name("FILE");
  app->add_option("--save-map", options->save_map, "Write the mapping that was used")->type_name("FILE");
  app->add_option("--sensor", options->sensor, "Geom of the sensor, where the run has several")->type_name("GEOM");
  app->add_option("--shift", options->shift,
                  "Add this to the recording's times instead of finding what maximises the cross-correlation [s]")
      ->check(finite())
      ->type_name("S");
  app->add_flag("--common", options->common, "One gain and one offset for all taxels");
  app->add_flag("--no-offset", options->no_offset, "Lines through 0");
  app->add_option("--out", options->out,
                  "Write time, reading, recording and fitted reading of each taxel at the run's times (CSV)")
      ->type_name("FILE");
  return {app, [options](Console& console) { return run(*options, console); }};
}

}  // namespace taxel::cli
