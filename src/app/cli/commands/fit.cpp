// taxel fit: finds the parameters with which simulated readings agree best with recorded presses of a real sensor.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>

#include "app/cli/command_layout.h"
#include "app/cli/report_writer.h"
#include "app/cli/signals.h"
#include "core/base/files.h"
#include "core/base/output.h"
#include "core/base/text/expression.h"
#include "core/run/fit/fit.h"
#include "core/run/fit/fit_files.h"
#include "core/run/real/real_recording.h"
#include "core/sensor/layout_source.h"

namespace taxel::cli {
namespace {

namespace fs = std::filesystem;

struct FitCommandOptions {
  std::vector<std::string> recordings, held_out, starts, fixed;
  std::string layout, contact_case, free = "x0,z0,gain", map, pose, press_axis = "z", part = "loading", share, out;
  SkinChoice skin;
  ReadoutChoice readout;
};

/// A fit with the names of its files, for the screen and for fit.json.
struct FitReport {
  const RecordingFit& fit;
  const std::vector<PressedRecording>& recordings;

  void visit(ReportWriter& w) const;
  void visit_run(ReportWriter& w, std::size_t r) const;
  [[nodiscard]] std::string name_of(std::size_t parameter) const;
  [[nodiscard]] std::string text() const;
};

std::string FitReport::name_of(std::size_t parameter) const {
  const FittedParameter& p = fit.parameters[parameter];
  const std::string word(to_word(p.name));
  return p.run && fit.runs.size() > 1 ? fmt::format("{} of recording {}", word, *p.run + 1) : word;
}

void FitReport::visit_run(ReportWriter& w, std::size_t r) const {
  const RunAgreement& run = fit.runs[r];
  w("file", recordings[r].file);
  w("hold_out", run.is_held_out);
  w("presses", recordings[r].presses.size());
  w("points", run.points.size());
  w("untouched_points", run.untouched_points);
  w("largest", run.largest);
  w("r2", run.r2);
  w("rms", run.rms);
  w("worst", run.worst);
  w.object("zeros", [&](ReportWriter& zeros) {
    for (int axis = 0; axis < 3; ++axis)
      zeros(to_word(static_cast<FitName>(static_cast<int>(FitName::x0) + axis)), run.zero[axis]);
  });
  w.list("taxels", run.taxels, [](ReportWriter& one, const TaxelAgreement& taxel) {
    one("id", taxel.taxel);
    one("column", taxel.column);
    one("gain", taxel.gain);
    one("points", taxel.points);
    one("r2", taxel.r2);
    one("rms", taxel.rms);
    one("worst", taxel.worst);
    one("width_measured", taxel.width_measured);
    one("width_fitted", taxel.width_fitted);
  });
}

void FitReport::visit(ReportWriter& w) const {
  w.list("free", fit.parameters, [&](ReportWriter& one, const FittedParameter& p) {
    one("name", to_word(p.name));
    one("value", p.value);
    one("unit", unit_of(p.name));
    one("standard_error", p.standard_error);
    one("start", p.start);
    one("lower", p.lower);
    one("upper", p.upper);
    one("run", p.run);
  });
  w("correlations", fit.correlations);
  std::vector<std::size_t> numbers(fit.runs.size());
  for (std::size_t r = 0; r < numbers.size(); ++r) numbers[r] = r;
  w.list("runs", numbers, [&](ReportWriter& one, std::size_t r) { visit_run(one, r); });
  w.list("undecided", fit.undecided, [&](ReportWriter& one, const Undecided& undecided) {
    std::vector<std::string> names;
    for (const std::size_t parameter : undecided.parameters) names.push_back(name_of(parameter));
    one("parameters", names);
    one("correlation", undecided.correlation);
    one("advice", undecided.advice);
  });
}

/// Returns a value in the unit of the screen: lengths in mm.
std::string shown_value(FitName name, double value) {
  return unit_of(name) == "m" ? fmt::format("{:.5g}", 1e3 * value) : fmt::format("{:.5g}", value);
}

std::string FitReport::text() const {
  std::string text = fmt::format("{:<28} {:>12} {:>12} {:>5}\n", "parameter", "value", "std. error", "unit");
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    const FittedParameter& p = fit.parameters[i];
    text += fmt::format("{:<28} {:>12} {:>12} {:>5}\n", name_of(i), shown_value(p.name, p.value),
                        shown_value(p.name, p.standard_error), unit_of(p.name) == "m" ? "mm" : unit_of(p.name));
    if (p.value <= p.lower || p.value >= p.upper)
      text +=
          fmt::format("  {} is at the bound of its range: its start, {}, is far off, or the data do not decide it\n",
                      name_of(i), shown_value(p.name, p.start));
  }
  if (fit.parameters.size() > 1) {
    text += "\ncorrelations\n";
    for (std::size_t i = 1; i < fit.parameters.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (std::abs(fit.correlations[i][j]) >= 0.5)
          text += fmt::format("  {} with {}: {:+.3f}\n", name_of(j), name_of(i), fit.correlations[i][j]);
  }
  text +=
      fmt::format("\n{:<44} {:>7} {:>8} {:>8} {:>9} {:>8}\n", "recordings", "presses", "values", "R2", "rms", "worst");
  for (std::size_t r = 0; r < fit.runs.size(); ++r) {
    const RunAgreement& run = fit.runs[r];
    text += fmt::format("{:<44} {:>7} {:>8} {:>8.4f} {:>8.2f}% {:>7.2f}%\n",
                        fmt::format("{}: {}{}", r + 1, fs::path(recordings[r].file).filename().string(),
                                    run.is_held_out ? ", held out" : ""),
                        recordings[r].presses.size(), run.points.size(), run.r2, 100 * run.rms, 100 * run.worst);
    for (const TaxelAgreement& taxel : run.taxels)
      text += fmt::format("  taxel {:<4} {:<32} {:>16} {:>8.4f} {:>8.2f}% {:>7.2f}%   gain {:.5g}\n", taxel.taxel,
                          taxel.column, taxel.points, taxel.r2, 100 * taxel.rms, 100 * taxel.worst, taxel.gain);
  }
  text += "rms and worst error are in percent of the largest recorded value\n";
  for (const Undecided& undecided : fit.undecided) {
    std::string names;
    for (const std::size_t parameter : undecided.parameters)
      names += (names.empty() ? "" : " and ") + name_of(parameter);
    text += undecided.parameters.size() > 1 ? fmt::format("UNDECIDED: {} (correlation {:+.3f}): {}\n", names,
                                                          undecided.correlation, undecided.advice)
                                            : fmt::format("UNDECIDED: {}\n", undecided.advice);
  }
  return text;
}

std::vector<std::string> split_words(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, ',');) words.push_back(word);
  return words;
}

FitName named_parameter(const std::string& word, const char* option) {
  if (const auto name = from_word<FitName>(word)) return *name;
  throw Error("fit", option, fmt::format("\"{}\" is no parameter; there are {}", word, word_list<FitName>()));
}

/// Returns the value of "object.radius=3.7 mm" or "k=0.5".
FitValue parse_fit_value(const std::string& text, const char* option) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw Error("fit", option, fmt::format("\"{}\" must be NAME=VALUE, such as \"radius=6 mm\"", text));
  FitValue value{named_parameter(text.substr(0, equals), option), 0};
  try {
    value.value = evaluate(text.substr(equals + 1), unit_of(value.name));
  } catch (const Error& e) {
    throw Error("fit", option, fmt::format("\"{}\": {}: {}", text, e.where(), e.message()));
  }
  const bool is_length = value.name <= FitName::thickness;
  if (is_length && !(value.value > 0)) throw Error("fit", option, fmt::format("\"{}\" must be greater than 0", text));
  if (value.name == FitName::k && !(value.value >= 0 && value.value < 1))
    throw Error("fit", option, fmt::format("\"{}\" must be at least 0 and less than 1", text));
  return value;
}

RecordingFitOptions fit_options(const FitCommandOptions& options, int axis) {
  RecordingFitOptions out;
  for (const std::string& word : split_words(options.free)) out.free.push_back(named_parameter(word, "--free"));
  for (const std::string& text : options.starts) out.values.push_back(parse_fit_value(text, "--start"));
  for (const std::string& text : options.fixed) {
    const FitValue value = parse_fit_value(text, "--fix");
    if (std::count(out.free.begin(), out.free.end(), value.name) > 0)
      throw Error("fit", "--fix", fmt::format("{} is free: take it out of --free", to_word(value.name)));
    out.values.push_back(value);
  }
  out.axis = axis;
  out.shares_gain = options.share == "gain";
  return out;
}

PressedRecording read_pressed(const std::string& file, const FitCommandOptions& options, const Layout& layout, int axis,
                              Console& console) {
  const std::string text = read_file(file);
  PressedOptions how;
  std::vector<int> ids;
  for (const Taxel& taxel : layout.taxels) ids.push_back(taxel.id);
  how.mapping = options.map.empty() ? guess_mapping(text, ids) : read_mapping(options.map);
  if (!options.pose.empty()) how.columns = parse_pose_columns(options.pose);
  how.axis = axis;
  how.part = options.part == "all" ? PressPart::all : PressPart::loading;
  const PressedRecording recording = parse_pressed_recording(text, how, file);
  for (const std::string& note : recording.notes) console.note(file + ": " + note);
  std::string columns;
  for (std::size_t t = 0; t < recording.taxel_ids.size(); ++t)
    columns += fmt::format("{}\"{}\" is taxel {}", t > 0 ? ", " : "", recording.columns[t], recording.taxel_ids[t]);
  console.note(
      fmt::format("{}: {} presses with {} rows; {}", file, recording.presses.size(), recording.row_count(), columns));
  return recording;
}

int run_fit_command(const FitCommandOptions& options, Console& console) {
  const int axis = options.press_axis[0] - 'x';
  const RecordingFitOptions how = fit_options(options, axis);
  ImportedSource imported = read_any_source(options.layout, options.skin);
  for (const std::string& note : imported.notes) console.note(options.layout + ": " + note);
  FitSubject subject{std::move(imported.source), read_contact_case(options.contact_case)};
  subject.sensor.layout.readout = options.readout.applied_to(subject.sensor.layout.readout);
  if (!subject.contact_case.b.shape) throw Error(options.contact_case, "/b/shape", "is missing: it is the object");
  if (subject.contact_case.b.shape->type == ShapeType::mesh &&
      std::count(how.free.begin(), how.free.end(), FitName::object_radius) > 0)
    throw Error("fit", "--free", "object.radius needs a shape with a size; the case's shape is a mesh");
  std::vector<PressedRecording> fitted, held_out;
  for (const std::string& file : options.recordings)
    fitted.push_back(read_pressed(file, options, subject.sensor.layout, axis, console));
  for (const std::string& file : options.held_out)
    held_out.push_back(read_pressed(file, options, subject.sensor.layout, axis, console));
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  const RecordingFit fit = with_progress(console, [&](Progress& progress) {
    RecordingFitOptions watched = how;
    watched.progress = &progress;
    return fit_recordings(subject, fitted, held_out, watched);
  });
  std::vector<PressedRecording> all = std::move(fitted);
  all.insert(all.end(), std::make_move_iterator(held_out.begin()), std::make_move_iterator(held_out.end()));
  const FitReport report{fit, all};
  if (folder) {
    folder->write("fit.json", json_of(report, JsonStyle::short_arrays));
    folder->write("points.csv", points_csv(fit, all));
    folder->write("bells.svg", page_to_svg(chart_page(bells_chart(fit, all))));
    folder->write("loading.svg", page_to_svg(chart_page(loading_chart(fit, all, axis))));
    folder->write("residuals.svg", page_to_svg(chart_page(residuals_chart(fit, all))));
    folder->commit();
  }
  print_report(console, report, JsonStyle::short_arrays);
  return kDone;
}

}  // namespace

Run add_fit(OptionList& list) {
  const auto options = std::make_shared<FitCommandOptions>();
  list.add("RECORDING", &options->recordings,
           "Tables of the real sensor (CSV): columns of the taxels and of the object's position, many presses in each",
           required());
  OptionRules needed = required();
  needed.unit = "FILE";
  list.add("--layout", &options->layout, "Layout file (*.taxels.json) to start from", needed);
  list.add("--case", &options->contact_case,
           "Contact case (JSON): `a` has the pose of the layout's mesh-file frame, `b` is the object and its pose "
           "without displacement, world frame",
           needed);
  list.add("--free", &options->free,
           "Parameters that are fitted, of " + word_list<FitName>() +
               ": radius of all taxels, first size of the object's shape, thickness and stiffening of the layout's "
               "material, zeros of each recording's columns x, y, z, and a gain for each taxel",
           {.unit = "NAMES", .default_text = "x0,z0,gain"});
  list.add("--start", &options->starts, "Value of a parameter at the start, such as \"radius=6 mm\"",
           {.unit = "NAME=VALUE"});
  list.add("--fix", &options->fixed, "Value of a parameter that is not fitted", {.unit = "NAME=VALUE"});
  list.add("--hold-out", &options->held_out,
           "Table that the parameters are not fitted to, but only its zeros and gains: it shows whether they hold",
           {.unit = "FILE"});
  list.add("--map", &options->map, "Columns of the taxels (*.recmap.json; default: guessed from their names)",
           {.unit = "FILE"});
  list.add("--pose", &options->pose,
           "Displacement of 1 in each column of a position, such as \"x=0.001 mm,z=-(1/480) mm\" or "
           "\"z=depth*-1 um\" (default: columns x, y, z with a unit in the head, such as \"x [mm]\")",
           {.unit = "LIST"});
  list.add("--press-axis", &options->press_axis, "Axis along which the object presses",
           {.unit = "AXIS", .check = one_of({"x", "y", "z"}), .default_text = "z"});
  list.add("--part", &options->part, "Rows that are compared: until the deepest place of a press, or all",
           {.unit = "WORD", .check = one_of({"loading", "all"}), .default_text = "loading"});
  list.add("--share", &options->share, "One gain of each taxel for all recordings",
           {.unit = "WORD", .check = one_of({"gain"})});
  list.add("--out", &options->out, "Folder for fit.json, points.csv, bells.svg, loading.svg and residuals.svg",
           {.unit = "DIR"});
  add_skin(list, options->skin);
  add_readout(list, options->readout);
  return [options](Console& console) { return run_fit_command(*options, console); };
}

}  // namespace taxel::cli
