// taxel align: compares a recording of a real sensor with a run.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/cli/command_line.h"
#include "app/cli/recorder.h"
#include "app/cli/report_writer.h"
#include "core/base/files.h"
#include "core/run/real/align.h"
#include "core/run/real/real_recording.h"
#include "core/run/recording/recording_files.h"

namespace taxel::cli {
namespace {

struct AlignOptions {
  std::string run, real, map, save_map, sensor, out;
  std::optional<double> shift, rate;
  bool common = false, no_offset = false;
};

struct AlignReport {
  std::string run, real;  ///< names of the files
  std::string run_unit, real_unit;
  double shift = 0;                    ///< [s]
  std::optional<Alignment> alignment;  ///< empty if the shift was given
  FitOptions options;
  std::vector<TaxelFit> fits;
  std::vector<std::string> notes;

  void visit(ReportWriter& w) const {
    w("run", run);
    w("recording", real);
    w("run_unit", run_unit);
    w("recording_unit", real_unit);
    w("shift", shift);
    w("correlation", alignment ? std::optional(alignment->correlation) : std::nullopt);
    w("overlap", alignment ? std::optional(alignment->overlap) : std::nullopt);
    w("common", options.common);
    w("with_offset", options.offset);
    w.list("taxels", fits, [](ReportWriter& taxel, const TaxelFit& fit) {
      taxel("id", fit.taxel);
      taxel("values", fit.points);
      if (!fit.refused.empty()) return taxel("refused", fit.refused);
      taxel("gain", fit.gain);
      taxel("offset", fit.offset);
      taxel("r2", fit.r2);
      taxel("residual", fit.residual);
      taxel("largest_error", fit.largest_error);
    });
    w("notes", notes);
  }
  [[nodiscard]] std::string text() const;
};

std::string AlignReport::text() const {
  std::string text = fmt::format("The recording is aligned with the run if {:.6g} s is added to its times", shift);
  if (alignment) text += fmt::format(" (correlation {:.4f} over {:.4g} s)", alignment->correlation, alignment->overlap);
  const std::string unit = real_unit.empty() ? "its unit" : real_unit;
  text += fmt::format(".\nrecording = gain * reading{} ({} per {}; {}):\n", options.offset ? " + offset" : "", unit,
                      run_unit, options.common ? "one line for all taxels" : "a line for each taxel");
  text += fmt::format("{:>6} {:>14} {:>14} {:>8} {:>12} {:>12} {:>8}\n", "taxel", "gain", "offset", "R^2", "residual",
                      "largest", "values");
  for (const TaxelFit& fit : fits) {
    if (fit.refused.empty())
      text += fmt::format("{:>6} {:>14.6g} {:>14.6g} {:>8.4f} {:>12.4g} {:>12.4g} {:>8}\n", fit.taxel, fit.gain,
                          fit.offset, fit.r2, fit.residual, fit.largest_error, fit.points);
    else
      text += fmt::format("{:>6} {}\n", fit.taxel, fit.refused);
  }
  return text;
}

/// Returns a sentence on times that no column gives.
std::string shown_rate(double rate) {
  return rate > 0 ? fmt::format("even, {} rows a second", rate)
                  : "not known: no column is a time (--rate HZ gives the rows a second)";
}

/// Returns the mapping of the file --map, or one that is guessed from the names of the table's columns.
ColumnMapping mapping_of(const AlignOptions& options, const std::string& text, const TaxelSeries& run,
                         Console& console) {
  ColumnMapping mapping = options.map.empty() ? guess_mapping(text, run.taxel_ids) : read_mapping(options.map);
  if (options.rate) mapping.time.clear(), mapping.rate = *options.rate;
  if (options.map.empty()) {
    std::string guessed;
    for (const TaxelColumn& taxel : mapping.taxels)
      guessed += fmt::format(", \"{}\" is taxel {}", taxel.column, taxel.taxel);
    console.note(
        fmt::format("{}: guessed: time is {}{}; --save-map writes the mapping to a file, to correct it", options.real,
                    mapping.time.empty() ? shown_rate(mapping.rate)
                                         : fmt::format("\"{}\" in {}", mapping.time, to_word(mapping.time_unit)),
                    guessed));
  }
  std::string without;
  for (const int id : taxels_without_column(mapping, run.taxel_ids)) without += fmt::format(" {}", id);
  if (!without.empty()) console.note(fmt::format("{}: taxels without a column:{}", options.real, without));
  if (!options.save_map.empty()) write_file_atomically(options.save_map, mapping_to_json(mapping));
  return mapping;
}

/// Throws Error naming `file` if the mapping names a taxel that the run does not have.
void expect_known_taxels(const ColumnMapping& mapping, const TaxelSeries& run, const std::string& file) {
  for (std::size_t i = 0; i < mapping.taxels.size(); ++i) {
    const int id = mapping.taxels[i].taxel;
    if (std::find(run.taxel_ids.begin(), run.taxel_ids.end(), id) == run.taxel_ids.end())
      throw Error(file, fmt::format("/taxels/{}/taxel", i), fmt::format("the run has no taxel {}", id));
  }
}

int run_align_command(const AlignOptions& options, Console& console) {
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
                  "cannot be aligned: no shift gives an overlap of half of the shorter signal with changing readings; "
                  "give it by --shift");
  }
  report.shift = options.shift ? *options.shift : report.alignment->shift;
  report.fits = fit_gains(series, real.series, report.shift, report.options);
  if (!options.out.empty())
    write_file_atomically(options.out, aligned_csv(series, real.series, report.shift, report.fits));
  print_report(console, report, JsonStyle::short_arrays);
  return kDone;
}

}  // namespace

Run add_align(OptionList& list) {
  const auto options = std::make_shared<AlignOptions>();
  list.add("RUN", &options->run, "Folder that `taxel sweep` or `taxel run` wrote, or its readings.npz", required());
  list.add("REAL", &options->real, "Table of the real sensor (CSV)", required());
  list.add("--map", &options->map,
           "Meaning of its columns (*.recmap.json; default: guessed from their names, and printed)", {.unit = "FILE"});
  list.add("--save-map", &options->save_map, "Write the mapping that was used", {.unit = "FILE"});
  list.add("--sensor", &options->sensor, "Geom of the sensor, if the run has several sensors", {.unit = "GEOM"});
  list.add("--shift", &options->shift,
           "Add this to the recording's times instead of the shift with the largest cross-correlation [s]",
           {.unit = "S", .check = finite()});
  list.add("--rate", &options->rate, "Rows a second of a recording without a column of times",
           {.unit = "HZ", .check = positive()});
  list.add("--common", &options->common, "One gain and one offset for all taxels");
  list.add("--no-offset", &options->no_offset, "Lines through 0");
  list.add("--out", &options->out,
           "Write time, reading, recording and fitted reading of each taxel at the run's times (CSV)",
           {.unit = "FILE"});
  return [options](Console& console) { return run_align_command(*options, console); };
}

}  // namespace taxel::cli
