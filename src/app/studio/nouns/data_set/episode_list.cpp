#include "app/studio/nouns/data_set/episode_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>
#include <variant>

namespace taxel::ui {

namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The value by which a row is sorted: nothing, a number or a text. Rows without a value are the largest.
using SortValue = std::variant<double, std::string, std::monostate>;

SortValue parameter_value(const EpisodeRow& row, std::size_t parameter) {
  if (parameter >= row.values.size() || row.values[parameter].text.empty()) return std::monostate{};
  const ParameterValue& value = row.values[parameter];
  return value.number ? SortValue(*value.number) : SortValue(value.text);
}

SortValue sort_value(const OpenDataSet& set, const EpisodeRow& row, const EpisodeOrder& order) {
  if (order.column == EpisodeColumnId::parameter) return parameter_value(row, order.parameter);
  if (!row.episode) return std::monostate{};
  switch (order.column) {
    case EpisodeColumnId::layout:
      return set.layouts[*row.layout].name;
    case EpisodeColumnId::scenario:
      return row.scenario;
    case EpisodeColumnId::seed:
      return static_cast<double>(row.seed);
    case EpisodeColumnId::peak:
      return row.peak;
    case EpisodeColumnId::force:
      return row.force;
    case EpisodeColumnId::rows:
      return static_cast<double>(row.rows);
    case EpisodeColumnId::duration:
      return row.duration;
    default:
      return static_cast<double>(*row.episode);
  }
}

std::vector<std::size_t> ordered_rows(const OpenDataSet& set, const EpisodeOrder& order) {
  std::vector<std::pair<SortValue, std::size_t>> keyed;
  for (std::size_t i = 0; i < set.rows.size(); ++i)
    if (passes_filter(set, set.rows[i], order.filter)) keyed.emplace_back(sort_value(set, set.rows[i], order), i);
  std::stable_sort(keyed.begin(), keyed.end(), [&](const auto& a, const auto& b) {
    const bool has_none =
        std::holds_alternative<std::monostate>(a.first) != std::holds_alternative<std::monostate>(b.first);
    return order.descending && !has_none ? b.first < a.first : a.first < b.first;
  });
  std::vector<std::size_t> rows;
  for (const auto& [value, row] : keyed) rows.push_back(row);
  return rows;
}

}  // namespace

bool passes_filter(const OpenDataSet& set, const EpisodeRow& row, const std::string& filter) {
  if (filter.empty()) return true;
  std::string all =
      row.episode ? fmt::format("{}\n{}\n{}\n{}", *row.episode, set.layouts[*row.layout].name, row.scenario, row.seed)
                  : fmt::format("failed\n{}", row.error);
  for (const ParameterValue& value : row.values) all += "\n" + value.text;
  all = lower_case(std::move(all));
  std::istringstream words(lower_case(filter));
  for (std::string word; words >> word;)
    if (all.find(word) == std::string::npos) return false;
  return true;
}

void show_data_set(DataSetState& state, const OpenDataSetPtr& set, const EpisodeCurvesPtr& curves) {
  state.curves = curves;
  if (!set || set == state.set || !set->problem.empty()) return;
  state.set = set;
  state.order = {};
  state.chosen.reset();
  if (!set->rows.empty()) state.chosen = 0;
}

std::optional<EpisodeRequest> episode_request(const DataSetState& state) {
  if (!state.set || !state.chosen) return std::nullopt;
  const std::optional<std::int64_t> episode = state.set->rows[*state.chosen].episode;
  if (!episode) return std::nullopt;
  return EpisodeRequest{state.set->source, {state.set->folder, *episode}};
}

void update_episode_list(DataSetState& state) {
  if (state.list.set == state.set && state.list.order == state.order) return;
  state.list = {state.set, state.order, {}};
  if (state.set) state.list.rows = ordered_rows(*state.set, state.order);
}

}  // namespace taxel::ui
