// The probe and its reading, the measure and the clip plane, as the state of the window tells them.
#pragma once

#include <string>

#include "app/studio/app/ui_state.h"

namespace taxel::studio {

/// {"probe": ..., "measure": ..., "clip": ...}; null: there is none.
std::string tools_to_json(const ui::UiState& ui, const ui::UiInput& input);

}  // namespace taxel::studio
