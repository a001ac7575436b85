// Writer and reader of Parquet files, on the disk or in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/os/file.h"
#include "core/run/parquet/column_codec.h"
#include "core/run/parquet/parquet.h"

namespace taxel::parquet {

/// The bytes of a file on the disk, or in memory, that is read in parts.
class FileBytes {
 public:
  /// Opens a regular file. Throws Error naming the file.
  explicit FileBytes(const std::filesystem::path& path);
  /// Takes a file in memory; `name` is its name in messages. Throws nothing.
  FileBytes(std::string bytes, std::string name);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Returns `size` bytes from `offset`. Throws Error naming the file if it ends before, or cannot be read.
  [[nodiscard]] std::string read(std::uint64_t offset, std::uint64_t size) const;

 private:
  std::string name_, bytes_;
  os::File file_;
  std::uint64_t size_ = 0;
};

}  // namespace taxel::parquet

namespace taxel {

/// Receives the bytes of a file in order. Throws Error if they cannot be written.
using ByteSink = std::function<void(std::string_view)>;

/// Writes a file row group by row group, without its earlier bytes in memory.
class ParquetWriter {
 public:
  /// Begins the file.
  ParquetWriter(std::vector<ParquetColumn> columns, ByteSink sink);
  ~ParquetWriter();
  ParquetWriter(const ParquetWriter&) = delete;
  ParquetWriter& operator=(const ParquetWriter&) = delete;

  /// Adds a row group with one part for each column. Throws Error if the numbers of rows differ.
  void add(const std::vector<ParquetCells>& columns);
  /// Adds a row group of `rows` rows that is encoded already. Throws the errors of the sink.
  void add(std::int64_t rows, const std::vector<EncodedColumn>& columns);
  /// Ends the file.
  void finish(const ParquetNotes& notes);
  [[nodiscard]] std::uint64_t bytes() const;  ///< number of bytes that are written

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns a whole file of one row group.
std::string parquet_bytes(const std::vector<ParquetColumn>& columns, const std::vector<ParquetCells>& cells,
                          const ParquetNotes& notes = {});

/// A file that is read part by part. Safe to use from one thread.
class ParquetFile {
 public:
  /// Reads the description at the end of a file. Throws Error naming the file: it cannot be read, is damaged, or has a
  /// column of a type that is not read.
  explicit ParquetFile(const std::filesystem::path& path);
  /// Reads a file in memory; `name` is its name in messages.
  ParquetFile(std::string bytes, std::string name);
  ~ParquetFile();
  ParquetFile(const ParquetFile&) = delete;
  ParquetFile& operator=(const ParquetFile&) = delete;

  [[nodiscard]] const std::string& name() const;  ///< name of the file in messages
  [[nodiscard]] const std::vector<ParquetColumn>& columns() const;
  /// Returns the index of a column. Throws Error if there is none of this name.
  [[nodiscard]] std::size_t column(const std::string& name) const;
  [[nodiscard]] bool has_column(const std::string& name) const;
  [[nodiscard]] std::size_t row_groups() const;
  [[nodiscard]] std::int64_t rows() const;
  [[nodiscard]] std::int64_t rows(std::size_t row_group) const;
  [[nodiscard]] const ParquetNotes& notes() const;
  /// Returns a text of the footer. Throws Error if there is none of this key.
  [[nodiscard]] const std::string& note(const std::string& key) const;

  /// Returns the pages of a column as they are in the file. Throws Error if they cannot be read.
  [[nodiscard]] EncodedColumn encoded(std::size_t row_group, std::size_t column) const;
  /// Returns the values of a column. Throws Error naming file and column if they are damaged, cannot be read, or need
  /// more than 4 GiB of memory.
  [[nodiscard]] ParquetCells cells(std::size_t row_group, std::size_t column) const;
  /// Returns a column of the whole file. Throws Error as above, and if all columns that were read by this function need
  /// more than 1 GiB of memory.
  [[nodiscard]] ParquetCells all_cells(const std::string& column) const;

 private:
  struct State;
  [[nodiscard]] ParquetCells cells(std::size_t row_group, std::size_t column, DecodedBytes& memory) const;

  std::unique_ptr<State> state_;
};

}  // namespace taxel
