// The files of rows of a data set.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/run/batch/column_statistics.h"
#include "core/run/batch/streamed_file.h"
#include "core/run/batch/survey.h"

namespace taxel {

/// Columns that are recorded, and those that are computed from the place of a row, in the order of the files.
extern const std::vector<std::string> kRecordedColumns, kIndexColumns;

inline constexpr int kFilesPerChunk = 1000;

/// Writes the rows group by group. Recorded columns are copied from the shards as they are compressed.
class RowFiles {
 public:
  /// `plan` and `survey` must outlive the object.
  RowFiles(std::filesystem::path folder, const DataSetPlan& plan, const Survey& survey);

  /// Adds the rows of a group. Groups are added in order. Throws Error naming a file.
  void add(std::size_t group);
  void finish();
  [[nodiscard]] int file() const { return file_number_; }
  [[nodiscard]] std::int64_t row_group() const { return row_group_ - 1; }  ///< row group of the latest group
  [[nodiscard]] std::string statistics_json() const { return statistics_to_json(statistics_); }

 private:
  void begin_file();
  EncodedColumn computed(std::size_t column, const ParquetCells& cells);
  EncodedColumn recorded(const ParquetFile& shard, std::size_t column);
  std::vector<ParquetCells> index_cells(std::size_t group);

  std::filesystem::path folder_;
  const DataSetPlan& plan_;
  const Survey& survey_;
  std::vector<ParquetColumn> columns_;
  std::vector<ColumnStatistics> statistics_;  // parallel to columns_
  std::unique_ptr<StreamedFile> file_;
  std::unique_ptr<ParquetWriter> writer_;
  int file_number_ = -1;
  std::int64_t row_group_ = 0, episode_ = 0, frame_ = 0;
};

}  // namespace taxel
