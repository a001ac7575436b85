#include "core/run/parquet/parquet_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/base/error.h"
#include "core/run/parquet/column_codec.h"
#include "core/run/parquet/encodings.h"
#include "core/run/parquet/metadata.h"

namespace taxel::parquet {

FileBytes::FileBytes(const std::filesystem::path& path) : name_(path.string()), file_(path, os::Open::read) {
  if (os::is_missing(file_.error())) throw Error(name_, "no such file");
  if (!file_.is_open()) throw Error(name_, fmt::format("cannot be read: {}", os::error_text(file_.error())));
  if (file_.kind() != os::Kind::file) throw Error(name_, "is not a regular file");
  size_ = file_.size();
}

FileBytes::FileBytes(std::string bytes, std::string name) : name_(std::move(name)), bytes_(std::move(bytes)) {
  size_ = bytes_.size();
}

std::string FileBytes::read(std::uint64_t offset, std::uint64_t size) const {
  if (offset > size_ || size > size_ - offset) throw Error(name_, "is damaged: it ends within a column");
  if (!file_.is_open()) return bytes_.substr(offset, size);
  std::string bytes;
  if (const int why = file_.read_at(bytes, offset, size); why != 0)
    throw Error(name_, fmt::format("cannot be read: {}", os::error_text(why)));
  if (bytes.size() != size) throw Error(name_, "ends earlier than when it was opened");
  return bytes;
}

}  // namespace taxel::parquet

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

namespace {

constexpr std::size_t kMarkBytes = 4;
constexpr std::size_t kTailBytes = kMarkBytes + sizeof(std::uint32_t);  // size of the description, and the mark
constexpr std::size_t kMaxFooterBytes = std::size_t{1} << 26;
/// Memory of the values of one column in one row group: 16 episodes of 60 s with 2000 taxels take a third of it.
constexpr std::uint64_t kMaxGroupBytes = std::uint64_t{1} << 32;
/// Memory of all whole columns that are read from one file: 700 000 episodes of a data set.
constexpr std::uint64_t kMaxTableBytes = std::uint64_t{1} << 30;

}  // namespace

struct ParquetFile::State {
  pq::FileBytes bytes;
  pq::FileMeta meta = {};
  std::vector<pq::ColumnPlace> places = {};
  std::vector<ParquetColumn> columns = {};
  DecodedBytes whole_columns{kMaxTableBytes};

  void read_meta();
  void check_groups() const;
};

void ParquetFile::State::read_meta() {
  const std::string& name = bytes.name();
  const auto refuse = [&] { throw Error(name, "is not a Parquet file, or a part of one"); };
  if (bytes.size() < kTailBytes + kMarkBytes || bytes.read(0, kMarkBytes) != "PAR1") refuse();
  const std::string tail = bytes.read(bytes.size() - kTailBytes, kTailBytes);
  if (!tail.ends_with("PAR1")) refuse();
  std::uint32_t size = 0;
  std::memcpy(&size, tail.data(), sizeof size);
  if (size > kMaxFooterBytes || size > bytes.size() - kTailBytes - kMarkBytes)
    throw Error(name, fmt::format("is damaged: announces a description of {} bytes", size));
  try {
    meta = pq::file_meta_from(bytes.read(bytes.size() - kTailBytes - size, size));
    places = pq::read_schema(meta.schema);
    check_groups();
  } catch (const Error& e) {
    throw Error(name, e.where(), e.message());
  }
  for (const pq::ColumnPlace& place : places) columns.push_back(place.column);
}

void ParquetFile::State::check_groups() const {
  std::int64_t rows = 0;
  for (const pq::RowGroupMeta& group : meta.row_groups) {
    if (group.columns.size() != places.size() || group.rows < 0 || group.rows > meta.rows - rows)
      throw Error("is damaged: a row group has other columns or rows than the file");
    rows += group.rows;
  }
  if (rows != meta.rows) throw Error("is damaged: the row groups have other rows than the file");
}

ParquetFile::ParquetFile(const std::filesystem::path& path)
    : state_(std::make_unique<State>(State{pq::FileBytes(path)})) {
  state_->read_meta();
}
ParquetFile::ParquetFile(std::string bytes, std::string name)
    : state_(std::make_unique<State>(State{pq::FileBytes(std::move(bytes), std::move(name))})) {
  state_->read_meta();
}
ParquetFile::~ParquetFile() = default;

const std::string& ParquetFile::name() const {
  return state_->bytes.name();
}

const std::vector<ParquetColumn>& ParquetFile::columns() const {
  return state_->columns;
}

bool ParquetFile::has_column(const std::string& name) const {
  return std::ranges::find(state_->columns, name, &ParquetColumn::name) != state_->columns.end();
}

std::size_t ParquetFile::column(const std::string& name) const {
  const auto found = std::ranges::find(state_->columns, name, &ParquetColumn::name);
  if (found == state_->columns.end()) throw Error(state_->bytes.name(), name, "there is no column of this name");
  return static_cast<std::size_t>(found - state_->columns.begin());
}

std::size_t ParquetFile::row_groups() const {
  return state_->meta.row_groups.size();
}

std::int64_t ParquetFile::rows() const {
  return state_->meta.rows;
}

std::int64_t ParquetFile::rows(std::size_t row_group) const {
  return state_->meta.row_groups.at(row_group).rows;
}

const ParquetNotes& ParquetFile::notes() const {
  return state_->meta.notes;
}

const std::string& ParquetFile::note(const std::string& key) const {
  for (const auto& [name, value] : state_->meta.notes)
    if (name == key) return value;
  throw Error(state_->bytes.name(), fmt::format("has no note \"{}\" in its description", key));
}

EncodedColumn ParquetFile::encoded(std::size_t row_group, std::size_t column) const {
  const pq::ColumnMeta& meta = state_->meta.row_groups.at(row_group).columns.at(column);
  const std::int64_t begin = meta.dictionary_page && *meta.dictionary_page > 0 ? *meta.dictionary_page : meta.data_page;
  if (begin < 0 || meta.compressed_bytes < 0 || meta.values < 0 || meta.data_page < begin)
    throw Error(state_->bytes.name(), state_->columns[column].name, "is damaged: the pages have no place");
  EncodedColumn encoded;
  encoded.pages =
      state_->bytes.read(static_cast<std::uint64_t>(begin), static_cast<std::uint64_t>(meta.compressed_bytes));
  encoded.values = meta.values;
  encoded.uncompressed_bytes = meta.uncompressed_bytes;
  encoded.dictionary_bytes = meta.data_page - begin;
  encoded.encodings = meta.encodings;
  encoded.codec = meta.codec;
  encoded.min_value = meta.min_value;
  encoded.max_value = meta.max_value;
  return encoded;
}

ParquetCells ParquetFile::cells(std::size_t row_group, std::size_t column) const {
  DecodedBytes memory(kMaxGroupBytes);
  return cells(row_group, column, memory);
}

ParquetCells ParquetFile::cells(std::size_t row_group, std::size_t column, DecodedBytes& memory) const {
  const pq::ColumnPlace& place = state_->places.at(column);
  if (rows(row_group) == 0) return {from_plain(place.column.type, 0, ""), {}};  // pyarrow gives its pages no place
  try {
    return decode_column(place.column, place.levels, encoded(row_group, column), rows(row_group), memory);
  } catch (const Error& e) {
    throw Error(state_->bytes.name(), place.column.name, e.message());
  }
}

ParquetCells ParquetFile::all_cells(const std::string& name) const {
  const std::size_t index = column(name);
  ParquetCells all{from_plain(columns()[index].type, 0, ""), {}};
  for (std::size_t group = 0; group < row_groups(); ++group) {
    ParquetCells more = cells(group, index, state_->whole_columns);
    append_values(all.values, std::move(more.values));
    all.lengths.insert(all.lengths.end(), more.lengths.begin(), more.lengths.end());
  }
  return all;
}

}  // namespace taxel
