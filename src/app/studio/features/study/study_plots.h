// The runs of a parameter study as small multiples, all in the same axes.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/window_ui.h"

namespace taxel::ui {

/// A click on a run makes its values the document's, and runs it.
void draw_study_plots(WindowUi& ui, const DocumentView& document, const Project& project, const StudyCurves& curves);

}  // namespace taxel::ui
