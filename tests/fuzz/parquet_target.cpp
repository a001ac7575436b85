// Parquet files: every column of every row group.
#include <algorithm>

#include "core/run/parquet/parquet_file.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

/// Returns whether a file has few values. A small file can have many equal values, which is correct but slow.
bool is_quick_table(const ParquetFile& file) {
  std::int64_t values = 0;
  for (std::size_t group = 0; group < file.row_groups(); ++group)
    for (std::size_t column = 0; column < file.columns().size(); ++column)
      if (file.rows(group) > 0) values += std::min<std::int64_t>(file.encoded(group, column).values, 1 << 20);
  return values <= 100'000;
}

/// Returns the cells of a file, row group by row group.
std::vector<std::vector<ParquetCells>> read_groups(const ParquetFile& file) {
  std::vector<std::vector<ParquetCells>> groups;
  for (std::size_t group = 0; group < file.row_groups(); ++group) {
    std::vector<ParquetCells>& cells = groups.emplace_back();
    for (std::size_t column = 0; column < file.columns().size(); ++column) {
      cells.push_back(file.cells(group, column));
      require(cells.back().rows() == static_cast<std::size_t>(file.rows(group)), "a column has the rows of its group");
    }
  }
  return groups;
}

std::string write_groups(const std::vector<ParquetColumn>& columns,
                         const std::vector<std::vector<ParquetCells>>& groups) {
  std::string bytes;
  ParquetWriter writer(columns, [&](std::string_view more) { bytes += more; });
  for (const std::vector<ParquetCells>& cells : groups) writer.add(cells);
  writer.finish({});
  return bytes;
}

void run(const std::string& input) {
  std::vector<ParquetColumn> columns;
  const auto groups = read_or_refuse([&] {
    const ParquetFile file(input, "input.parquet");
    if (!is_quick_table(file)) throw Error("has too many values for a fuzzer");
    columns = file.columns();
    return read_groups(file);
  });
  if (!groups) return;
  const std::string written = write_groups(columns, *groups);
  const ParquetFile again(written, "again.parquet");
  require(write_groups(columns, read_groups(again)) == written, "a table that is read can be written and read again");
}

const Registered kTarget("parquet", run);

}  // namespace
}  // namespace taxel::fuzz
