#include "app/studio/nouns/files/desktop_task.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/file_task.h"

namespace taxel::ui {

namespace {

using Extensions = std::vector<std::string_view>;

/// Returns "*.stl *.STL" for an extension: the dialogs of desktops compare the case.
std::string patterns_of(const Extensions& extensions) {
  std::string patterns;
  for (const std::string_view extension : extensions) {
    std::string upper(extension);
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    for (const std::string_view name : {extension, std::string_view(upper)})
      patterns += (patterns.empty() ? "*" : " *") + std::string(name);
  }
  return patterns;
}

}  // namespace

std::optional<DesktopTask> desktop_task(FileTask task) {
  const FileTaskRow& row = row_of(task);
  if (row.files == nullptr) return std::nullopt;
  return DesktopTask{row.saves, {row.files, patterns_of(row.extensions())}};
}

os::FileQuestion desktop_question(const FileDialog& dialog) {
  const DesktopTask task = desktop_task(dialog.task).value();
  return {task.saves,
          row_of(dialog.task).title,
          path_in(dialog.folder, task.saves ? dialog.path : ""),
          {task.filter, {"All files", "*"}}};
}

}  // namespace taxel::ui
