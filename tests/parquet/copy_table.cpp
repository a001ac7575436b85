// Reads a Parquet file and writes it again: `copy_table IN OUT`. run.py compares both files with pyarrow.
#include <cstdio>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/run/parquet/parquet_file.h"

namespace {

void copy_table(const char* from, const char* to) {
  const taxel::ParquetFile in{std::filesystem::path(from)};
  std::string bytes;
  taxel::ParquetWriter writer(in.columns(), [&](std::string_view more) { bytes += more; });
  for (std::size_t group = 0; group < in.row_groups(); ++group) {
    std::vector<taxel::ParquetCells> cells;
    for (std::size_t column = 0; column < in.columns().size(); ++column) cells.push_back(in.cells(group, column));
    writer.add(cells);
  }
  writer.finish({});
  taxel::write_file_atomically(to, bytes);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    copy_table(argv[1], argv[2]);
  } catch (const taxel::Error& error) {
    std::fputs(error.what(), stderr);
    return 2;
  }
  return 0;
}
