// The plot of readings: its options, its curves, and the plot as it was drawn.
#pragma once

#include <optional>
#include <vector>

#include "app/studio/nouns/plot/plot_choice.h"

namespace taxel::ui {

/// The plot as it was drawn in the last frame.
struct PlotShown {
  PlotChoice choice;
  std::vector<TaxelKey> focus;  ///< curves that stand out; empty if all are equal
  std::optional<PlotReadout> readout;
  int errors = 0;  ///< number of drawn error bars
};

/// The part of the plot's state that belongs to the document.
struct PlotOfDocument {
  PlotQuantity quantity = PlotQuantity::reading;  ///< chosen quantity; readings are shown if no sensor has it
  std::vector<TaxelKey> isolated;                 ///< curves that stand out until they are clicked again
  PlotShown shown;                                ///< empty if the panel is closed
};

struct PlotState : PlotOfDocument {
  using PerDocument = PlotOfDocument;
  PlotOptions options;
  PlotCurves curves;
};

}  // namespace taxel::ui
