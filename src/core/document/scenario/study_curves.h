// What a study's runs read, to be looked at side by side.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/document/scenario/study.h"

namespace taxel {

struct StudyCurve {
  StudyRun run;
  std::vector<double> time;                   ///< per row [s]
  std::vector<std::vector<double>> readings;  ///< per taxel and row, SI
  std::string error;                          ///< why the run failed; empty: it did not
};

struct StudyCurves {
  Study study;
  std::vector<int> taxel_ids;  ///< order of the readings
  std::vector<StudyCurve> runs;
  double largest_reading = 0, longest = 0;  ///< over all runs: of readings, and [s]
  std::string problem;                      ///< why there are no runs at all; empty: there are
};
using StudyCurvesPtr = std::shared_ptr<const StudyCurves>;

}  // namespace taxel
