// taxel plot: charts of a recorded run or study as SVG and PDF.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/cli/command_line.h"
#include "app/cli/report_writer.h"
#include "core/base/files.h"
#include "core/base/page/chart.h"
#include "core/run/plot/plotted_run.h"
#include "core/run/plot/run_chart.h"

namespace taxel::cli {
namespace {

namespace fs = std::filesystem;

constexpr double kPointsPerMillimetre = 72 / 25.4;

struct PlotCommandOptions {
  std::string run, taxels, over, size;
  std::optional<std::string> title = {};
  std::vector<std::string> out;
  RunChartOptions chart;
  bool is_calibrated = false;
};

struct PlotReport {
  std::string run;
  RunChart made;
  std::size_t rows = 0;
  const PlottedRun* columns = nullptr;  ///< the run, or the first one of a study
  Page page;
  std::vector<std::string> files;

  void visit(ReportWriter& w) const {
    w("run", run);
    w("rows", rows);
    w("over", made.is_over_travel ? "travel" : "time");
    w("panels", made.chart.panels.size());
    w("width", page.width / kPointsPerMillimetre * 1e-3);
    w("height", page.height / kPointsPerMillimetre * 1e-3);
    w.list("taxels", made.taxels, [this](ReportWriter& one, const PlottedTaxel& taxel) {
      const PlottedSensor& sensor = columns->sensors[taxel.sensor];
      one("sensor", sensor.geom);
      one("id", sensor.taxel_ids[taxel.taxel]);
      one("name", sensor.taxel_names[taxel.taxel]);
      one("unit", sensor.unit);
      one("peak", taxel.peak);
      one("peak_time", columns->time[taxel.peak_row]);
      one("peak_travel", columns->travel[taxel.peak_row]);
    });
    w("files", files);
    w("notes", made.notes);
  }
  [[nodiscard]] std::string contents() const {
    if (made.taxels.empty())
      return made.chart.panels.size() == 1 ? "1 panel" : fmt::format("{} panels", made.chart.panels.size());
    return fmt::format("{} taxel{}", made.taxels.size(), made.taxels.size() == 1 ? "" : "s");
  }
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const std::string& file : files)
      text += fmt::format("wrote {}: {:.0f} x {:.0f} mm, {} over {}\n", file, page.width / kPointsPerMillimetre,
                          page.height / kPointsPerMillimetre, contents(), made.is_over_travel ? "travel" : "time");
    return text;
  }
};

/// Returns the texts between commas, without blanks around them.
std::vector<std::string> comma_list(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t first = 0; first <= text.size();) {
    const std::size_t end = std::min(text.find(',', first), text.size());
    std::string word = text.substr(first, end - first);
    while (word.starts_with(' ')) word.erase(0, 1);
    while (word.ends_with(' ')) word.pop_back();
    if (word.empty()) throw Error("plot", "--taxels", "must be ids or names with commas between them");
    words.push_back(word);
    first = end + 1;
  }
  return words;
}

/// Returns a length of a page given in millimetres, or 0 for any other text.
double page_length(const std::string& text) {
  constexpr double kMost = 2000;  // [mm]
  const double length = finite_number(text).value_or(0);
  return length > 0 && length <= kMost ? length * kPointsPerMillimetre : 0;
}

/// Returns a size such as "160x90", given in millimetres, in points.
PagePoint page_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  const PagePoint size{page_length(text.substr(0, cross)),
                       cross == std::string::npos ? 0 : page_length(text.substr(cross + 1))};
  if (!(size.x > 0) || !(size.y > 0))
    throw Error("plot", "--size",
                fmt::format("must be a width and a height up to 2000 mm such as 160x90, is \"{}\"", text));
  return size;
}

/// Throws Error unless all files are SVG or PDF by their names.
void expect_known_formats(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    const std::string extension = fs::path(file).extension().string();
    if (extension != ".svg" && extension != ".pdf")
      throw Error(file, "must end in .svg or .pdf; programs such as rsvg-convert make other pictures of an SVG file");
  }
}

PlotAxis axis_of(const std::string& word) {
  return word.empty() ? PlotAxis::automatic : word == "time" ? PlotAxis::time : PlotAxis::travel;
}

void draw_report(PlotReport& report, const PlotCommandOptions& options, Console& console) {
  Chart& chart = report.made.chart;
  if (!options.size.empty()) chart.page = page_size(options.size);
  if (options.title) chart.heading = chart.title = *options.title;
  for (const std::string& note : report.made.notes) console.note(report.run + ": " + note);
  try {
    report.page = chart_page(chart);
  } catch (const Error& error) {
    throw Error("plot", "--size", error.message());
  }
  for (const std::string& file : options.out) {
    write_file_atomically(file, file.ends_with(".pdf") ? page_to_pdf(report.page) : page_to_svg(report.page));
    report.files.push_back(file);
  }
  if (options.out.empty() && !console.json()) return console.result(page_to_svg(report.page));
  print_report(console, report, JsonStyle::short_arrays);
}

int run_plot_command(const PlotCommandOptions& given, Console& console) {
  PlotCommandOptions options = given;
  expect_known_formats(options.out);
  if (!options.taxels.empty()) options.chart.taxels = comma_list(options.taxels);
  options.chart.over = axis_of(options.over);
  PlotReport report;
  report.run = options.run;
  if (is_study_folder(options.run)) {
    if (options.chart.has_heat_map || options.chart.has_forces || options.is_calibrated)
      throw Error(options.run,
                  "is a study: --heat-map, --forces and --calibrated are for one run, such as its run_000.npz");
    const StudyFolder study = read_study_folder(options.run);
    report.made = study_chart(study.runs, study.columns, options.chart);
    report.columns = &study.runs.front().run;
    for (const StudiedRun& one : study.runs) report.rows += one.run.time.size();
    draw_report(report, options, console);
    return kDone;
  }
  const PlottedRun run = read_plotted_run(options.run, options.is_calibrated);
  report.made = run_chart(run, options.chart);
  report.columns = &run;
  report.rows = run.time.size();
  draw_report(report, options, console);
  return kDone;
}

}  // namespace

Run add_plot(OptionList& list) {
  const auto options = std::make_shared<PlotCommandOptions>();
  RunChartOptions& chart = options->chart;
  list.add("RUN", &options->run,
           "Folder that `taxel sweep`, `play`, `run` or `study` wrote, or its readings.npz or readings.csv",
           required());
  list.add("--out", &options->out, "File to write, .svg or .pdf; may be repeated (default: SVG to stdout)",
           {.unit = "FILE"});
  list.add("--readings", &chart.has_readings, "Readings in their unit (default without other contents)");
  list.add("--normalised", &chart.has_normalised,
           "Readings as fractions of the largest one, as in Figure 4 of the paper");
  list.add("--heat-map", &chart.has_heat_map, "Readings of all taxels as colours");
  list.add("--forces", &chart.has_forces, "Contact force on the sensor, world frame");
  list.add("--over", &options->over, "Horizontal axis (default: travel if the body always moves, otherwise time)",
           {.unit = "AXIS", .check = one_of({"travel", "time"})});
  list.add("--taxels", &options->taxels, "Ids or names with commas between them, GEOM/ID among several sensors",
           {.unit = "LIST"});
  list.add("--all", &chart.has_all_taxels, "All taxels, not only those above 5 % of the largest reading",
           {.excludes = {"--taxels"}});
  list.add("--sensor", &chart.sensor, "Geom of the only sensor to plot", {.unit = "GEOM"});
  list.add("--calibrated", &options->is_calibrated, "Calibrated values in place of readings");
  list.add("--size", &options->size, "Width and height of the page, such as 88x60 [mm] (default: as its content needs)",
           {.unit = "WxH"});
  list.add("--title", [options](const std::string& text) { options->title = text; }, "Title above the plot",
           {.unit = "TEXT"});
  return [options](Console& console) { return run_plot_command(*options, console); };
}

}  // namespace taxel::cli
