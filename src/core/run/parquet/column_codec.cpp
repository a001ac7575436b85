#include "core/run/parquet/column_codec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/run/parquet/encodings.h"
#include "core/run/parquet/metadata.h"

namespace taxel::parquet {
namespace {

SchemaElement leaf_of(const ParquetColumn& column, const std::string& name) {
  SchemaElement leaf{type_number(column.type), kRequired, name, {}, {}};
  if (column.type == ParquetType::text) leaf.converted = kUtf8;
  return leaf;
}

/// Finds the columns of a schema. A column is a value, or a list of values with the levels that the format prescribes.
class SchemaReader {
 public:
  explicit SchemaReader(const std::vector<SchemaElement>& schema) : schema_(schema) {}

  std::vector<ColumnPlace> read() {
    const SchemaElement& root = next();
    std::vector<ColumnPlace> columns;
    for (int i = 0; i < root.children.value_or(0); ++i) columns.push_back(read_column());
    if (at_ != schema_.size()) throw Error("is damaged: the schema has parts without a place");
    return columns;
  }

 private:
  const SchemaElement& next() {
    if (at_ >= schema_.size()) throw Error("is damaged: the schema ends early");
    return schema_[at_++];
  }

  static ParquetType type_of(const SchemaElement& leaf) {
    switch (leaf.type.value_or(-1)) {
      case kInt64:
        return ParquetType::int64;
      case kFloat:
        return ParquetType::float32;
      case kDouble:
        return ParquetType::float64;
      case kByteArray:
        return ParquetType::text;
      default:
        throw Error("", leaf.name, "has a type that is not read; int64, float, double and string are read");
    }
  }

  static int optional_level(const SchemaElement& element) {
    if (element.repetition == kRepeated) throw Error("", element.name, "is repeated, but not as a list");
    return element.repetition == kOptional ? 1 : 0;
  }

  ColumnPlace read_column() {
    const SchemaElement& element = next();
    const int level = optional_level(element);
    if (element.children.value_or(0) == 0) return {{element.name, type_of(element), false}, {level, 0, 0}};
    const SchemaElement& list = next();
    if (element.children != 1 || list.children != 1 || list.repetition != kRepeated)
      throw Error("", element.name, "is a structure, which is not read; values and lists of values are read");
    const SchemaElement& item = next();
    if (item.children.value_or(0) != 0) throw Error("", element.name, "is a list of lists, which is not read");
    return {{element.name, type_of(item), true}, {level + 1 + optional_level(item), 1, level + 1}};
  }

  const std::vector<SchemaElement>& schema_;
  std::size_t at_ = 0;
};

}  // namespace

int type_number(ParquetType type) {
  constexpr int kNumbers[] = {kInt64, kFloat, kDouble, kByteArray};
  return kNumbers[static_cast<std::size_t>(type)];
}

std::vector<SchemaElement> schema_of(const std::vector<ParquetColumn>& columns) {
  std::vector<SchemaElement> schema{{{}, {}, "schema", static_cast<int>(columns.size()), {}}};
  for (const ParquetColumn& column : columns) {
    if (!column.is_list) {
      schema.push_back(leaf_of(column, column.name));
      continue;
    }
    schema.push_back({{}, kRequired, column.name, 1, kList});
    schema.push_back({{}, kRepeated, "list", 1, {}});
    schema.push_back(leaf_of(column, "element"));
  }
  return schema;
}

std::vector<std::string> path_of(const ParquetColumn& column) {
  return column.is_list ? std::vector<std::string>{column.name, "list", "element"} : std::vector{column.name};
}

std::vector<ColumnPlace> read_schema(const std::vector<SchemaElement>& schema) {
  return SchemaReader(schema).read();
}

}  // namespace taxel::parquet

namespace taxel {
namespace {

namespace pq = parquet;

constexpr std::size_t kPageValues = std::size_t{1} << 20;  // about the number of values of a written page
constexpr std::size_t kMaxPageValues = std::size_t{1} << 24, kMaxPageBytes = std::size_t{1} << 27;  // of a read page
constexpr std::size_t kMaxDictionary = std::size_t{1} << 14;  // values; a larger dictionary is rarely smaller

/// Rows and values of one page.
struct PageRange {
  std::size_t first_row = 0, rows = 0, first_value = 0, values = 0;
};

std::vector<PageRange> pages_of(const ParquetCells& cells) {
  const std::size_t rows = cells.rows();
  std::vector<PageRange> pages;
  PageRange page;
  for (std::size_t row = 0; row < rows; ++row) {
    ++page.rows;
    page.values += cells.lengths.empty() ? 1 : static_cast<std::size_t>(cells.lengths[row]);
    if (page.values < kPageValues && row + 1 < rows) continue;
    pages.push_back(page);
    page = {row + 1, 0, page.first_value + page.values, 0};
  }
  return pages;
}

/// Returns levels in runs, after their size.
std::string level_bytes(std::span<const std::uint32_t> levels) {
  const std::string runs = packed_runs(levels, 1);
  const auto size = static_cast<std::uint32_t>(runs.size());
  return std::string(reinterpret_cast<const char*>(&size), sizeof size) + runs;
}

/// A page without its values.
struct PageLevels {
  std::string bytes;
  std::int32_t entries = 0;  // values, and empty lists
};

PageLevels levels_of(const ParquetCells& cells, const PageRange& page) {
  if (cells.lengths.empty()) return {"", static_cast<std::int32_t>(page.rows)};
  std::vector<std::uint32_t> repetition, definition;
  for (std::size_t row = page.first_row; row < page.first_row + page.rows; ++row) {
    const auto length = static_cast<std::size_t>(cells.lengths[row]);
    repetition.push_back(0);
    definition.push_back(length > 0 ? 1 : 0);
    if (length == 0) continue;
    repetition.insert(repetition.end(), length - 1, 1);
    definition.insert(definition.end(), length - 1, 1);
  }
  return {level_bytes(repetition) + level_bytes(definition), static_cast<std::int32_t>(definition.size())};
}

ParquetValues part_of(const ParquetValues& values, const PageRange& page) {
  const auto cut = [&]<class Value>(const std::vector<Value>& all) -> ParquetValues {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(page.first_value);
    return std::vector<Value>(begin, begin + static_cast<std::ptrdiff_t>(page.values));
  };
  return std::visit(cut, values);
}

std::size_t width_of(ParquetType type) {
  return type == ParquetType::float32 ? 4 : 8;
}

/// Adds a page with its header.
void append_page(EncodedColumn& column, pq::PageHeader header, const std::string& content) {
  const std::string compressed = zstd_compressed(content);
  header.uncompressed_bytes = static_cast<std::int32_t>(content.size());
  header.compressed_bytes = static_cast<std::int32_t>(compressed.size());
  const std::string head = to_bytes(header);
  column.pages += head + compressed;
  column.uncompressed_bytes += static_cast<std::int64_t>(head.size() + content.size());
}

EncodedColumn empty_column(std::vector<int> encodings) {
  EncodedColumn column;
  column.codec = pq::kZstd;
  column.encodings = std::move(encodings);
  return column;
}

/// Encodes each page by bytes(values of the page).
template <class Bytes>
EncodedColumn encode_pages(const ParquetCells& cells, int encoding, const Bytes& bytes) {
  EncodedColumn column = empty_column(encoding == pq::kPlain ? std::vector{encoding, pq::kRle}
                                                             : std::vector{pq::kPlain, encoding, pq::kRle});
  for (const PageRange& page : pages_of(cells)) {
    const PageLevels levels = levels_of(cells, page);
    append_page(column, {pq::kDataPage, 0, 0, levels.entries, encoding}, levels.bytes + bytes(page));
    column.values += levels.entries;
  }
  return column;
}

/// Returns nothing if there are too many different values.
std::optional<EncodedColumn> encode_by_dictionary(const ParquetCells& cells) {
  const ParquetDictionary dictionary = dictionary_of(cells.values, kMaxDictionary);
  if (dictionary.indices.empty()) return std::nullopt;
  const std::size_t count = count_of(dictionary.values);
  const int bits = bits_for(static_cast<std::uint32_t>(count));
  const std::span<const std::uint32_t> indices = dictionary.indices;
  EncodedColumn pages = encode_pages(cells, pq::kRleDictionary, [&](const PageRange& page) {
    return static_cast<char>(bits) + packed_runs(indices.subspan(page.first_value, page.values), bits);
  });
  EncodedColumn column = empty_column(pages.encodings);
  append_page(column, {pq::kDictionaryPage, 0, 0, static_cast<std::int32_t>(count), pq::kPlain},
              plain_bytes(dictionary.values));
  column.dictionary_bytes = static_cast<std::int64_t>(column.pages.size());
  column.pages += pages.pages;
  column.values = pages.values;
  column.uncompressed_bytes += pages.uncompressed_bytes;
  return column;
}

/// Sets the limits of whole numbers, with which a reader finds the row groups of an episode.
void set_limits(const ParquetValues& values, EncodedColumn& column) {
  const auto* numbers = std::get_if<std::vector<std::int64_t>>(&values);
  if (numbers == nullptr || numbers->empty()) return;
  const auto [low, high] = std::minmax_element(numbers->begin(), numbers->end());
  column.min_value = plain_bytes(std::vector{*low});
  column.max_value = plain_bytes(std::vector{*high});
}

void check_cells(const ParquetColumn& column, const ParquetCells& cells) {
  std::size_t sum = 0;
  for (const std::int32_t length : cells.lengths) sum += static_cast<std::size_t>(length);
  if (cells.values.index() != static_cast<std::size_t>(column.type) || column.is_list == cells.lengths.empty())
    if (!(column.is_list && cells.lengths.empty() && count_of(cells.values) == 0))
      throw Error("", column.name, "the values are of another type than the column");
  if (column.is_list && sum != count_of(cells.values))
    throw Error("", column.name, fmt::format("has {} values, its lists {}", count_of(cells.values), sum));
}

}  // namespace

EncodedColumn encode_column(const ParquetColumn& column, const ParquetCells& cells) {
  check_cells(column, cells);
  EncodedColumn best =
      encode_pages(cells, pq::kPlain, [&](const PageRange& page) { return plain_bytes(part_of(cells.values, page)); });
  const auto keep_smaller = [&](EncodedColumn other) {
    if (other.pages.size() < best.pages.size()) best = std::move(other);
  };
  if (std::optional<EncodedColumn> other = encode_by_dictionary(cells)) keep_smaller(std::move(*other));
  if (column.type == ParquetType::float32 || column.type == ParquetType::float64)
    keep_smaller(encode_pages(cells, pq::kByteStreamSplit, [&](const PageRange& page) {
      return split_streams(plain_bytes(part_of(cells.values, page)), width_of(column.type));
    }));
  if (const auto* numbers = std::get_if<std::vector<std::int64_t>>(&cells.values))
    keep_smaller(encode_pages(cells, pq::kDeltaBinaryPacked, [&](const PageRange& page) {
      return delta_bytes(std::span(*numbers).subspan(page.first_value, page.values));
    }));
  set_limits(cells.values, best);
  return best;
}

void DecodedBytes::take(std::uint64_t count, std::uint64_t bytes_of_each) {
  const std::uint64_t bytes = count * bytes_of_each;
  if (bytes > left_)
    throw Error(fmt::format("needs more than {} MiB of memory for its values, which is not read", most_ >> 20U));
  left_ -= bytes;
}

void append_values(ParquetValues& all, ParquetValues more) {
  const auto add = [&]<class Value>(std::vector<Value>& values) {
    auto& added = std::get<std::vector<Value>>(more);
    if (values.empty()) return std::swap(values, added);
    const std::size_t before = values.size();
    values.resize(before + added.size());
    std::move(added.begin(), added.end(), values.begin() + static_cast<std::ptrdiff_t>(before));
  };
  std::visit(add, all);
}

namespace {

/// Reads the pages of a column one after the other.
class ColumnReader {
 public:
  ColumnReader(const ParquetColumn& column, const ParquetLevels& levels, const EncodedColumn& encoded,
               DecodedBytes& memory)
      : column_(column), levels_(levels), encoded_(encoded), memory_(memory), bytes_(encoded.pages) {}

  ParquetCells read(std::int64_t rows) {
    ParquetCells cells{from_plain(column_.type, 0, ""), {}};
    std::int64_t entries = 0;
    while (entries < encoded_.values) {
      const pq::PageHeader header = pq::take_page_header(bytes_);
      if (header.type != pq::kDataPage && header.type != pq::kDictionaryPage)
        throw Error("has a page of version 2, which is not read: write the file with data_page_version=\"1.0\"");
      const std::string content = take_content(header);
      if (header.type == pq::kDictionaryPage) {
        dictionary_ = plain_values(static_cast<std::size_t>(header.values), content);
        continue;
      }
      if (header.values == 0) throw Error("has a page without values");
      if (header.values > encoded_.values - entries) throw Error("is damaged: the pages have too many values");
      entries += header.values;
      read_page(header, content, cells);
    }
    if (static_cast<std::int64_t>(cells.rows()) != rows)
      throw Error(fmt::format("is damaged: has {} rows where {} are announced", cells.rows(), rows));
    return cells;
  }

 private:
  std::string take_content(const pq::PageHeader& header) {
    if (header.values < 0 || static_cast<std::size_t>(header.values) > kMaxPageValues)
      throw Error(fmt::format("has a page of {} values, at most {} are read", header.values, kMaxPageValues));
    const auto size = static_cast<std::size_t>(header.compressed_bytes);
    const auto full = static_cast<std::size_t>(header.uncompressed_bytes);
    if (header.compressed_bytes < 0 || size > bytes_.size()) throw Error("is damaged: a page ends behind the column");
    if (header.uncompressed_bytes < 0 || full > kMaxPageBytes)
      throw Error(fmt::format("has a page of {} bytes, at most {} are read", header.uncompressed_bytes, kMaxPageBytes));
    const std::string_view content = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    if (encoded_.codec == pq::kZstd) return zstd_uncompressed(content, full);
    if (encoded_.codec != pq::kUncompressed)
      throw Error(
          fmt::format("is compressed by method {}, which is not read: write the file with Zstandard", encoded_.codec));
    return std::string(content);
  }

  /// Removes levels from the begin of a page.
  static std::vector<std::uint32_t> take_levels(std::string_view& content, int most, std::size_t count) {
    if (most == 0) return std::vector<std::uint32_t>(count, 0U);
    std::uint32_t size = 0;
    if (content.size() < sizeof size) throw Error("is damaged: a page has no levels");
    std::memcpy(&size, content.data(), sizeof size);
    content.remove_prefix(sizeof size);
    if (size > content.size()) throw Error("is damaged: a page has too few levels");
    const int bits = bits_for(static_cast<std::uint32_t>(most) + 1);
    std::vector<std::uint32_t> levels = from_packed_runs(content.substr(0, size), bits, count);
    content.remove_prefix(size);
    return levels;
  }

  void read_page(const pq::PageHeader& header, std::string_view content, ParquetCells& cells) {
    const auto count = static_cast<std::size_t>(header.values);
    if (column_.is_list) memory_.take(count, sizeof(std::int32_t));
    const std::vector<std::uint32_t> repetition = take_levels(content, levels_.max_repetition, count);
    const std::vector<std::uint32_t> definition = take_levels(content, levels_.max_definition, count);
    std::size_t present = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto level = static_cast<int>(definition[i]);
      const bool is_present = level == levels_.max_definition;
      const bool is_empty_list = column_.is_list && level == levels_.list_definition - 1;
      if (!is_present && !is_empty_list) throw Error("has a missing value; only columns without them are read");
      present += is_present ? 1 : 0;
      if (!column_.is_list) continue;
      if (repetition[i] == 0) cells.lengths.push_back(0);
      if (cells.lengths.empty() || repetition[i] > 1) throw Error("is damaged: a list has no begin");
      cells.lengths.back() += is_present ? 1 : 0;
    }
    append_values(cells.values, values_of(header.encoding, present, content));
  }

  [[nodiscard]] ParquetValues values_of(int encoding, std::size_t count, std::string_view content) const {
    if (encoding == pq::kPlain) return plain_values(count, content);
    if (encoding == pq::kByteStreamSplit && column_.type != ParquetType::text)
      return plain_values(count, joined_streams(content, width_of(column_.type)));
    if (encoding == pq::kDeltaBinaryPacked && column_.type == ParquetType::int64) {
      memory_.take(count, sizeof(std::int64_t));
      return from_delta(content, count);
    }
    if (encoding != pq::kRleDictionary && encoding != pq::kPlainDictionary)
      throw Error(fmt::format("has the encoding {}, which is not read: write the file without it", encoding));
    if (count == 0) return from_plain(column_.type, 0, "");
    if (!dictionary_) throw Error("is damaged: a page needs a dictionary, which is missing");
    if (content.empty()) throw Error("is damaged: a page has no values");
    const int bits = static_cast<unsigned char>(content.front());
    const std::vector<std::uint32_t> indices = from_packed_runs(content.substr(1), bits, count);
    take_memory_of(*dictionary_, indices);
    return from_dictionary(*dictionary_, indices);
  }

  /// Reads plain values. The texts of a page have fewer bytes than the page.
  [[nodiscard]] ParquetValues plain_values(std::size_t count, std::string_view content) const {
    const bool is_text = column_.type == ParquetType::text;
    memory_.take(count, is_text ? sizeof(std::string) : width_of(column_.type));
    if (is_text) memory_.take(content.size(), 1);
    return from_plain(column_.type, count, content);
  }

  /// Takes the memory of values that a dictionary repeats. from_dictionary() refuses indices that it does not have.
  void take_memory_of(const ParquetValues& dictionary, std::span<const std::uint32_t> indices) const {
    const auto* texts = std::get_if<std::vector<std::string>>(&dictionary);
    memory_.take(indices.size(), texts != nullptr ? sizeof(std::string) : width_of(column_.type));
    if (texts == nullptr) return;
    std::uint64_t bytes = 0;
    for (const std::uint32_t index : indices) bytes += index < texts->size() ? (*texts)[index].size() : 0;
    memory_.take(bytes, 1);
  }

  const ParquetColumn& column_;
  const ParquetLevels& levels_;
  const EncodedColumn& encoded_;
  DecodedBytes& memory_;
  std::string_view bytes_;
  std::optional<ParquetValues> dictionary_;
};

}  // namespace

ParquetCells decode_column(const ParquetColumn& column, const ParquetLevels& levels, const EncodedColumn& encoded,
                           std::int64_t rows, DecodedBytes& memory) {
  return ColumnReader(column, levels, encoded, memory).read(rows);
}

}  // namespace taxel
