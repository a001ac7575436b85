// The legend of the plot, whose entries isolate curves.
#pragma once

#include <imgui.h>

#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/plot/plot_state.h"

namespace taxel::ui {

/// Returns the width that the legend takes [pixels].
[[nodiscard]] float plot_legend_width(const std::vector<ChosenCurve>& curves);

/// Draws the legend into an area of `size` at the cursor. A click selects the taxel of an entry, and isolates its curve
/// until the entry is clicked again; Shift adds to both. Returns the entry under the pointer, if any.
std::optional<TaxelKey> draw_plot_legend(WindowUi& ui, Selection& selection, const std::vector<ChosenCurve>& curves,
                                         std::vector<TaxelKey>& isolated, ImVec2 size);

}  // namespace taxel::ui
