#include "core/run/batch/shard.h"

#include "core/base/error.h"

namespace taxel {
namespace {

constexpr const char* kShardNote = "taxel-shard";

ParquetValues numbers_of(const GroupResult& result, std::size_t column, bool float64) {
  std::vector<double> all;
  for (const Episode& episode : result.episodes)
    all.insert(all.end(), episode.columns[column].values.begin(), episode.columns[column].values.end());
  if (float64) return all;
  std::vector<float> rounded;
  rounded.reserve(all.size());
  for (const double value : all) rounded.push_back(static_cast<float>(value));
  return rounded;
}

}  // namespace

std::string shard_bytes(const GroupResult& result, const BatchFormat& format) {
  std::vector<ParquetColumn> columns;
  std::vector<ParquetCells> cells;
  ShardHead head = result.head;
  const std::size_t count = result.episodes.empty() ? 0 : result.episodes.front().columns.size();
  for (std::size_t i = 0; i < count; ++i) {
    const EpisodeColumn& column = result.episodes.front().columns[i];
    columns.push_back({column.name, format.float64 ? ParquetType::float64 : ParquetType::float32, column.is_list});
    head.widths[column.name] = static_cast<std::int64_t>(column.width);
    ParquetValues values = numbers_of(result, i, format.float64);
    cells.push_back(column.is_list ? lists_of(std::move(values), column.width) : ParquetCells{std::move(values), {}});
  }
  return parquet_bytes(columns, cells, {{kShardNote, shard_head_to_json(head)}});
}

ShardHead read_shard_head(const ParquetFile& file) {
  ShardHead head = parse_shard_head(file.note(kShardNote), file.name());
  std::int64_t rows = 0;
  for (const JobOutcome& outcome : head.outcomes) rows += outcome.rows;
  if (rows != file.rows() || file.row_groups() > 1)
    throw Error(file.name(), "is damaged: the jobs have other rows than the table");
  return head;
}

}  // namespace taxel
