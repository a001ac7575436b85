// The runs of a parameter study as small multiples, all in the same axes.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// A click on a run makes its values the document's, and runs it.
void draw_study_plots(UiState& ui, const UiInput& input, const Project& project, const StudyCurves& curves);

}  // namespace taxel::ui
