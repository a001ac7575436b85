// What `taxel study` tells of its runs.
#pragma once

#include <string>
#include <vector>

#include "app/cli/recorder.h"
#include "core/document/scenario/study.h"

namespace taxel::cli {

struct StudyResult {
  StudyRun run;
  Recording recording;
  std::string error;  ///< why the run failed; empty: it did not
};

struct StudyReport {
  const Study& study;
  const std::vector<StudyResult>& results;
  double wall = 0;                 ///< of all runs [s]
  std::vector<std::string> files;  ///< written, when --out was given
  std::string folder;
};

/// "run_007"
std::string study_run_name(std::size_t run);
/// A line per run and taxel: `run,PARAMETER...,taxel,peak,mean,largest_step`; mean over the rows, largest_step as a
/// part of the taxel's own peak. Runs that failed have none.
std::string study_summary_csv(const Study& study, const std::vector<StudyResult>& results);
/// A line per run that did not fail: `file,PARAMETER...`, for plots.
std::string study_runs_csv(const Study& study, const std::vector<StudyResult>& results);

std::string study_report_text(const StudyReport& report);
std::string study_report_json(const StudyReport& report);

}  // namespace taxel::cli
