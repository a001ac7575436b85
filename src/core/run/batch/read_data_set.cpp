#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/base/error.h"
#include "core/run/batch/data_set.h"
#include "core/run/batch/episode_files.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEpisodesFile = "meta/episodes/chunk-000/file-000.parquet";
constexpr const char* kLayoutsFile = "meta/layouts.parquet";

/// Reads a whole column of one type. Throws Error naming file and column if it is of another type.
template <class Value>
std::vector<Value> whole_column(const ParquetFile& file, const std::string& name) {
  ParquetCells cells = file.all_cells(name);
  auto* values = std::get_if<std::vector<Value>>(&cells.values);
  if (values == nullptr || file.columns()[file.column(name)].is_list)
    throw Error(file.name(), name, "is of another type than in a data set");
  return std::move(*values);
}

template <class Value>
std::vector<std::vector<Value>> whole_lists(const ParquetFile& file, const std::string& name) {
  ParquetCells cells = file.all_cells(name);
  auto* values = std::get_if<std::vector<Value>>(&cells.values);
  if (values == nullptr || !file.columns()[file.column(name)].is_list)
    throw Error(file.name(), name, "is of another type than in a data set");
  std::vector<std::vector<Value>> lists;
  std::size_t first = 0;
  for (const std::int32_t length : cells.lengths) {
    const auto begin = std::make_move_iterator(values->begin() + static_cast<std::ptrdiff_t>(first));
    lists.emplace_back(begin, begin + length);
    first += static_cast<std::size_t>(length);
  }
  return lists;
}

std::size_t place_of(const char* const* begin, const char* const* end, std::string_view name) {
  return static_cast<std::size_t>(std::find(begin, end, name) - begin);
}

/// The columns of the table of episodes.
struct EpisodeTable {
  explicit EpisodeTable(const ParquetFile& file) : tasks(whole_lists<std::string>(file, "tasks")) {
    for (const char* name : kEpisodeNumbers) numbers.push_back(whole_column<std::int64_t>(file, name));
    for (const char* name : kEpisodeTexts) texts.push_back(whole_column<std::string>(file, name));
    for (const char* name : kEpisodeValues) values.push_back(whole_column<double>(file, name));
  }
  [[nodiscard]] std::int64_t number(std::string_view name, std::size_t row) const {
    return numbers[place_of(kEpisodeNumbers.begin(), kEpisodeNumbers.end(), name)][row];
  }
  std::vector<std::vector<std::string>> tasks;
  std::vector<std::vector<std::int64_t>> numbers;
  std::vector<std::vector<std::string>> texts;
  std::vector<std::vector<double>> values;
};

EpisodeEntry entry_of(const EpisodeTable& table, std::size_t row) {
  EpisodeEntry entry;
  entry.index = table.number("episode_index", row);
  entry.rows = table.number("length", row);
  entry.task = table.tasks[row].empty() ? "" : table.tasks[row].front();
  entry.job = table.texts[0][row];
  entry.scenario = table.texts[1][row];
  entry.changes = table.texts[2][row];
  entry.line = static_cast<int>(table.number("taxel/line", row));
  entry.seed = table.number("taxel/seed", row);
  entry.layout = static_cast<std::size_t>(table.number("taxel/layout", row));
  entry.summary = {table.values[1][row], table.values[2][row], static_cast<int>(table.number("taxel/peak_taxel", row)),
                   table.values[0][row]};
  entry.file = fmt::format("data/chunk-{:03}/file-{:03}.parquet", table.number("data/chunk_index", row),
                           table.number("data/file_index", row));
  entry.row_group = static_cast<std::size_t>(table.number("taxel/row_group", row));
  entry.first_row = table.number("taxel/first_row", row);
  return entry;
}

/// Returns the values of `count` rows from `first` as numbers of 64 bits.
EpisodeColumn part_of_rows(const ParquetColumn& column, const ParquetCells& cells, std::size_t first,
                           std::size_t count) {
  EpisodeColumn part{column.name, 1, column.is_list, {}};
  std::size_t begin = first, values = count;
  if (column.is_list) {
    const auto lengths = cells.lengths.begin();
    const auto at = lengths + static_cast<std::ptrdiff_t>(first), end = at + static_cast<std::ptrdiff_t>(count);
    begin = std::accumulate(lengths, at, std::size_t{0}, std::plus<std::size_t>());
    values = std::accumulate(at, end, std::size_t{0}, std::plus<std::size_t>());
    part.width = count > 0 ? values / count : 0;
  }
  std::visit(
      [&]<class Value>(const std::vector<Value>& all) {
        if constexpr (!std::is_same_v<Value, std::string>)
          for (std::size_t i = begin; i < begin + values; ++i) part.values.push_back(static_cast<double>(all[i]));
      },
      cells.values);
  return part;
}

}  // namespace

DataSet::DataSet(const fs::path& folder) : folder_(folder) {
  read_layouts();
  read_episodes();
}

void DataSet::read_layouts() {
  const ParquetFile file(folder_ / kLayoutsFile);
  auto keys = whole_column<std::string>(file, "key");
  std::set<std::string_view> known;
  for (const std::string& key : keys)
    if (!known.insert(key).second)
      throw Error(file.name(), "key", fmt::format("is damaged: layout \"{}\" is listed twice", key.substr(0, 80)));
  auto names = whole_column<std::string>(file, "name"), units = whole_column<std::string>(file, "unit");
  auto layouts = whole_column<std::string>(file, "layout");
  auto calibrated = whole_column<std::string>(file, "calibrated_unit");
  auto ids = whole_lists<std::int64_t>(file, "taxel_ids");
  auto taxels = whole_lists<std::string>(file, "taxel_names");
  for (std::size_t i = 0; i < keys.size(); ++i)
    layouts_.push_back({std::move(keys[i]), std::move(layouts[i]), std::move(names[i]), std::move(ids[i]),
                        std::move(taxels[i]), std::move(units[i]), std::move(calibrated[i])});
}

void DataSet::read_episodes() {
  const ParquetFile file(folder_ / kEpisodesFile);
  const EpisodeTable table(file);
  for (std::size_t row = 0; row < static_cast<std::size_t>(file.rows()); ++row) {
    EpisodeEntry entry = entry_of(table, row);
    const bool has_place = entry.layout < layouts_.size() && entry.rows > 0 && entry.first_row >= 0;
    if (!has_place || entry.index != static_cast<std::int64_t>(row))
      throw Error(file.name(), fmt::format("row {}", row), "is damaged: the episode has no place in the data set");
    episodes_.push_back(std::move(entry));
  }
}

Episode DataSet::read_episode(std::size_t index) const {
  const EpisodeEntry& entry = episodes_.at(index);
  const ParquetFile file(folder_ / entry.file);
  const bool has_rows = entry.row_group < file.row_groups() && entry.first_row <= file.rows(entry.row_group) &&
                        entry.rows <= file.rows(entry.row_group) - entry.first_row;
  if (!has_rows) throw Error(file.name(), fmt::format("has not the rows of episode {}", entry.index));
  Episode episode{entry.rows, {}, entry.summary};
  for (std::size_t i = 0; i < file.columns().size(); ++i) {
    const ParquetColumn& column = file.columns()[i];
    if (std::ranges::find(kIndexColumns, column.name) != kIndexColumns.end()) continue;
    episode.columns.push_back(part_of_rows(column, file.cells(entry.row_group, i),
                                           static_cast<std::size_t>(entry.first_row),
                                           static_cast<std::size_t>(entry.rows)));
  }
  return episode;
}

}  // namespace taxel
