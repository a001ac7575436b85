// The result of `taxel explain`.
#pragma once

#include <string>

#include "core/sensor/explain/explanation.h"

namespace taxel::cli {

/// The verdict first, then tables; of samples and polygons those that made the reading, the largest share first.
std::string explain_text(const Explanation& explanation);

}  // namespace taxel::cli
