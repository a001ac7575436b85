// An explanation as text, for `taxel explain`.
#pragma once

#include <string>

#include "core/sensor/explain/explanation.h"

namespace taxel::cli {

/// Returns the diagnosis, followed by tables in SI units. The tables of samples and polygons list only those that
/// contribute to the reading, the largest share first.
std::string explain_text(const Explanation& explanation);

}  // namespace taxel::cli
