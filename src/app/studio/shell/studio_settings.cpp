// Settings that the window keeps from one start to the next.
#include <fmt/format.h>

#include <array>

#include "app/studio/frame/arrangement.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/nouns/messages/messages.h"
#include "app/studio/shell/interface/dock_layout.h"
#include "app/studio/shell/state/settings.h"
#include "app/studio/shell/studio.h"
#include "core/base/files.h"
#include "core/base/text/shown_message.h"

namespace taxel::studio {

namespace {

/// Files of the arrangements of LAYOUT and SIMULATE. Earlier versions had one for both, window.ini, which is left
/// alone.
constexpr std::array kArrangements = {"arrangement-layout.ini", "arrangement-simulate.ini"};

/// Returns the path of a file in the settings folder.
std::filesystem::path kept_file(const Options& options, const char* name) {
  return (options.state_dir.empty() ? settings_folder() : std::filesystem::path(options.state_dir)) / name;
}

}  // namespace

void Studio::load_settings() {
  const auto put_aside = [&](const std::filesystem::path& file, const std::string& why) {
    const std::filesystem::path aside = file.string() + ".broken";
    std::error_code failed;
    std::filesystem::rename(file, aside, failed);
    ui::add_message(app_.get<ui::Messages>(), Severity::warning,
                    fmt::format("{}: what could not be read is as in a new installation{}", why,
                                failed ? "" : fmt::format("; the file is kept as {}", aside.filename().string())),
                    ImGui::GetTime());
  };
  const std::string problem = read_settings(kept_file(options_, "settings.json"), app_);
  if (!options_.has_size) window_->set_place(app_.get<ui::WindowState>().place);
  if (!problem.empty()) put_aside(kept_file(options_, "settings.json"), problem);
  std::error_code ignored;
  for (std::size_t mode = 0; mode < kArrangements.size(); ++mode) {
    const std::filesystem::path file = kept_file(options_, kArrangements[mode]);
    if (!std::filesystem::exists(file, ignored)) continue;
    try {
      app_.get<ui::Arrangement>().kept[mode] = read_file(file);
    } catch (const Error& error) {
      put_aside(file, shown_message(error));
    }
  }
}

void Studio::save_settings() {
  try {
    if (const auto place = window_->place()) app_.get<ui::WindowState>().place = *place;
    write_settings(kept_file(options_, "settings.json"), app_);
    const std::array<std::string, 2> texts = ui::arrangement_texts(app_);
    for (std::size_t mode = 0; mode < kArrangements.size(); ++mode)
      if (!texts[mode].empty()) write_file_atomically(kept_file(options_, kArrangements[mode]), texts[mode]);
  } catch (const Error& error) {
    std::fprintf(stderr, "taxelstudio: settings are not kept: %s\n", shown_message(error).c_str());
  }
}

}  // namespace taxel::studio
