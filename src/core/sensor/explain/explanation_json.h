// An explanation as JSON, for `taxel explain --json` and the window's state dump.
#pragma once

#include <string>

#include "core/sensor/explain/explanation.h"

namespace taxel {

/// Returns one object in SI units. docs/user_guide.md lists the keys.
std::string explanation_to_json(const Explanation& explanation);

}  // namespace taxel
