#include <fmt/format.h>

#include "core/run/batch/data_set.h"
#include "core/run/batch/data_set_meta.h"
#include "core/run/batch/episode_files.h"
#include "core/run/batch/row_files.h"
#include "core/run/batch/streamed_file.h"
#include "core/run/batch/survey.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

void write_whole(const fs::path& path, std::string_view bytes) {
  StreamedFile file(path);
  file.write(bytes);
  file.finish();
}

void write_layouts(const fs::path& path, const std::vector<EpisodeSensor>& sensors) {
  std::vector<std::int64_t> ids;
  std::vector<std::string> keys, names, layouts, units, calibrated, taxels;
  std::vector<std::int32_t> counts;
  for (const EpisodeSensor& sensor : sensors) {
    keys.push_back(sensor.layout_key);
    names.push_back(sensor.layout_name);
    layouts.push_back(sensor.layout_json);
    units.push_back(sensor.unit);
    calibrated.push_back(sensor.calibrated_unit);
    ids.insert(ids.end(), sensor.taxel_ids.begin(), sensor.taxel_ids.end());
    taxels.insert(taxels.end(), sensor.taxel_names.begin(), sensor.taxel_names.end());
    counts.push_back(static_cast<std::int32_t>(sensor.taxel_ids.size()));
  }
  write_whole(
      path,
      parquet_bytes(
          {{"key", ParquetType::text},
           {"name", ParquetType::text},
           {"unit", ParquetType::text},
           {"calibrated_unit", ParquetType::text},
           {"taxel_ids", ParquetType::int64, true},
           {"taxel_names", ParquetType::text, true},
           {"layout", ParquetType::text}},
          {{keys, {}}, {names, {}}, {units, {}}, {calibrated, {}}, {ids, counts}, {taxels, counts}, {layouts, {}}}));
}

std::vector<FailedJob> failed_jobs(const DataSetPlan& plan, const Survey& survey) {
  std::vector<std::string> errors;
  for (const Job& job : plan.list.jobs) errors.push_back(job.error);
  for (std::size_t g = 0; g < plan.groups.size(); ++g)
    for (std::size_t k = 0; k < plan.groups[g].jobs.size(); ++k)
      errors[plan.groups[g].jobs[k]] = survey.heads[g].outcomes[k].error;
  std::vector<FailedJob> failed;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const Job& job = plan.list.jobs[i];
    if (!errors[i].empty()) failed.push_back({job.line, job.number, job.id, errors[i], job.changes});
  }
  return failed;
}

void write_meta(const fs::path& folder, const DataSetPlan& plan, Survey& survey, const std::string& statistics,
                const std::vector<FailedJob>& failed) {
  for (const std::string& name : kRecordedColumns)
    if (survey.widths.contains(name))
      survey.info.features.push_back(feature_of(name, survey, plan.format.float64 ? "float64" : "float32"));
  for (const std::string& name : kIndexColumns) survey.info.features.push_back({name, "int64", 1, {}, ""});
  std::vector<std::int64_t> indices;
  for (std::size_t i = 0; i < survey.tasks.size(); ++i) indices.push_back(static_cast<std::int64_t>(i));
  write_whole(folder / "tasks.parquet",
              parquet_bytes({{"task_index", ParquetType::int64}, {"__index_level_0__", ParquetType::text}},
                            {{indices, {}}, {survey.tasks, {}}}, {{"pandas", task_index_note()}}));
  write_layouts(folder / "layouts.parquet", survey.sensors);
  write_whole(folder / "stats.json", statistics);
  write_whole(folder / "taxel.json", data_set_to_json(plan, survey.info, failed.size()));
  const std::string reasons = failed_to_jsonl(failed, plan.list.broken);
  if (!reasons.empty()) write_whole(folder / "failed.jsonl", reasons);
  write_whole(folder / "info.json", info_to_json(survey.info));
}

}  // namespace

std::string shard_name(const std::string& group) {
  return group + ".parquet";
}

DataSetCounts write_data_set(const fs::path& folder, const DataSetPlan& plan,
                             const std::function<void(double)>& on_progress) {
  Survey survey = survey_shards(plan);
  RowFiles rows(folder, plan, survey);
  EpisodeFiles episodes(folder, plan, survey);
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    on_progress(static_cast<double>(g) / static_cast<double>(plan.groups.size()));
    rows.add(g);
    episodes.add(g, rows);
  }
  rows.finish();
  episodes.finish();
  std::vector<FailedJob> failed = failed_jobs(plan, survey);
  write_meta(folder / "meta", plan, survey, rows.statistics_json(), failed);
  return {survey.info.episodes, survey.info.frames, std::move(failed)};
}

}  // namespace taxel
