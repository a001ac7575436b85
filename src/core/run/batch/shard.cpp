#include "core/run/batch/shard.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/files.h"

namespace taxel {
namespace {

constexpr const char* kHead = "head.json";

/// Opens a shard, of which not more is unpacked than its bytes can hold, whatever sizes it announces.
ZipArchive archive_of(std::string bytes, std::string name) {
  constexpr std::uint64_t kMostPacked = 1032;  // of deflate: 258 bytes take 2 bits at least
  const std::uint64_t most = std::min(kMostShardBytes, kMostPacked * bytes.size());
  return {std::move(name), std::move(bytes), most};
}

template <class Value>
std::vector<Value> numbers_of(const GroupResult& result, std::size_t column) {
  std::vector<Value> all;
  for (const Episode& episode : result.episodes)
    for (const double value : episode.columns[column].values) all.push_back(static_cast<Value>(value));
  return all;
}

}  // namespace

std::string shard_name(const std::string& group) {
  return "shards/" + group + ".npz";
}

std::string shard_bytes(const GroupResult& result, const BatchFormat& format) {
  NpzWriter arrays;
  ShardHead head = result.head;
  std::size_t rows = 0;
  for (const Episode& episode : result.episodes) rows += static_cast<std::size_t>(episode.rows);
  const std::size_t count = result.episodes.empty() ? 0 : result.episodes.front().columns.size();
  for (std::size_t i = 0; i < count; ++i) {
    const EpisodeColumn& column = result.episodes.front().columns[i];
    head.columns.push_back({column.name, column.width, column.is_list});
    NpzWriter::Shape shape{rows};
    if (column.is_list) shape.push_back(column.width);
    format.float64 ? arrays.add(column.name, shape, numbers_of<double>(result, i))
                   : arrays.add(column.name, shape, numbers_of<float>(result, i));
  }
  arrays.add_file(kHead, shard_head_to_json(head));
  return arrays.bytes(NpzWriter::Packing::deflated);
}

Shard::Shard(const std::filesystem::path& path) : Shard(read_file(path, kMostShardBytes), path.string()) {}

Shard::Shard(std::string bytes, std::string name) : Shard(archive_of(std::move(bytes), std::move(name))) {}

Shard::Shard(ZipArchive archive)
    : head_(parse_shard_head(archive.read(kHead), archive.file())), arrays_(std::move(archive)) {
  for (const JobOutcome& outcome : head_.outcomes) rows_ += static_cast<std::size_t>(outcome.rows);
}

std::vector<double> Shard::values(const ShardColumn& column) const {
  NpzReader::Shape shape{rows_};
  if (column.is_list) shape.push_back(column.width);
  return arrays_.doubles(column.name, shape);
}

EpisodeColumn Shard::rows(const std::string& column, std::int64_t first, std::int64_t count) const {
  const auto found = std::ranges::find(head_.columns, column, &ShardColumn::name);
  if (found == head_.columns.end()) throw Error(file(), column, "is missing");
  const auto all = static_cast<std::int64_t>(rows_);
  if (first < 0 || count < 0 || first > all || count > all - first)
    throw Error(file(), column, "has not the rows that the list of episodes names");
  const std::vector<double> values = this->values(*found);
  const auto width = static_cast<std::int64_t>(found->width);
  return {found->name,
          found->width,
          found->is_list,
          {values.begin() + first * width, values.begin() + (first + count) * width}};
}

void Shard::check() const {
  for (const ShardColumn& column : head_.columns) static_cast<void>(values(column));
}

}  // namespace taxel
