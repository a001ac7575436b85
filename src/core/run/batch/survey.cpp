#include "core/run/batch/survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace taxel {
namespace {

/// The columns that the shards have, and the widths of their lists.
class ColumnPlan {
 public:
  void add(const ShardHead& shard) {
    for (const auto& [name, width] : shard.widths) {
      const auto [known, is_new] = widths_.try_emplace(name, width);
      if (!is_new && known->second != width) known->second = -1;
      ++shards_of_[name];
    }
    ++shards_;
  }
  /// Returns the width of each column; -1 if it differs between rows, also if some shards do not have the column.
  [[nodiscard]] std::map<std::string, std::int64_t> widths() const {
    std::map<std::string, std::int64_t> widths = widths_;
    for (auto& [name, width] : widths)
      if (shards_of_.at(name) != shards_) width = -1;
    return widths;
  }

 private:
  std::map<std::string, std::int64_t> widths_;
  std::map<std::string, int> shards_of_;
  int shards_ = 0;
};

void survey_tasks(const DataSetPlan& plan, Survey& survey) {
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    for (std::size_t k = 0; k < plan.groups[g].jobs.size(); ++k) {
      if (!survey.heads[g].outcomes[k].error.empty()) continue;
      const std::string& task = plan.list.jobs[plan.groups[g].jobs[k]].task;
      const auto index = static_cast<std::int64_t>(survey.tasks.size());
      if (survey.task_indices.try_emplace(task, index).second) survey.tasks.push_back(task);
    }
  }
  survey.info.tasks = static_cast<std::int64_t>(survey.tasks.size());
}

/// Returns the common names of the taxels, or nothing if the layouts differ.
std::vector<std::string> common_taxels(const std::vector<EpisodeSensor>& sensors) {
  for (const EpisodeSensor& sensor : sensors)
    if (sensor.taxel_ids != sensors.front().taxel_ids || sensor.taxel_names != sensors.front().taxel_names) return {};
  std::vector<std::string> names;
  if (sensors.empty()) return names;
  const EpisodeSensor& first = sensors.front();
  for (std::size_t i = 0; i < first.taxel_ids.size(); ++i)
    names.push_back(first.taxel_names[i].empty() ? fmt::format("taxel_{}", first.taxel_ids[i]) : first.taxel_names[i]);
  return names;
}

/// Returns the unit of all layouts, or "mixed" (meta/layouts.parquet has the unit of each).
template <class Unit>
std::string common_unit(const std::vector<EpisodeSensor>& sensors, const Unit& unit) {
  for (const EpisodeSensor& sensor : sensors)
    if (unit(sensor) != unit(sensors.front())) return "mixed";
  return sensors.empty() ? "" : unit(sensors.front());
}

std::string unit_of(const std::string& column, const std::vector<EpisodeSensor>& sensors) {
  if (column == kTactile || column == kShear)
    return common_unit(sensors, [](const EpisodeSensor& sensor) { return sensor.unit; });
  if (column == kCalibrated)
    return common_unit(sensors, [](const EpisodeSensor& sensor) { return sensor.calibrated_unit; });
  const std::map<std::string, std::string> units{{kContactForce, "N"}, {kTravel, "m"}, {kTimestamp, "s"}};
  const auto unit = units.find(column);
  return unit != units.end() ? unit->second : std::string();
}

std::vector<std::string> components_of(const std::string& column, const std::vector<EpisodeSensor>& sensors) {
  if (column == kContactForce) return {"x", "y", "z"};
  if (column == kSensorPose || column == kMocapPose) return {"x", "y", "z", "qw", "qx", "qy", "qz"};
  if (column == kTactile || column == kCalibrated) return common_taxels(sensors);
  std::vector<std::string> components;
  if (column == kShear)
    for (const std::string& taxel : common_taxels(sensors))
      components.insert(components.end(), {taxel + " e1", taxel + " e2"});
  return components;
}

/// Returns the rate without the rounding of times.
double rate_of(double rows_per_second) {
  constexpr double kRounding = 1e-6;
  const double nearest = std::max(1.0, std::round(rows_per_second));
  return std::abs(rows_per_second - nearest) <= kRounding * nearest ? nearest : rows_per_second;
}

}  // namespace

void check_jobs(const JobList& list, const JobGroup& group, const ShardHead& head, const std::string& file) {
  bool is_same = head.group == group.id && head.outcomes.size() == group.jobs.size();
  for (std::size_t k = 0; is_same && k < group.jobs.size(); ++k)
    is_same = head.outcomes[k].id == list.jobs[group.jobs[k]].id;
  if (!is_same) throw Error(file, "has other jobs than its name says");
}

Survey survey_shards(const DataSetPlan& plan) {
  Survey survey;
  ColumnPlan columns;
  double duration = 0;
  std::map<std::string, std::size_t> sensor_of_key;
  for (const JobGroup& group : plan.groups) {
    const ParquetFile file(plan.shards / shard_name(group.id));
    ShardHead head = read_shard_head(file);
    check_jobs(plan.list, group, head, file.name());
    for (const JobOutcome& outcome : head.outcomes) {
      survey.info.episodes += outcome.rows > 0 ? 1 : 0;
      survey.info.frames += outcome.rows;
      duration += outcome.summary.duration;
    }
    survey.sensor_of_group.push_back(survey.sensors.size());
    if (head.sensor) {
      const auto [known, is_new] = sensor_of_key.try_emplace(head.sensor->layout_key, survey.sensors.size());
      survey.sensor_of_group.back() = known->second;
      if (is_new) survey.sensors.push_back(std::move(*head.sensor));
      head.sensor.reset();
    }
    if (file.rows() > 0) columns.add(head);
    survey.heads.push_back(std::move(head));
  }
  survey.widths = columns.widths();
  const double steps = static_cast<double>(survey.info.frames - survey.info.episodes);
  if (duration > 0) survey.info.rows_per_second = rate_of(steps / duration);
  if (plan.format.fps > 0) survey.info.rows_per_second = plan.format.fps;
  survey_tasks(plan, survey);
  return survey;
}

Feature feature_of(const std::string& name, const Survey& survey, const std::string& type) {
  return {name, type, survey.widths.at(name), components_of(name, survey.sensors), unit_of(name, survey.sensors)};
}

}  // namespace taxel
