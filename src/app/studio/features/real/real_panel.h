// A recording of a real sensor beside the run.
#pragma once

#include "app/studio/app/values/selection.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/plot/plot_state.h"
#include "app/studio/features/real/real_state.h"

namespace taxel::ui {

void draw_real_dialog(WindowUi& ui, const Viewer& viewer, const Shown& shown,
                      RealState& real);  ///< what the columns of a table mean
void draw_real_panel(WindowUi& ui, const Viewer& viewer, const DocumentView& document,
                     RealState& real);  ///< shift and gains of the one that is shown

/// Its curves in the plot that is being drawn, dashed in the taxels' colours. A taxel with a gain is shown as the
/// reading that it stands for, another one so that the largest values are as high as the largest reading. `scale`: from
/// SI to the plot's axis; `largest`: reading of the run; `first`: of the selected sensor in a row of the trace.
void draw_real_curves(WindowUi& ui, const Selection& selection, const RunView& run, RealState& real,
                      const PlotState& plot, double scale, double largest, std::size_t first);

}  // namespace taxel::ui
