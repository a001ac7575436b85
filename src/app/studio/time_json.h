// The past of the simulation in the state that scripts look at, as JSON.
#pragma once

#include <string>

#include "ui/ui_state.h"

namespace taxel::studio {

std::string steps_json(const ui::UiInput& input);
std::string timeline_json(const ui::UiState& ui);

}  // namespace taxel::studio
