// Version of the program, the commit that it was built from, and version of MuJoCo.
#pragma once

#include <string>

namespace taxel {

struct Versions {
  std::string taxel;  ///< "0.1.0"
  /// Abbreviated hash, followed by "-dirty" if tracked files were changed; "unknown" outside of a git checkout.
  std::string commit;
  std::string mujoco;  ///< version of the loaded library
};
/// Returns the versions of this build.
Versions versions();

/// Returns one line, such as "taxel 0.1.0, commit 8d066bf12345, MuJoCo 4.0.1".
std::string version_line(const std::string& program);

}  // namespace taxel
