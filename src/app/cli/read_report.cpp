#include "app/cli/read_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/layout/words.h"

namespace taxel::cli {

double covered(const std::vector<TaxelSampleReading>& samples) {
  if (samples.empty()) return 0;
  const auto hits = std::count_if(samples.begin(), samples.end(), [](const TaxelSampleReading& s) { return s.hit; });
  return static_cast<double>(hits) / static_cast<double>(samples.size());
}

namespace {

std::string convergence_text(const SensorModel& model, const Convergence& convergence) {
  std::string text = fmt::format("\n{} with 1/4, 1 and 4 times the samples: {} on the skin\n",
                                 to_word(convergence.aggregate), fmt::join(convergence.samples, ", "));
  text += fmt::format("{:>6} {:<16} {:>14} {:>14} {:>14} {:>14}\n", "taxel", "name", "1/4", "1", "4", "4 less 1");
  for (std::size_t k = 0; k < model.layout.taxels.size(); ++k) {
    const Taxel& taxel = model.layout.taxels[k];
    text += fmt::format("{:>6} {:<16}", taxel.id, taxel.name);
    for (const std::vector<double>& values : convergence.values) text += fmt::format(" {:>14.6g}", values[k]);
    text += fmt::format(" {:>14.3g}\n", convergence.difference(k));
  }
  return text;
}

}  // namespace

std::string read_text(const ReadReport& report) {
  const dvec3& force = report.result.wrench_W.force;
  std::string text = fmt::format("force {} {} {} N on the layout, area {} m^2, {} polygons\n", force.x, force.y,
                                 force.z, report.result.surface.area(), report.result.surface.polygons.size());
  text += fmt::format("{:>6} {:<16} {:>8} {:>8}", "taxel", "name", "samples", "covered");
  for (const auto& [how, values] : report.readings) text += fmt::format(" {:>14}", to_word(how));
  text += '\n';
  for (int k = 0; k < report.model.taxel_count(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Taxel& taxel = report.model.layout.taxels[i];
    text += fmt::format("{:>6} {:<16} {:>8} {:>6.1f} %", taxel.id, taxel.name, report.behind[i].size(),
                        100 * covered(report.behind[i]));
    for (const auto& [how, values] : report.readings) text += fmt::format(" {:>14.6g}", values[i]);
    text += '\n';
  }
  text += fmt::format("force that no taxel reaches: {:.6g} N of {:.6g} N\n", report.force.uncovered,
                      report.force.covered + report.force.uncovered);
  text += "weighted_sum in Pa m^2, force in N, the others in Pa\n";
  return report.convergence ? text + convergence_text(report.model, *report.convergence) : text;
}

}  // namespace taxel::cli
