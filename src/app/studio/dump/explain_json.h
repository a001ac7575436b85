// What the window explains, for its state dump.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// The explanation as `taxel explain --json` has it, with step, selected polygon and ghost; "null" where none is shown.
std::string explain_to_json(const ui::App& app);

}  // namespace taxel::studio
