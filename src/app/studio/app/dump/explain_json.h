// State dump of the displayed explanation.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// Returns the explanation as `taxel explain --json` prints it, with step, selected polygon and ghost; "null" if none
/// is displayed.
std::string explain_to_json(const ui::App& app);

}  // namespace taxel::studio
