// The switch "Within 1 %": adds samples to taxels until the error bars of a run are small.
#pragma once

#include <optional>
#include <string>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/bars/error_bars_state.h"
#include "core/document/edit.h"

namespace taxel::ui {

/// Largest error bar that the switch leaves, as a fraction of the largest reading of the sensor since the start.
inline constexpr double kWithin = 0.01;

/// Largest number of samples that the switch makes.
inline constexpr double kMostSamples = 200'000;

/// The largest error bar of the displayed step.
struct LargestError {
  double part = 0;  ///< fraction of the largest reading of its sensor; 0 without readings
  int taxel = -1;   ///< id of the taxel, or -1
};
[[nodiscard]] LargestError largest_error(const RunView& run);

/// The next step of the switch.
struct WithinStep {
  std::optional<Edit> edit;  ///< edit to make now, or none
  std::string text;          ///< the state in words
};

/// Returns the next step. Bars of samples fall at least with the square root of their number, so an edit multiplies the
/// density of each taxel with a larger bar than kWithin by (bar / kWithin)^2, but at most by 16, up to about
/// kMostSamples samples in all: those that an edit adds around the fields are not counted before. Other taxels keep
/// their density. Where that is not enough, readings become exact. There is no edit while an earlier one is compiled or
/// measured, or its samples are a preview.
[[nodiscard]] WithinStep next_within(const Shown& shown);

/// Makes the next step if the switch is on.
void keep_within(WindowUi& ui, const Shown& shown, ErrorBarsState& errors);

}  // namespace taxel::ui
