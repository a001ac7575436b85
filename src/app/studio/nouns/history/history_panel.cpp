// Edits of the document and their undoing, and the steps of its history as a list.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "core/base/error.h"
#include "core/base/text/message.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

void post_edit(WindowUi& ui, Edit edit) {
  ui.post(EditProject{std::move(edit), {}, ui.fields.last});
}

}  // namespace taxel::ui

namespace taxel::studio {

/// Shows why an edit is refused at the field or the gesture that requested it, or as a message. The document stays
/// then.
void edit_document(Host& host, const std::function<void(EditSession&)>& body, bool in_gesture,
                   const std::optional<ui::FieldInput>& from) {
  if (!host.edits().is_open()) return;
  try {
    body(host.edits());
    host.app.get<ui::ToolState>().problem.clear();
    host.app.ui->fields.refused.reset();
    for (const ui::Holds holds : {ui::Holds::until_edit, ui::Holds::for_run})
      ui::end_messages(host.app.get<ui::Messages>(), holds);
  } catch (const Error& error) {
    if (from) {
      host.app.ui->fields.refused = {*from, shown_message(error), host.app.viewer->selection.taxels};
    } else if (in_gesture) {
      host.app.get<ui::ToolState>().problem = shown_message(error);
    } else {
      ui::add_message(host.app.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime(),
                      ui::Holds::until_edit);
    }
    return;
  }
  after_edit(host);
  host.app.viewer->selection.keep_only(host.edits().project()->layout);
}

void carry_out(const ui::EditProject& command, Host& host) {
  edit_document(
      host, [&](EditSession& edits) { edits.edit(command.edit, command.gesture); }, command.gesture.number != 0,
      command.from);
}

void carry_out(const ui::CancelGesture& command, Host& host) {
  edit_document(host, [&](EditSession& edits) { edits.cancel(command.number); });
}

void carry_out(const ui::EndGesture&, Host& host) {
  host.edits().end_gesture();
}

void carry_out(const ui::UndoStep&, Host& host) {
  edit_document(host, [](EditSession& edits) { edits.undo(); });
}

void carry_out(const ui::RedoStep&, Host& host) {
  edit_document(host, [](EditSession& edits) { edits.redo(); });
}

void carry_out(const ui::GoToEdit& command, Host& host) {
  edit_document(host, [&](EditSession& edits) { edits.go_to(command.revision); });
}

}  // namespace taxel::studio

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
    .guide = "Author a layout",
};

}  // namespace taxel::ui
