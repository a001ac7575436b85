// The window's settings. A broken file is treated as a missing file.
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/shell/state/settings.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

std::string read_and_written(const std::string& text) {
  ui::App app;
  studio::apply_settings(text, app);
  return studio::settings_text(app);
}

void run(const std::string& input) {
  const std::string written = read_and_written(input);
  require(read_and_written(written) == written, "settings can be written and read again");
}

const Registered kTarget("settings", run);

}  // namespace
}  // namespace taxel::fuzz
