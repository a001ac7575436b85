// The comparison of the run with a second layout, as menus, files and exports use it.
#include "app/studio/nouns/compare/compare_state.h"

#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "core/base/error.h"

namespace taxel::ui {

namespace {

/// Returns the displayed comparison if it has rows, otherwise null.
const ComparedLayouts* compared_rows(const App& app) {
  const ComparedLayouts* compared =
      displayed_comparison(*app.viewer, *app.shown, app.get<CompareState>(), app.get<PanelsShown>()[kCompare]);
  return compared != nullptr && !compared->steps.empty() ? compared : nullptr;
}

}  // namespace

void compare_with(App& app, const std::string& file) {
  begin_comparison(app.get<CompareState>(), file);
  app.ui->open_in_front(app.get<PanelsShown>()[kCompare]);
}

std::string second_layout_file(const App& app) {
  return app.get<CompareState>().request ? app.get<CompareState>().request->file : "";
}

void reread_second_layout(App& app) {
  reread_second(app.get<CompareState>());
}

std::optional<ComparisonTable> comparison_table(const App& app) {
  const ComparedLayouts* compared = compared_rows(app);
  if (compared == nullptr) return std::nullopt;
  return ComparisonTable{comparison_csv(*compared),
                         fmt::format("A is {}, B is {}", side_name(*compared, 0), side_name(*compared, 1))};
}

bool has_comparison_table(const App& app) {
  return compared_rows(app) != nullptr;
}

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::CompareLayout& command, Host& host) {
  if (command.path.empty() && !command.paper) return ask_for_file(host.app, ui::FileTask::compare_layout, "");
  const std::string file = command.paper ? "" : std::filesystem::absolute(command.path).lexically_normal().string();
  carry_out(ui::SetMode{ui::Mode::analyse, false}, host);
  ui::compare_with(host.app, file);
}

/// Reads a second layout again that another program has changed. A deleted one stays as it was read.
void tell_second_layout(Host& host, FileChange change) {
  const std::string name = std::filesystem::path(ui::second_layout_file(host.app)).filename().string();
  if (change == FileChange::changed) ui::reread_second_layout(host.app);
  ui::add_message(host.app.get<ui::Messages>(), Severity::warning,
                  change == FileChange::changed
                      ? fmt::format("{} was changed by another program: the comparison reads it again.", name)
                      : fmt::format("{} was deleted or moved. The comparison stays as it was read.", name),
                  ImGui::GetTime());
}

}  // namespace taxel::studio
