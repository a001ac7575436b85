// Which build this is: its version, the commit it was built from, the MuJoCo it runs with. For every program alike.
#pragma once

#include <string>

namespace taxel {

struct Versions {
  std::string taxel;  ///< "0.1.0"
  std::string
      commit;  ///< abbreviated hash, "-dirty" behind it where tracked files were changed; "unknown" outside of git
  std::string mujoco;  ///< of the library that is loaded
};
Versions versions();

/// One line: "taxel 0.1.0, commit 8d066bf12345, MuJoCo 4.0.1".
std::string version_line(const std::string& program);

}  // namespace taxel
