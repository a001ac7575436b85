// What `taxel align` tells.
#pragma once

#include <string>
#include <vector>

#include "core/run/real/align.h"
#include "core/run/real/gain_fit.h"

namespace taxel::cli {

struct AlignReport {
  std::string run, real;  ///< files
  std::string run_unit, real_unit;
  double shift = 0;                    ///< [s]
  std::optional<Alignment> alignment;  ///< none: the shift was given
  FitOptions options;
  std::vector<TaxelFit> fits;
  std::vector<std::string> notes;
};

std::string align_text(const AlignReport& report);
std::string align_json(const AlignReport& report);

}  // namespace taxel::cli
