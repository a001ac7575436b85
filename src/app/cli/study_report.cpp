#include "app/cli/study_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/run/recording/summary.h"

namespace taxel::cli {
namespace {

std::string head_of(const Study& study) {
  std::string head;
  for (const StudyParameter& parameter : study.parameters) head += "," + parameter.key;
  return head;
}

std::string values_of(const StudyRun& run) {
  std::string text;
  for (const double value : run.values) text += fmt::format(",{}", value);
  return text;
}

}  // namespace

std::string study_run_name(std::size_t run) {
  return fmt::format("run_{:03}", run);
}

std::string study_summary_csv(const Study& study, const std::vector<StudyResult>& results) {
  std::string csv = "run" + head_of(study) + ",taxel,peak,mean,largest_step\n";
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i].error.empty()) continue;
    const RecordedSensorSummary summary = summarize(results[i].recording).front();
    for (const TaxelSummary& taxel : summary.taxels)
      csv += fmt::format("{}{},{},{},{},{}\n", i, values_of(results[i].run), taxel.id, taxel.peak, taxel.mean,
                         taxel.largest_step);
  }
  return csv;
}

std::string study_runs_csv(const Study& study, const std::vector<StudyResult>& results) {
  std::string csv = "file" + head_of(study) + "\n";
  for (std::size_t i = 0; i < results.size(); ++i)
    if (results[i].error.empty()) csv += study_run_name(i) + ".csv" + values_of(results[i].run) + "\n";
  return csv;
}

std::string study_report_text(const StudyReport& report) {
  std::string text = fmt::format("{} runs of a {}\n", report.results.size(), to_word(report.study.scenario.kind));
  std::string head = fmt::format("{:<8}", "run");
  for (const StudyParameter& parameter : report.study.parameters) head += fmt::format(" {:>14}", parameter.key);
  text += head + fmt::format(" {:>6} {:>14} {:>12} {:>14}\n", "taxel", "highest peak", "force [N]", "largest step");
  for (std::size_t i = 0; i < report.results.size(); ++i) {
    const StudyResult& result = report.results[i];
    text += fmt::format("{:<8}", study_run_name(i));
    for (const double value : result.run.values) text += fmt::format(" {:>14.6g}", value);
    if (!result.error.empty()) {
      text += "  failed\n";
      continue;
    }
    const RecordedSensorSummary summary = summarize(result.recording).front();
    const TaxelSummary* highest = &summary.taxels.front();
    double step = 0;
    for (const TaxelSummary& taxel : summary.taxels) {
      if (taxel.peak > highest->peak) highest = &taxel;
      if (taxel.responds) step = std::max(step, taxel.largest_step);
    }
    text += fmt::format(" {:>6} {:>14.6g} {:>12.4g} {:>12.2f} %\n", highest->id, highest->peak, summary.largest_force,
                        100 * step);
  }
  text += fmt::format("{:.2f} s\n", report.wall);
  if (!report.files.empty()) text += fmt::format("wrote {}: {} files\n", report.folder, report.files.size());
  return text;
}

}  // namespace taxel::cli
