#include <fmt/format.h>

#include "core/base/error.h"
#include "core/run/parquet/metadata.h"
#include "core/run/parquet/parquet_file.h"
#include "core/run/parquet/schema.h"

namespace taxel {
namespace {

namespace pq = parquet;

constexpr std::string_view kMark = "PAR1";  // first and last bytes of a file
constexpr const char* kCreatedBy = "Taxel Studio version 1";

}  // namespace

struct ParquetWriter::State {
  std::vector<ParquetColumn> columns;
  ByteSink sink;
  std::uint64_t bytes = 0;
  pq::FileMeta meta;

  void put(std::string_view text) {
    sink(text);
    bytes += text.size();
  }
};

ParquetWriter::ParquetWriter(std::vector<ParquetColumn> columns, ByteSink sink)
    : state_(std::make_unique<State>(State{std::move(columns), std::move(sink), 0, {}})) {
  state_->put(kMark);
}
ParquetWriter::~ParquetWriter() = default;

void ParquetWriter::add(const std::vector<ParquetCells>& columns) {
  if (columns.size() != state_->columns.size())
    throw Error(fmt::format("{} columns of {} are given", columns.size(), state_->columns.size()));
  std::vector<EncodedColumn> encoded;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].rows() != columns[0].rows())
      throw Error("", state_->columns[i].name,
                  fmt::format("has {} rows, the first column {}", columns[i].rows(), columns[0].rows()));
    encoded.push_back(encode_column(state_->columns[i], columns[i]));
  }
  add(columns.empty() ? 0 : static_cast<std::int64_t>(columns[0].rows()), encoded);
}

void ParquetWriter::add(std::int64_t rows, const std::vector<EncodedColumn>& columns) {
  if (rows == 0) return;  // readers expect rows in each row group
  State& s = *state_;
  pq::RowGroupMeta group;
  group.rows = rows;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const EncodedColumn& encoded = columns[i];
    pq::ColumnMeta& column = group.columns.emplace_back();
    const auto begin = static_cast<std::int64_t>(s.bytes), size = static_cast<std::int64_t>(encoded.pages.size());
    column = {pq::type_number(s.columns[i].type),
              encoded.encodings,
              pq::path_of(s.columns[i]),
              encoded.codec,
              encoded.values,
              encoded.uncompressed_bytes,
              size,
              begin + encoded.dictionary_bytes,
              {},
              encoded.min_value,
              encoded.max_value};
    if (encoded.dictionary_bytes > 0) column.dictionary_page = begin;
    group.bytes += encoded.uncompressed_bytes;
    group.compressed_bytes += size;
    s.put(encoded.pages);
  }
  s.meta.rows += rows;
  s.meta.row_groups.push_back(std::move(group));
}

void ParquetWriter::finish(const ParquetNotes& notes) {
  State& s = *state_;
  s.meta.schema = pq::schema_of(s.columns);
  s.meta.notes = notes;
  s.meta.created_by = kCreatedBy;
  const std::string footer = to_bytes(s.meta);
  const auto size = static_cast<std::uint32_t>(footer.size());
  s.put(footer);
  s.put({reinterpret_cast<const char*>(&size), sizeof size});
  s.put(kMark);
}

std::uint64_t ParquetWriter::bytes() const {
  return state_->bytes;
}

std::string parquet_bytes(const std::vector<ParquetColumn>& columns, const std::vector<ParquetCells>& cells,
                          const ParquetNotes& notes) {
  std::string bytes;
  ParquetWriter writer(columns, [&](std::string_view more) { bytes += more; });
  writer.add(cells);
  writer.finish(notes);
  return bytes;
}

}  // namespace taxel
