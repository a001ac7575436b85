#include "app/cli/align_report.h"

#include <fmt/format.h>

namespace taxel::cli {

std::string align_text(const AlignReport& report) {
  std::string text = fmt::format("The recording lies on the run with its times moved by {:.6g} s", report.shift);
  if (report.alignment)
    text +=
        fmt::format(" (correlation {:.4f} over {:.4g} s)", report.alignment->correlation, report.alignment->overlap);
  const std::string unit = report.real_unit.empty() ? "its unit" : report.real_unit;
  text +=
      fmt::format(".\nrecording = gain * reading{} ({} per {}; {}):\n", report.options.offset ? " + offset" : "", unit,
                  report.run_unit, report.options.common ? "one line for all taxels" : "a line for each taxel");
  text += fmt::format("{:>6} {:>14} {:>14} {:>8} {:>12} {:>12} {:>8}\n", "taxel", "gain", "offset", "R^2", "residual",
                      "largest", "values");
  for (const TaxelFit& fit : report.fits) {
    if (fit.refused.empty())
      text += fmt::format("{:>6} {:>14.6g} {:>14.6g} {:>8.4f} {:>12.4g} {:>12.4g} {:>8}\n", fit.taxel, fit.gain,
                          fit.offset, fit.r2, fit.residual, fit.largest_error, fit.points);
    else
      text += fmt::format("{:>6} {}\n", fit.taxel, fit.refused);
  }
  return text;
}

}  // namespace taxel::cli
