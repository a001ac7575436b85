#include "app/cli/version.h"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

namespace taxel::cli {

extern const char* const kGitCommit;  // written at build time

Versions versions() {
  return {TAXEL_VERSION, kGitCommit, mj_versionString()};
}

std::string version_line() {
  const Versions v = versions();
  return fmt::format("taxel {}, commit {}, MuJoCo {}", v.taxel, v.commit, v.mujoco);
}

}  // namespace taxel::cli
