// The dump of the marks of the view, of the bars and of both ranges.
#pragma once

#include <string>

#include "app/studio/app/app.h"

namespace taxel::studio {

/// Returns the ranges of surface and readings, the drawn bars and the numbers of drawn marks as a JSON object.
std::string marks_to_json(const ui::App& app);

}  // namespace taxel::studio
