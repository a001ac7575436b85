// Tables of readings for plots. A table that is read can be drawn, and its SVG has no number that is not finite.
#include "core/base/page/chart.h"
#include "core/run/plot/run_chart.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  const auto read = read_or_refuse([&] { return parse_readings_csv(input, "readings.csv"); });
  if (!read) return;
  for (const PlottedSensor& sensor : read->sensors) {
    require(sensor.readings.size() == sensor.taxel_ids.size(), "each taxel has a column");
    for (const auto& column : sensor.readings) require(column.size() == read->time.size(), "columns have all rows");
  }
  RunChartOptions options;
  options.has_readings = options.has_normalised = options.has_heat_map = options.has_all_taxels = true;
  const auto made = read_or_refuse([&] { return run_chart(*read, options); });
  if (!made) return;
  const Page page = chart_page(made->chart);
  require(page_to_svg(page).ends_with("</svg>\n"), "the SVG is complete");
  require(page_to_pdf(page).ends_with("%%EOF\n"), "the PDF is complete");
}

const Registered kTarget("readings_csv", run);

}  // namespace
}  // namespace taxel::fuzz
