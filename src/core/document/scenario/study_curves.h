// The readings of all runs of a study.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/document/scenario/study.h"
#include "core/layout/layout.h"

namespace taxel {

struct StudyCurve {
  StudyRun run;
  std::vector<double> time;                   ///< time of each row [s]
  std::vector<std::vector<double>> readings;  ///< readings by taxel and row, SI
  std::string error;                          ///< error of the run, or empty
};

struct StudyCurves {
  Study study;
  Aggregate aggregate = Aggregate::mean;  ///< aggregate of the readings, which has their unit
  std::string folder;                     ///< data set that the runs were read from, or empty
  std::vector<int> taxel_ids;             ///< ids in the order of the readings
  std::vector<StudyCurve> runs;
  double largest_reading = 0, longest = 0;  ///< largest reading and largest time [s] of all runs
  std::string problem;                      ///< reason why there are no runs, or empty
};
using StudyCurvesPtr = std::shared_ptr<const StudyCurves>;

}  // namespace taxel
