#include "app/studio/nouns/data_set/data_set_job.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/data_set/data_set_reader.h"
#include "app/studio/nouns/data_set/data_set_state.h"
#include "app/studio/nouns/data_set/episode_list.h"
#include "core/base/error.h"
#include "core/run/batch/data_set.h"

namespace taxel::studio {
namespace {

void read_set(const ui::DataSetRequest& request, ui::OpenDataSet& set, Progress& progress) {
  set.folder = request.folder;
  set = read_open_data_set(request.folder, progress);
}

const std::vector<double>& values_of(const Episode& episode, const char* name) {
  const auto found = std::ranges::find(episode.columns, name, &EpisodeColumn::name);
  if (found == episode.columns.end()) throw Error(fmt::format("the episode has no column {}", name));
  return found->values;
}

/// Returns a column of lists as a trace.
Trace trace_of(const Episode& episode, const char* name, std::uint64_t edition) {
  const std::vector<double>&time = values_of(episode, kTimestamp), &travel = values_of(episode, kTravel),
        &values = values_of(episode, name);
  const auto rows = static_cast<std::size_t>(episode.rows);
  if (time.size() != rows || travel.size() != rows)
    throw Error("the episode is damaged: it has another number of times or travels than rows");
  const std::size_t width = values.size() / rows;
  Trace trace{{}, edition};
  for (std::size_t r = 0; r < rows; ++r) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(r * width);
    trace.rows.push_back({time[r], travel[r], {first, first + static_cast<std::ptrdiff_t>(width)}});
  }
  return trace;
}

/// Reads the rows of one episode: one row group of one file.
void read_rows(const ui::EpisodeRequest& request, ui::EpisodeCurves& curves, Progress& /*progress*/) {
  curves.from = request.choice;
  const Episode episode = request.source->read_episode(static_cast<std::size_t>(request.choice.episode));
  const auto edition = static_cast<std::uint64_t>(request.choice.episode) + 1;
  curves.readings = trace_of(episode, kTactile, edition);
  curves.forces = trace_of(episode, kContactForce, edition);
}

}  // namespace

DataSetJob::DataSetJob(JobExecutor& executor)
    : sets_(executor, Priority::background, read_set), episodes_(executor, Priority::background, read_rows) {}

void DataSetJob::request(const std::optional<ui::DataSetRequest>& set,
                         const std::optional<ui::EpisodeRequest>& episode) {
  if (set) sets_.post(*set, Superseded::cancel);
  if (episode) episodes_.post(*episode, Superseded::cancel);
}

bool DataSetJob::update() {
  const ui::OpenDataSetPtr set = sets_.newest();
  const ui::EpisodeCurvesPtr curves = episodes_.newest();
  const bool is_new = set != set_ || curves != curves_;
  set_ = set;
  curves_ = curves;
  return is_new;
}

namespace {

class DataSetOfFeature final : public FeatureJob {
 public:
  explicit DataSetOfFeature(JobExecutor& executor) : job_(executor) {}

  void request_about_run(const ui::App& app, const SensorModelPtr& /*model*/,
                         const SendToSimulation& /*send*/) override {
    job_.request(app.get<ui::DataSetState>().request, ui::episode_request(app.get<ui::DataSetState>()));
  }
  bool take_about_run(const SensorModelPtr& /*model*/, const FollowedRun& /*run*/,
                      const SendToSimulation& /*send*/) override {
    return job_.update();
  }
  void report(HostEvents& events) override {
    const ui::OpenDataSetPtr& set = job_.set();
    if (!store(reported_, set) || !set) return;
    if (!set->problem.empty()) events.emplace_back(HostMessage{Severity::error, set->problem});
    events.emplace_back(DataSetRead{set->folder, set->problem.empty()});
  }
  void fill(ui::App& app) const override {
    ui::show_data_set(app.get<ui::DataSetState>(), job_.set(), job_.curves());
    app.get<ui::DataSetState>().is_reading = job_.is_reading_set();
  }
  [[nodiscard]] bool busy() const override { return job_.busy(); }

 private:
  DataSetJob job_;
  ui::OpenDataSetPtr reported_;
};

}  // namespace

std::unique_ptr<FeatureJob> make_data_set_job(JobExecutor& executor) {
  return std::make_unique<DataSetOfFeature>(executor);
}

}  // namespace taxel::studio
