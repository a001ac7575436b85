// The window's settings. A broken file is treated as a missing file.
#include "app/studio/app/dump/settings.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  const std::string written = studio::settings_text(studio::parse_settings(input).saved);
  require(studio::settings_text(studio::parse_settings(written).saved) == written,
          "settings can be written and read again");
}

const Registered kTarget("settings", run);

}  // namespace
}  // namespace taxel::fuzz
