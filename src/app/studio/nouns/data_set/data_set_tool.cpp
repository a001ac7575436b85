// The list of episodes, the comparison of a replay with its episode, and the commands that open both.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>
#include <variant>

#include "app/studio/frame/feature.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/data_set/data_set_state.h"
#include "app/studio/nouns/files/files_state.h"
#include "ui/widgets/format.h"

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

namespace {

/// Returns whether the run is that of the opened episode: the document was not edited since.
bool is_run_of_episode(const Shown& shown, const DataSetState& state) {
  const Editing& editing = shown.document.editing;
  return shown.run.simulates_document && shown.run.runs_scenario && editing.undo_depth == 0 &&
         shown.run.scenario == state.replayed->scenario;
}

std::string largest_text(const Shown& shown, const DataSetState& state) {
  const ReplayCheck& check = state.check;
  if (!shown.document.model || check.largest == 0) return "";
  const Layout& layout = shown.document.model->layout;
  const int id = check.largest_taxel < layout.taxels.size() ? layout.taxels[check.largest_taxel].id : -1;
  const ReadingUnit unit = shown_unit(layout.readout.aggregate);
  return fmt::format("; the largest difference of a reading is {:.3g} {} (taxel {} at {:.6g} s)",
                     unit.scale * check.largest, unit.text, id, check.largest_time);
}

std::string difference_text(const Shown& shown, const DataSetState& state) {
  const ReplayCheck& check = state.check;
  const auto rows = static_cast<std::size_t>(state.replayed->rows.rows);
  std::string text = fmt::format("The replay differs from episode {}", state.replayed->from.episode);
  if (!check.problem.empty()) return text + ": " + check.problem + ".";
  if (check.rows != rows) text += fmt::format(": it has {} rows, the episode has {}", check.rows, rows);
  if (check.different_rows > 0) text += fmt::format(" in {} of {} rows", check.different_rows, rows);
  text += largest_text(shown, state);
  if (check.has_other_times) text += "; times or travels differ as well";
  if (check.has_preview) text += "; some rows were read with preview samples: run again";
  return text + ". The data set was written by " + state.replayed->program + "; other versions may give other bits.";
}

}  // namespace

void follow_replay(const Shown& shown, DataSetState& state) {
  if (!state.replayed) {
    state.check = {};
    return;
  }
  const SimFramePtr& frame = shown.run.frame;
  if (!frame || !frame->trace || !is_run_of_episode(shown, state)) return;
  compare_with_episode(*frame->trace, state.replayed->rows, state.replayed->bits, state.check);
}

ReplayVerdict replay_verdict(const Shown& shown, const DataSetState& state) {
  if (!state.replayed) return ReplayVerdict::none;
  if (shown.document.editing.undo_depth > 0) return ReplayVerdict::edited;
  const ReplayCheck& check = state.check;
  if (!is_run_of_episode(shown, state) || check.rows == 0) return ReplayVerdict::none;
  if (check.different_rows > 0 || !check.problem.empty()) return ReplayVerdict::different;
  const auto rows = static_cast<std::size_t>(state.replayed->rows.rows);
  const bool is_over = shown.run.frame && shown.run.frame->finished;
  if (check.rows == rows) return ReplayVerdict::equal;
  return is_over ? ReplayVerdict::different : ReplayVerdict::running;
}

std::string replay_text(const Shown& shown, const DataSetState& state) {
  const auto rows = state.replayed ? static_cast<std::size_t>(state.replayed->rows.rows) : 0;
  switch (replay_verdict(shown, state)) {
    case ReplayVerdict::none:
      return "";
    case ReplayVerdict::edited:
      return fmt::format("Not compared with episode {}: the document was edited. Undo to compare again.",
                         state.replayed->from.episode);
    case ReplayVerdict::running:
      return fmt::format("Replay of episode {}: {} of {} rows, all equal so far.", state.replayed->from.episode,
                         state.check.rows, rows);
    case ReplayVerdict::equal:
      return fmt::format(
          "The replay equals episode {} {}: readings, times and travels of {} rows. Largest difference 0.",
          state.replayed->from.episode,
          state.replayed->bits == 64 ? "bit for bit" : "to float32, as the data set holds it", rows);
    case ReplayVerdict::different:
      return difference_text(shown, state);
  }
  return "";
}

}  // namespace taxel::ui

namespace taxel::studio {

/// Begins to read a data set. The open document stays.
void read_data_set(Host& host, const std::string& folder) {
  ui::DataSetState& state = host.app.get<ui::DataSetState>();
  const std::uint64_t number = state.request ? state.request->number + 1 : 1;
  state.request = ui::DataSetRequest{number, folder};
}

void show_data_set(Host& host, const DataSetRead& read) {
  if (!read.is_good) return;
  host.app.get<ui::PanelsShown>()[ui::kDataSet] = true;
  host.app.get<ui::DataSetState>().wants_focus = true;
  ui::remember_recent(host.app.get<ui::FilesState>().recent, read.folder);
}

void carry_out(const ui::OpenEpisode& episode, Host& host) {
  host.app.get<ui::FilesState>().layout_without_mesh.clear();
  host.document.open(EpisodeChoice{episode.folder, episode.episode});
}

}  // namespace taxel::studio
