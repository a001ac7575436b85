#include "app/cli/samples_report.h"

#include <fmt/format.h>

namespace taxel::cli {

SamplesReport report_samples(const SensorModel& model) {
  SamplesReport report;
  report.name = model.layout.name;
  report.samples = static_cast<int>(model.samples.size());
  for (const std::vector<int>& taxels : model.taxels_of_sample) {
    report.used += taxels.empty() ? 0 : 1;
    report.shared += taxels.size() > 1 ? 1 : 0;
  }
  report.area = model.sampled_area;
  report.density = model.layout.sampling.density;
  report.seed = model.layout.sampling.seed;
  for (std::size_t k = 0; k < model.layout.taxels.size(); ++k) {
    const Taxel& taxel = model.layout.taxels[k];
    report.taxels.push_back({taxel.id, taxel.name, model.fields.first[k + 1] - model.fields.first[k]});
  }
  return report;
}

std::string samples_text(const SamplesReport& report) {
  std::string text = fmt::format("{} samples on {} m^2 (density {} per m^2, seed {}), {} used, {} by several taxels\n",
                                 report.samples, report.area, report.density, report.seed, report.used, report.shared);
  text += fmt::format("{:>6} {:<16} {:>8}\n", "taxel", "name", "samples");
  for (const SamplesReport::Taxel& taxel : report.taxels) {
    text += fmt::format("{:>6} {:<16} {:>8}\n", taxel.id, taxel.name, taxel.samples);
  }
  return text;
}

}  // namespace taxel::cli
