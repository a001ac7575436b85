// The plot and the heat map in the dump of the window's state.
#pragma once

#include <string>

#include "app/studio/app/app.h"

namespace taxel::studio {

/// Returns the drawn curves of the plot and the values at the pointer, as JSON.
[[nodiscard]] std::string plot_to_json(const ui::App& app);

/// Returns the rows and the place of the heat map, and the cell under the pointer, as JSON.
[[nodiscard]] std::string heat_to_json(const ui::App& app);

}  // namespace taxel::studio
