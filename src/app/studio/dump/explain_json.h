// What the window explains, for its state dump.
#pragma once

#include <string>

#include "app/studio/app/ui_state.h"

namespace taxel::studio {

/// The explanation as `taxel explain --json` has it, with step, selected polygon and ghost; "null" where none is shown.
std::string explain_to_json(const ui::UiState& ui, const ui::UiInput& input);

}  // namespace taxel::studio
