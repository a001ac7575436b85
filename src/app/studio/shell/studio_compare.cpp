// Commands and files of the comparison of a run with a second layout.
#include <fmt/format.h>

#include <filesystem>

#include "app/studio/frame/message_list.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/shell/comparison.h"
#include "app/studio/shell/studio.h"

namespace taxel::studio {

void Studio::carry_out(const ui::CompareLayout& command) {
  if (command.path.empty() && !command.paper) return ask_for_file(ui::FileTask::compare_layout, "");
  ui::compare_with(app_, command.paper ? "" : std::filesystem::absolute(command.path).lexically_normal().string());
  if (app_.viewer->mode != ui::Mode::simulate) carry_out(ui::SetMode{ui::Mode::simulate});
}

/// Reads a second layout again that another program has changed. A deleted one stays as it was read.
void Studio::tell_second_layout(FileChange change) {
  const std::string name = std::filesystem::path(ui::second_layout_file(app_)).filename().string();
  if (change == FileChange::changed) ui::reread_second_layout(app_);
  ui::add_message(app_.get<ui::Messages>(), Severity::warning,
                  change == FileChange::changed
                      ? fmt::format("{} was changed by another program: the comparison reads it again.", name)
                      : fmt::format("{} was deleted or moved. The comparison stays as it was read.", name),
                  ImGui::GetTime());
}

}  // namespace taxel::studio
