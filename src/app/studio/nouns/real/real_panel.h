// The dialog, the panel and the curves of a recording of a real sensor.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/selection.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "app/studio/nouns/real/real_state.h"

namespace taxel::ui {

/// Draws the dialog that assigns a meaning to each column of a table.
void draw_real_dialog(WindowUi& ui, const Viewer& viewer, const Shown& shown, RealState& real);

/// Draws the curves of the recording in the present plot, dashed in the taxels' colours. Values of a taxel with a gain
/// are drawn as the readings that they stand for. Values of other taxels are scaled so that the largest value is as
/// high as the largest reading. `scale` converts SI units to the plot's axis, `largest` is the largest reading of the
/// run, and `first` is the index of the selected sensor's first reading in a row of the trace.
void draw_real_curves(WindowUi& ui, const Selection& selection, const RunView& run, RealState& real,
                      const PlotState& plot, double scale, double largest, std::size_t first);

/// A recording of a real sensor. The panel and its dialog open by its own state.
extern const Feature kReal;
/// Sets "real": the recording, its columns and the gains.
void dump_real(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
