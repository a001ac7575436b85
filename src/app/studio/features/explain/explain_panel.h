// Why a taxel reads what it reads: verdict, samples, polygons, other numbers of samples, where the force goes.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

void draw_explain_panel(UiState& ui, const UiInput& input);

}  // namespace taxel::ui
