// The runs of a parameter study as small multiples, all in the same axes.
#pragma once

#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "core/document/scenario/study_curves.h"

namespace taxel::ui {

/// Draws the runs. A click on a run applies its values to the document and runs the scenario.
void draw_study_plots(WindowUi& ui, const DocumentView& document, const Project& project, const StudyCurves& curves);

}  // namespace taxel::ui
