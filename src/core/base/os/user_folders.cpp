#include "core/base/os/user_folders.h"

#include <cstdlib>

namespace taxel::os {
namespace {

std::filesystem::path folder_of(const char* variable, const char* below_home) {
  const char* set = std::getenv(variable);
  if (set != nullptr && *set != '\0') return set;
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home != nullptr ? home : ".") / below_home;
}

}  // namespace

std::filesystem::path config_folder() {
  return folder_of("XDG_CONFIG_HOME", ".config");
}

std::filesystem::path state_folder() {
  return folder_of("XDG_STATE_HOME", ".local/state");
}

}  // namespace taxel::os
