// Settings that the window keeps from one start to the next.
#include <fmt/format.h>

#include "app/studio/app/dump/settings.h"
#include "app/studio/features/messages/messages.h"
#include "app/studio/shell/studio.h"
#include "core/base/files.h"

namespace taxel::studio {

std::filesystem::path Studio::kept_file(const char* name) const {
  return (options_.state_dir.empty() ? settings_folder() : std::filesystem::path(options_.state_dir)) / name;
}

void Studio::load_settings() {
  const auto put_aside = [&](const std::filesystem::path& file, const std::string& problem) {
    const std::filesystem::path aside = file.string() + ".broken";
    std::error_code failed;
    std::filesystem::rename(file, aside, failed);
    ui::add_message(app_.window.messages, Severity::warning,
                    fmt::format("{}: what could not be read is as in a new installation{}", problem,
                                failed ? "" : fmt::format("; the file is kept as {}", aside.filename().string())),
                    ImGui::GetTime());
  };
  const ReadSettings settings = read_settings(kept_file("settings.json"));
  apply_saved(settings.saved, app_);
  if (!settings.problem.empty()) put_aside(kept_file("settings.json"), settings.problem);
  std::error_code ignored;
  const auto windows = kept_file("window.ini");
  if (!std::filesystem::exists(windows, ignored)) return;
  try {
    const std::string text = read_file(windows);
    ImGui::LoadIniSettingsFromMemory(text.data(), text.size());
  } catch (const Error& error) {
    put_aside(windows, error.what());
  }
}

void Studio::save_settings() {
  try {
    write_settings(kept_file("settings.json"), saved_state(app_));
    std::size_t size = 0;
    const char* text = ImGui::SaveIniSettingsToMemory(&size);
    write_file_atomically(kept_file("window.ini"), std::string_view(text, size));
  } catch (const Error& error) {
    std::fprintf(stderr, "taxelstudio: settings are not kept: %s\n", error.what());
  }
}

}  // namespace taxel::studio
