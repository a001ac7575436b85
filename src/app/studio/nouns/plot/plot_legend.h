// The legend of the plot, whose entries isolate curves.
#pragma once

#include <imgui.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/plot/plot_state.h"

namespace taxel::ui {

/// Returns the width that the legend takes [pixels].
[[nodiscard]] float plot_legend_width(const std::vector<ChosenCurve>& curves);

/// The entries of the legend under the pointer.
struct LegendPointer {
  std::optional<TaxelKey> hovered;
  std::optional<TaxelKey> clicked;  ///< clicked curve that was not isolated before
};

/// Returns the tooltip of a curve's entry.
[[nodiscard]] std::string legend_tip(const ChosenCurve& curve);

/// Draws the legend into an area of `size` at the cursor. A click isolates the curve of an entry until the entry is
/// clicked again; Shift adds. `tip` returns the tooltip of an entry.
LegendPointer draw_plot_legend(WindowUi& ui, const std::vector<ChosenCurve>& curves, std::vector<TaxelKey>& isolated,
                               ImVec2 size, const std::function<std::string(const ChosenCurve&)>& tip);

}  // namespace taxel::ui
