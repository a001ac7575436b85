#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/history/history.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {
namespace {

/// Draws a step: its name, dim if the step is undone, and "saved" at the right if the file holds it. Returns whether
/// the user clicked the step.
bool draw_step(WindowUi& ui, const Editing& editing, std::size_t index) {
  const HistoryStep& step = (*editing.steps)[index];
  const Palette& colors = palette(ui.dark);
  const bool present = index == editing.undo_depth, undone = index > editing.undo_depth;
  const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  const std::string name = step.name.empty() ? "Document as opened" : step.name;
  if (undone) ImGui::PushStyleColor(ImGuiCol_Text, colors.dim);
  const bool clicked = selectable(ui, fmt::format("{}##{}", name, step.revision).c_str(), present);
  if (undone) ImGui::PopStyleColor();
  ui.widgets.note_item(fmt::format("Step {}", index));
  if (ImGui::IsItemHovered() && !present) {
    const std::size_t steps = undone ? index - editing.undo_depth : editing.undo_depth - index;
    tooltip(fmt::format("Click to {} {} step{}", undone ? "redo" : "undo", steps, steps == 1 ? "" : "s"));
  }
  if (step.revision == editing.saved_revision) {
    ImGui::SameLine(right - ImGui::CalcTextSize("saved").x);
    ImGui::TextDisabled("saved");
  }
  return clicked;
}

/// Scrolls so that the present step is visible, if it is another one than in the last frame.
void show_present(std::size_t present) {
  int& shown = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("present"), -1);
  if (shown == static_cast<int>(present)) return;
  shown = static_cast<int>(present);
  const float row = ImGui::GetTextLineHeightWithSpacing(), top = row * static_cast<float>(present);
  const float height = ImGui::GetWindowHeight(), scroll = ImGui::GetScrollY();
  if (top < scroll || top + 2 * row > scroll + height) ImGui::SetScrollY(std::max(0.0f, top - 0.5f * height));
}

void draw_steps(WindowUi& ui, const Editing& editing) {
  if (!editing.steps) {
    ImGui::TextWrapped("Nothing that can be edited is open.");
    return;
  }
  if (!editing.steps->front().name.empty()) caption("Older steps are not kept.");
  if (ImGui::BeginChild("steps")) {
    show_present(editing.undo_depth);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(editing.steps->size()));
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
        if (const auto index = static_cast<std::size_t>(i); draw_step(ui, editing, index))
          ui.post(GoToEdit{(*editing.steps)[index].revision});
  }
  ImGui::EndChild();
}

void draw_history_panel(WindowUi& ui, const Editing& editing, bool& open) {
  if (begin_panel(ui, kHistory.title, &open)) draw_steps(ui, editing);
  ImGui::End();
}

}  // namespace

constinit const Feature kHistory{
    .title = "Undo history",
    .dock = Dock::inspector,
    .opens = Opens::by_user,
    .key = "panel_history",
    .draw =
        [](App& app) { draw_history_panel(*app.ui, app.shown->document.editing, app.get<PanelsShown>()[kHistory]); },

};

}  // namespace taxel::ui
