#include <nlohmann/json.hpp>

#include "app/cli/study_report.h"
#include "app/vector_json.h"
#include "core/run/recording/summary.h"

namespace taxel::cli {

std::string study_report_json(const StudyReport& report) {
  using Json = nlohmann::ordered_json;
  Json json = Json::parse(study_to_json(report.study));
  json["runs"] = Json::array();
  for (std::size_t i = 0; i < report.results.size(); ++i) {
    const StudyResult& result = report.results[i];
    Json run = {{"name", study_run_name(i)}, {"values", result.run.values}};
    if (result.error.empty()) {
      const RecordedSensorSummary summary = summarize(result.recording).front();
      run["rows"] = result.recording.rows.size();
      run["largest_force"] = summary.largest_force;
      run["taxels"] = Json::array();
      for (const TaxelSummary& taxel : summary.taxels)
        run["taxels"].push_back({{"id", taxel.id},
                                 {"peak", taxel.peak},
                                 {"mean", taxel.mean},
                                 {"largest_step", taxel.largest_step},
                                 {"responds", taxel.responds}});
    } else {
      run["error"] = result.error;
    }
    json["runs"].push_back(std::move(run));
  }
  json["wall_seconds"] = report.wall;
  json["files"] = report.files;
  return text_of(json);
}

}  // namespace taxel::cli
