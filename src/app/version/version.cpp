#include "app/version/version.h"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

namespace taxel {

extern const char* const kGitCommit;  // written at build time

Versions versions() {
  return {TAXEL_VERSION, kGitCommit, mj_versionString()};
}

std::string version_line(const std::string& program) {
  const Versions v = versions();
  return fmt::format("{} {}, commit {}, MuJoCo {}", program, v.taxel, v.commit, v.mujoco);
}

}  // namespace taxel
