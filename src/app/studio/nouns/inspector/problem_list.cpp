#include "app/studio/nouns/inspector/problem_list.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <numeric>

#include "app/studio/nouns/history/edit_commands.h"
#include "core/base/text/shown_message.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

/// Largest number of listed problems. The taxel table shows further problems next to their taxels.
constexpr std::size_t kMostShown = 12;

/// Draws a button whose text wraps to the next line if the text is too long.
bool wrapped_button(WindowUi& ui, const std::string& words, std::size_t number) {
  const float room = ImGui::GetContentRegionAvail().x, pad = ImGui::GetStyle().FramePadding.x;
  const ImVec2 text = ImGui::CalcTextSize(words.c_str(), nullptr, false, room - 2 * pad);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = text.y + 2 * ImGui::GetStyle().FramePadding.y;
  const bool pressed = ImGui::Button(fmt::format("##fix{}", number).c_str(), ImVec2(-1, height));
  ui.widgets.note_item(words);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {corner.x + pad, corner.y + ImGui::GetStyle().FramePadding.y},
               ImGui::GetColorU32(ImGuiCol_Text), words.c_str(), nullptr, room - 2 * pad);
  return pressed;
}

void draw_problem(WindowUi& ui, const DocumentView& document, const LayoutProblems& problems, std::size_t number) {
  const Problem& problem = problems.list[number];
  ImGui::PushStyleColor(ImGuiCol_Text, severity_color(palette(ui.dark), problem.severity));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(taxel::shown_part(problem.message).c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  tooltip(problem.fix.empty() ? problem.pointer : fmt::format("{}: {}", problem.pointer, problem.fix));
  const auto fix =
      fix_for(problem, *document.editing.project, problems.model->skin.get(), document.editing.mesh_sha256);
  if (fix && wrapped_button(ui, fix->words, number)) ui.post(EditProject{fix->edit, {}});
  ImGui::Spacing();
}

void fix_all(WindowUi& ui, const DocumentView& document, const LayoutProblems& problems, Messages& messages) {
  const Mending mending = mend_all(*document.editing.project, layout_mesh(*problems.model));
  if (mending.edit) ui.post(EditProject{*mending.edit, {}});
  std::string text = fmt::format("{} problem{} fixed", mending.mended, mending.mended == 1 ? "" : "s");
  if (!mending.left.empty()) text += fmt::format(", {} left for you to decide", mending.left.size());
  add_message(messages, Severity::note, text, ImGui::GetTime());
}

}  // namespace

std::vector<std::size_t> displayed_problems(const Selection& selection, const LayoutProblems& problems) {
  std::vector<std::size_t> displayed;
  if (selection.empty()) {
    displayed.resize(problems.list.size());
    std::iota(displayed.begin(), displayed.end(), 0U);
    return displayed;
  }
  for (const int id : selection.taxels) {
    const std::vector<std::size_t> own = problems.of(id);
    displayed.insert(displayed.end(), own.begin(), own.end());
  }
  return displayed;
}

void draw_problem_list(WindowUi& ui, const Selection& selection, const DocumentView& document,
                       const LayoutProblems& problems, Messages& messages) {
  if (!document.editing.project || problems.project != document.editing.project || problems.list.empty()) return;
  if (!header(ui, fmt::format("Problems ({})##problems", problems.list.size()).c_str())) return;
  const std::vector<std::size_t> shown = displayed_problems(selection, problems);
  for (std::size_t i = 0; i < std::min(shown.size(), kMostShown); ++i) draw_problem(ui, document, problems, shown[i]);
  if (shown.size() > kMostShown) ImGui::TextDisabled("and %d more", static_cast<int>(shown.size() - kMostShown));
  if (shown.empty()) ImGui::TextDisabled("No problems of the selected taxels.");
  if (button(ui, "Fix all", ImVec2(-1, 0))) fix_all(ui, document, problems, messages);
  tooltip("Every repair that needs no decision, over the whole layout, as one step");
}

}  // namespace taxel::ui
