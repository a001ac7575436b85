#include "core/run/batch/row_files.h"

#include <fmt/format.h>

#include <algorithm>

namespace taxel {
namespace {

constexpr std::uint64_t kMaxDataFileBytes = std::uint64_t{100} << 20;

std::string chunk_path(int file) {
  return fmt::format("chunk-{:03}/file-{:03}.parquet", file / kFilesPerChunk, file % kFilesPerChunk);
}

}  // namespace

const std::vector<std::string> kRecordedColumns{kTactile, kContactForce, kCalibrated, kShear,
                                                kTravel,  kSensorPose,   kMocapPose,  kTimestamp};
const std::vector<std::string> kIndexColumns{"frame_index", "episode_index", "index", "task_index"};

RowFiles::RowFiles(std::filesystem::path folder, const DataSetPlan& plan, const Survey& survey)
    : folder_(std::move(folder)), plan_(plan), survey_(survey) {
  const ParquetType number = plan.format.float64 ? ParquetType::float64 : ParquetType::float32;
  for (const std::string& name : kRecordedColumns)
    if (survey.widths.contains(name)) columns_.push_back({name, number, name != kTimestamp && name != kTravel});
  for (const std::string& name : kIndexColumns) columns_.push_back({name, ParquetType::int64, false});
  for (const ParquetColumn& column : columns_) {
    const auto width = survey.widths.find(column.name);
    const std::int64_t count = width != survey.widths.end() ? std::max<std::int64_t>(1, width->second) : 1;
    statistics_.push_back({column.name, std::vector<ComponentStatistics>(static_cast<std::size_t>(count))});
  }
}

void RowFiles::add(std::size_t group) {
  const ParquetFile shard(plan_.shards / shard_name(plan_.groups[group].id));
  if (shard.rows() == 0) return;
  if (!writer_ || writer_->bytes() > kMaxDataFileBytes) begin_file();
  std::vector<EncodedColumn> encoded;
  const std::vector<ParquetCells> indices = index_cells(group);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::size_t first_index = columns_.size() - kIndexColumns.size();
    encoded.push_back(i < first_index ? recorded(shard, i) : computed(i, indices[i - first_index]));
  }
  writer_->add(shard.rows(), encoded);
  ++row_group_;
}

void RowFiles::finish() {
  if (!writer_) return;
  writer_->finish({});
  file_->finish();
  writer_.reset();
}

void RowFiles::begin_file() {
  finish();
  ++file_number_;
  row_group_ = 0;
  file_ = std::make_unique<StreamedFile>(folder_ / "data" / chunk_path(file_number_));
  writer_ = std::make_unique<ParquetWriter>(columns_, [this](std::string_view bytes) { file_->write(bytes); });
}

EncodedColumn RowFiles::computed(std::size_t column, const ParquetCells& cells) {
  add_cells(cells, statistics_[column]);
  return encode_column(columns_[column], cells);
}

/// Returns the pages of a shard unchanged, or empty lists if the shard does not have the column.
EncodedColumn RowFiles::recorded(const ParquetFile& shard, std::size_t column) {
  const std::string& name = columns_[column].name;
  if (shard.has_column(name)) {
    add_cells(shard.cells(0, shard.column(name)), statistics_[column]);
    return shard.encoded(0, shard.column(name));
  }
  const std::vector<std::int32_t> lengths(static_cast<std::size_t>(shard.rows()), 0);
  return encode_column(columns_[column], plan_.format.float64 ? ParquetCells{std::vector<double>{}, lengths}
                                                              : ParquetCells{std::vector<float>{}, lengths});
}

/// Returns the cells of kIndexColumns.
std::vector<ParquetCells> RowFiles::index_cells(std::size_t group) {
  std::vector<std::int64_t> frame, episode, index, task;
  const std::vector<JobOutcome>& outcomes = survey_.heads[group].outcomes;
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    if (outcomes[k].rows == 0) continue;
    const Job& job = plan_.list.jobs[plan_.groups[group].jobs[k]];
    for (std::int64_t row = 0; row < outcomes[k].rows; ++row) {
      frame.push_back(row);
      episode.push_back(episode_);
      index.push_back(frame_++);
      task.push_back(survey_.task_indices.at(job.task));
    }
    ++episode_;
  }
  return {{std::move(frame), {}}, {std::move(episode), {}}, {std::move(index), {}}, {std::move(task), {}}};
}

}  // namespace taxel
