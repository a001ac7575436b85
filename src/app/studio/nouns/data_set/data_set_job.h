// Reads data sets and the rows of their episodes on workers.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/data_set/data_set_state.h"

namespace taxel::studio {

class DataSetJob {
 public:
  explicit DataSetJob(JobExecutor& executor);

  /// Requests the data set and the rows of an episode, unless they were requested before.
  void request(const std::optional<ui::DataSetRequest>& set, const std::optional<ui::EpisodeRequest>& episode);
  /// Takes the newest results. Returns whether one of them is new.
  bool update();
  [[nodiscard]] bool busy() const { return sets_.busy() || episodes_.busy(); }
  [[nodiscard]] bool is_reading_set() const { return sets_.busy(); }
  /// The data set that was read last, or null. A data set that cannot be read has a problem and a folder only.
  [[nodiscard]] const ui::OpenDataSetPtr& set() const { return set_; }
  [[nodiscard]] const ui::EpisodeCurvesPtr& curves() const { return curves_; }

 private:
  NewestWins<ui::DataSetRequest, ui::OpenDataSet> sets_;
  NewestWins<ui::EpisodeRequest, ui::EpisodeCurves> episodes_;
  ui::OpenDataSetPtr set_;
  ui::EpisodeCurvesPtr curves_;
};

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_data_set_job(JobExecutor& executor);

}  // namespace taxel::studio
