#include "app/studio/nouns/data_set/episode_table.h"

#include <fmt/format.h>
#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <array>

#include "app/studio/nouns/data_set/data_set_commands.h"
#include "app/studio/nouns/data_set/episode_list.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

constexpr float kWidestLayout = 12, kSeedWidth = 9;  // in heights of text
constexpr std::size_t kMaxParameters = 40;           // of parameters that have a column

struct TableHead {
  EpisodeColumnId column;
  std::string title;
  std::string tip;
  float width;  ///< in heights of text
};

/// Returns whether all layouts have the same displayed unit.
bool has_one_unit(const OpenDataSet& set) {
  return std::all_of(set.layouts.begin(), set.layouts.end(), [&](const DataSetLayout& layout) {
    return same_unit(shown_unit(layout.aggregate), shown_unit(set.layouts.front().aggregate));
  });
}

std::vector<TableHead> heads_of(const OpenDataSet& set) {
  const float line = ImGui::GetFontSize();
  const auto width_of = [&](const std::string& text) {
    constexpr float kArrow = 1.3f;  // of the column by which the table is sorted, in heights of text
    return ImGui::CalcTextSize(text.c_str()).x / line + kArrow;
  };
  float layout = width_of("Layout");
  for (const DataSetLayout& one : set.layouts) layout = std::clamp(width_of(one.name), layout, kWidestLayout);
  std::vector<TableHead> heads{
      {EpisodeColumnId::episode, "Episode", "Number of the episode in the data set", width_of("Episode")},
      {EpisodeColumnId::layout, "Layout", "Name of the layout", layout},
      {EpisodeColumnId::scenario, "Scenario", "Kind of the scenario", width_of("Scenario")}};
  for (std::size_t i = 0; i < std::min(set.parameters.size(), kMaxParameters); ++i) {
    const DataSetParameter& parameter = set.parameters[i];
    heads.push_back({EpisodeColumnId::parameter, parameter.title, parameter.pointer, width_of(parameter.title)});
  }
  const bool has_unit = !set.layouts.empty() && has_one_unit(set);
  const std::string unit = has_unit ? fmt::format(" ({})", shown_unit(set.layouts.front().aggregate).text) : "";
  heads.push_back({EpisodeColumnId::peak, "Peak" + unit, "Largest reading of all taxels", width_of("Peak" + unit)});
  heads.push_back({EpisodeColumnId::force, "Force (N)", "Largest force on the sensor", width_of("Force (N)")});
  heads.push_back({EpisodeColumnId::rows, "Rows", "Number of recorded rows", width_of("Rows")});
  heads.push_back(
      {EpisodeColumnId::duration, "Duration (s)", "Time from the first row to the last", width_of("Duration (s)")});
  heads.push_back({EpisodeColumnId::seed, "Seed", "Seed of the job's random values", kSeedWidth});
  return heads;
}

void draw_heads(WindowUi& ui, EpisodeOrder& order, const std::vector<TableHead>& heads) {
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).dim);
  for (std::size_t i = 0; i < heads.size(); ++i) {
    if (!ImGui::TableSetColumnIndex(static_cast<int>(i))) continue;
    ImGui::TableHeader(heads[i].title.c_str());
    ui.widgets.note_item("Sort by " + heads[i].title);
    tooltip(heads[i].tip);
  }
  ImGui::PopStyleColor();
  const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  const bool is_sorted = specs != nullptr && specs->SpecsCount > 0;
  constexpr std::size_t kBeforeParameters = 3;
  const auto index = is_sorted ? static_cast<std::size_t>(specs->Specs[0].ColumnIndex) : 0;
  order.column = heads[index].column;
  order.parameter = order.column == EpisodeColumnId::parameter ? index - kBeforeParameters : 0;
  order.descending = is_sorted && specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
}

std::string cell_text(const OpenDataSet& set, const EpisodeRow& row, EpisodeColumnId column, bool has_unit) {
  switch (column) {
    case EpisodeColumnId::layout:
      return set.layouts[*row.layout].name;
    case EpisodeColumnId::scenario:
      return row.scenario;
    case EpisodeColumnId::peak: {
      const ReadingUnit unit = shown_unit(set.layouts[*row.layout].aggregate);
      return has_unit ? fmt::format("{:.4g}", unit.scale * row.peak) : in_unit(row.peak, unit);
    }
    case EpisodeColumnId::force:
      return fmt::format("{:.4g}", row.force);
    case EpisodeColumnId::rows:
      return fmt::format("{}", row.rows);
    case EpisodeColumnId::duration:
      return fmt::format("{:.4g}", row.duration);
    case EpisodeColumnId::seed:
      return fmt::format("{}", row.seed);
    default:
      return "";
  }
}

/// Draws a cell's text: numbers at the right end of the cell.
void draw_cell_text(const std::string& text, bool is_number) {
  if (is_number)
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                         std::max(0.0f, ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x));
  ImGui::TextUnformatted(text.c_str());
}

void draw_first_cell(WindowUi& ui, DataSetState& state, std::size_t index) {
  const EpisodeRow& row = state.set->rows[index];
  const std::string text = row.episode ? fmt::format("{}", *row.episode) : "failed";
  const std::string noted = row.episode ? fmt::format("Episode {}", *row.episode) : fmt::format("Failed job {}", index);
  constexpr auto kFlags = ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick;
  if (!row.episode) ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).error);
  if (ImGui::Selectable(fmt::format("{}##{}", text, index).c_str(), state.chosen == index, kFlags)) {
    state.chosen = index;
    if (row.episode && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
      ui.post(OpenEpisode{state.set->folder, *row.episode});
  }
  if (!row.episode) ImGui::PopStyleColor();
  ui.widgets.note_item(noted);
  tooltip(row.error);
}

void draw_row(WindowUi& ui, DataSetState& state, std::size_t index, const std::vector<TableHead>& heads,
              bool has_unit) {
  const EpisodeRow& row = state.set->rows[index];
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  draw_first_cell(ui, state, index);
  for (std::size_t i = 1, parameter = 0; i < heads.size(); ++i) {
    const EpisodeColumnId column = heads[i].column;
    const std::size_t p = column == EpisodeColumnId::parameter ? parameter++ : 0;
    if (!ImGui::TableNextColumn()) continue;
    if (column == EpisodeColumnId::parameter) {
      draw_cell_text(row.values[p].text, row.values[p].number.has_value());
    } else if (row.episode) {
      draw_cell_text(cell_text(*state.set, row, column, has_unit),
                     column != EpisodeColumnId::layout && column != EpisodeColumnId::scenario);
    } else if (column == EpisodeColumnId::layout) {
      ImGui::TextColored(palette(ui.dark).error, "%s", row.error.c_str());
    }
  }
}

}  // namespace

void draw_episode_table(WindowUi& ui, DataSetState& state) {
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##filter", "Filter: number, layout, scenario, value, reason of a failure",
                           &state.order.filter);
  ui.widgets.note_item("Filter episodes", true);
  constexpr auto kFlags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                          ImGuiTableFlags_Sortable | ImGuiTableFlags_Resizable | ImGuiTableFlags_SizingFixedFit |
                          ImGuiTableFlags_NoSavedSettings;
  const std::vector<TableHead> heads = heads_of(*state.set);
  const std::string id = fmt::format("episodes##{}", state.request ? state.request->number : 0);
  if (!ImGui::BeginTable(id.c_str(), static_cast<int>(heads.size()), kFlags)) return;
  ImGui::TableSetupScrollFreeze(1, 1);
  for (const TableHead& head : heads)
    ImGui::TableSetupColumn(head.title.c_str(), ImGuiTableColumnFlags_WidthFixed, head.width * ImGui::GetFontSize());
  draw_heads(ui, state.order, heads);
  update_episode_list(state);
  const bool has_unit = !state.set->layouts.empty() && has_one_unit(*state.set);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(state.list.rows.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_row(ui, state, state.list.rows[static_cast<std::size_t>(i)], heads, has_unit);
  ImGui::EndTable();
}

}  // namespace taxel::ui
