// Parquet files: encodings, whole files, and files that are damaged. tests/parquet compares with pyarrow.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numeric>

#include "core/base/rng.h"
#include "core/run/parquet/encodings.h"
#include "core/run/parquet/metadata.h"
#include "core/run/parquet/parquet_file.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel::test {
namespace {

const std::vector<ParquetColumn> kColumns{
    {"index", ParquetType::int64},         {"time", ParquetType::float64}, {"readings", ParquetType::float32, true},
    {"exact", ParquetType::float64, true}, {"task", ParquetType::text},    {"names", ParquetType::text, true}};

/// Returns cells of kColumns with numbers that no encoding may change.
std::vector<ParquetCells> rough_cells(std::size_t rows) {
  const CounterRng rng(5);
  std::vector<std::int64_t> index;
  std::vector<double> time, exact;
  std::vector<float> readings;
  std::vector<std::string> task, names;
  std::vector<std::int32_t> lengths;
  for (std::size_t i = 0; i < rows; ++i) {
    index.push_back(static_cast<std::int64_t>(rng.bits(i)));
    time.push_back(0.01 * static_cast<double>(i));
    for (int k = 0; k < 3; ++k) readings.push_back(i % 5 == 0 ? 0.F : static_cast<float>(rng.uniform(3 * i)));
    lengths.push_back(static_cast<std::int32_t>(i % 4));
    for (std::size_t k = 0; k < i % 4; ++k) {
      exact.push_back(std::bit_cast<double>(rng.bits(100 + i)));
      names.push_back("taxel " + std::to_string(k));
    }
    task.push_back(i % 7 == 0 ? "" : "slide");
  }
  return {{index}, {time}, lists_of(readings, 3), {exact, lengths}, {task}, {names, lengths}};
}

/// Returns whether all bits are equal, also of numbers that are not numbers.
bool has_same_bits(const ParquetCells& a, const ParquetCells& b) {
  return a.lengths == b.lengths && a.values.index() == b.values.index() &&
         plain_bytes(a.values) == plain_bytes(b.values);
}

TEST(ParquetRuns, ReturnTheNumbersForAnyWidth) {
  const CounterRng rng(1);
  for (int bits = 1; bits <= 32; ++bits) {
    for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 64U, 1000U}) {
      std::vector<std::uint32_t> numbers;
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t source = rng.bits(i / 40) % 2 == 0 ? i / 40 : i;  // runs between packed numbers
        numbers.push_back(static_cast<std::uint32_t>(rng.bits(source) >> (64 - bits)));
      }
      EXPECT_EQ(from_packed_runs(packed_runs(numbers, bits), bits, count), numbers) << bits << " " << count;
    }
  }
}

TEST(ParquetRuns, AreShortForEqualNumbers) {
  const std::vector<std::uint32_t> equal(100000, 1);
  EXPECT_EQ(packed_runs(equal, 1).size(), 4U);  // a length of three bytes, and the number
}

TEST(ParquetRuns, RefuseBytesThatEndEarly) {
  const std::vector<std::uint32_t> numbers{1, 2, 3, 4, 5, 6, 7, 0, 1, 1};
  const std::string bytes = packed_runs(numbers, 3);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(from_packed_runs(bytes.substr(0, size), 3, numbers.size()), Error) << size;
}

TEST(ParquetStreams, AreInverse) {
  const std::string bytes = plain_bytes(std::vector<double>{1.5, -2.25, std::nan("1"), 0.1});
  EXPECT_EQ(joined_streams(split_streams(bytes, 8), 8), bytes);
  EXPECT_EQ(split_streams("abcdefgh", 4), "aebfcgdh");
}

TEST(ParquetDelta, ReturnsAnyNumbers) {
  const CounterRng rng(9);
  for (const std::size_t count : {0U, 1U, 2U, 32U, 33U, 128U, 129U, 130U, 1000U}) {
    for (int bits = 1; bits <= 64; bits += 7) {
      std::vector<std::int64_t> numbers;
      for (std::size_t i = 0; i < count; ++i) numbers.push_back(static_cast<std::int64_t>(rng.bits(i) >> (64 - bits)));
      const std::string bytes = delta_bytes(numbers);
      EXPECT_EQ(from_delta(bytes, count), numbers) << count << " " << bits;
      for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 8)
        EXPECT_THROW(from_delta(bytes.substr(0, size), count), Error);
    }
  }
}

TEST(ParquetDelta, IsShortForIndices) {
  std::vector<std::int64_t> indices(100000);
  std::iota(indices.begin(), indices.end(), 12345);
  EXPECT_LE(delta_bytes(indices).size(), 5U * (100000 / 128 + 3));
}

TEST(ParquetDictionary, KeepsZerosOfBothSignsApart) {
  const ParquetDictionary dictionary = dictionary_of(std::vector<double>{0.0, -0.0, 0.0}, 10);
  EXPECT_EQ(dictionary.indices, (std::vector<std::uint32_t>{0, 1, 0}));
}

TEST(Parquet, ReturnsEachBitOfEachType) {
  for (const std::size_t rows : {1U, 2U, 100U, 3000U}) {
    const std::vector<ParquetCells> cells = rough_cells(rows);
    const ParquetFile file(parquet_bytes(kColumns, cells, {{"key", "value"}}), "memory");
    EXPECT_EQ(file.columns(), kColumns);
    EXPECT_EQ(file.rows(), static_cast<std::int64_t>(rows));
    EXPECT_EQ(file.note("key"), "value");
    for (std::size_t i = 0; i < kColumns.size(); ++i)
      EXPECT_TRUE(has_same_bits(file.cells(0, i), cells[i])) << kColumns[i].name;
  }
}

TEST(Parquet, GivesEqualBytesForEqualCells) {
  EXPECT_EQ(parquet_bytes(kColumns, rough_cells(500)), parquet_bytes(kColumns, rough_cells(500)));
}

TEST(Parquet, WritesLongColumnsInSeveralPages) {
  const std::size_t rows = 800'000;
  const ParquetColumn column{"readings", ParquetType::float64, true};
  const ParquetCells cells = lists_of(std::vector<double>(3 * rows, 0.25), 3);
  const ParquetFile file(parquet_bytes({column}, {cells}), "memory");
  EXPECT_EQ(file.cells(0, 0), cells);
}

TEST(Parquet, MovesEncodedColumnsToAnotherFile) {
  const std::vector<ParquetCells> cells = rough_cells(200);
  const ParquetFile first(parquet_bytes(kColumns, cells), "first");
  std::string bytes;
  ParquetWriter writer(kColumns, [&](std::string_view more) { bytes += more; });
  for (int copy = 0; copy < 2; ++copy) {
    std::vector<EncodedColumn> encoded;
    for (std::size_t i = 0; i < kColumns.size(); ++i) encoded.push_back(first.encoded(0, i));
    writer.add(200, encoded);
  }
  writer.finish({});
  const ParquetFile both(bytes, "both");
  EXPECT_EQ(both.rows(), 400);
  for (std::size_t i = 0; i < kColumns.size(); ++i) EXPECT_TRUE(has_same_bits(both.cells(1, i), cells[i]));
  EXPECT_EQ(both.all_cells("task").rows(), 400U);
}

TEST(Parquet, ReadsFilesWithoutRows) {
  std::string bytes;
  ParquetWriter writer(kColumns, [&](std::string_view more) { bytes += more; });
  writer.finish({});
  const ParquetFile file(bytes, "empty");
  EXPECT_EQ(file.rows(), 0);
  EXPECT_EQ(file.row_groups(), 0U);
}

/// Returns a file of `rows` rows with one text of `size` bytes, which a dictionary repeats.
std::string repeated_text(std::size_t size, std::size_t rows) {
  const auto page = [](parquet::PageHeader header, const std::string& content) {
    const std::string compressed = zstd_compressed(content);
    header.uncompressed_bytes = static_cast<int>(content.size());
    header.compressed_bytes = static_cast<int>(compressed.size());
    return to_bytes(header) + compressed;
  };
  EncodedColumn column;
  column.pages = page({parquet::kDictionaryPage, 0, 0, 1, parquet::kPlain},
                      plain_bytes(std::vector<std::string>{std::string(size, 'a')}));
  column.dictionary_bytes = static_cast<std::int64_t>(column.pages.size());
  column.pages += page({parquet::kDataPage, 0, 0, static_cast<int>(rows), parquet::kRleDictionary},
                       static_cast<char>(1) + packed_runs(std::vector<std::uint32_t>(rows, 0), 1));
  column.values = static_cast<std::int64_t>(rows);
  column.encodings = {parquet::kPlain, parquet::kRle, parquet::kRleDictionary};
  column.codec = parquet::kZstd;
  std::string bytes;
  ParquetWriter writer({{"text", ParquetType::text}}, [&](std::string_view more) { bytes += more; });
  writer.add(static_cast<std::int64_t>(rows), {column});
  writer.finish({});
  return bytes;
}

// A file of a few hundred bytes announces 4 million rows of 2 kB, 8 GB. They are counted before they are made.
TEST(Parquet, RefusesValuesThatNeedTooMuchMemory) {
  const ParquetFile small(repeated_text(2000, 3), "a.parquet");
  EXPECT_EQ(std::get<std::vector<std::string>>(small.all_cells("text").values),
            std::vector<std::string>(3, std::string(2000, 'a')));
  const std::string bytes = repeated_text(2000, 4'000'000);
  EXPECT_LT(bytes.size(), 1000U);
  const ParquetFile large(bytes, "a.parquet");
  EXPECT_EQ(complaint_of([&] { static_cast<void>(large.cells(0, 0)); }),
            "a.parquet: text: needs more than 4096 MiB of memory for its values, which is not read");
  EXPECT_EQ(complaint_of([&] { static_cast<void>(large.all_cells("text")); }),
            "a.parquet: text: needs more than 1024 MiB of memory for its values, which is not read");
}

TEST(Parquet, NamesMissingFilesColumnsAndNotes) {
  const TempFolder folder;
  const std::string path = (folder / "gone.parquet").string();
  EXPECT_EQ(complaint_of([&] { ParquetFile{std::filesystem::path(path)}; }), path + ": no such file");
  const ParquetFile file(parquet_bytes(kColumns, rough_cells(3)), "a.parquet");
  EXPECT_EQ(complaint_of([&] { static_cast<void>(file.all_cells("force")); }),
            "a.parquet: force: there is no column of this name");
  EXPECT_EQ(complaint_of([&] { static_cast<void>(file.note("taxel")); }),
            "a.parquet: has no note \"taxel\" in its description");
  EXPECT_EQ(complaint_of([] { ParquetFile("not a table at all", "b.parquet"); }),
            "b.parquet: is not a Parquet file, or a part of one");
}

TEST(Parquet, RefusesColumnsOfDifferentLengths) {
  std::vector<ParquetCells> cells = rough_cells(3);
  cells[1] = {std::vector<double>{1, 2}};
  EXPECT_EQ(complaint_of([&] { parquet_bytes(kColumns, cells); }), "time: has 2 rows, the first column 3");
  cells[1] = {std::vector<float>{1, 2, 3}};
  EXPECT_EQ(complaint_of([&] { parquet_bytes(kColumns, cells); }),
            "time: the values are of another type than the column");
}

TEST(Parquet, RefusesEachFileThatEndsEarly) {
  const std::string bytes = parquet_bytes(kColumns, rough_cells(20));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(ParquetFile(bytes.substr(0, size), "cut"), Error) << size;
}

/// Reads all columns of a file, as a program does that has no reason to distrust the file.
void read_all(const std::string& bytes) {
  const ParquetFile file(bytes, "damaged");
  for (std::size_t group = 0; group < file.row_groups(); ++group)
    for (std::size_t i = 0; i < file.columns().size(); ++i) static_cast<void>(file.cells(group, i));
}

TEST(Parquet, NeverReadsChangedPagesAsOtherNumbers) {
  const std::vector<ParquetCells> cells = rough_cells(50);
  const std::string bytes = parquet_bytes({kColumns[1]}, {cells[1]});
  for (std::size_t at = 0; at + 1 < bytes.size(); ++at) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    try {
      const ParquetFile file(damaged, "damaged");
      if (file.row_groups() != 1 || file.columns() != std::vector{kColumns[1]}) continue;
      EXPECT_TRUE(has_same_bits(file.cells(0, 0), cells[1])) << at;
    } catch (const Error&) {  // most changes are noticed
    }
  }
}

TEST(Parquet, EndsWithAnErrorForAnyChangedByte) {
  const std::string bytes = parquet_bytes(kColumns, rough_cells(50));
  const CounterRng rng(3);
  for (std::uint64_t k = 0; k < 3000; ++k) {
    std::string damaged = bytes;
    for (std::uint64_t i = 0; i <= rng.bits(2 * k) % 3; ++i)
      damaged[rng.bits(5 * k + i) % damaged.size()] = static_cast<char>(rng.bits(7 * k + i));
    try {
      read_all(damaged);
    } catch (const Error& error) {
      EXPECT_FALSE(error.message().empty());
    }
  }
}

}  // namespace
}  // namespace taxel::test
