// A recording of a real sensor beside the run.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

void draw_real_dialog(UiState& ui, const UiInput& input);  ///< what the columns of a table mean
void draw_real_panel(UiState& ui, const UiInput& input);   ///< shift and gains of the one that is shown

/// Its curves in the plot that is being drawn, dashed in the taxels' colours. A taxel with a gain is shown as the
/// reading that it stands for, another one so that the largest values are as high as the largest reading. `scale`: from
/// SI to the plot's axis; `largest`: reading of the run; `first`: of the selected sensor in a row of the trace.
void draw_real_curves(UiState& ui, const UiInput& input, double scale, double largest, std::size_t first);

}  // namespace taxel::ui
