// An explanation as JSON: what `taxel explain --json` prints and the window's state dump holds.
#pragma once

#include <string>

#include "core/sensor/explain/explanation.h"

namespace taxel {

/// One object, SI units, keys as docs/user_guide.md lists them.
std::string explanation_to_json(const Explanation& explanation);

}  // namespace taxel
