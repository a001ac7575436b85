// The pressure bars: the bars as they were drawn in the last frame, the switches of their error bars, and the switch
// "Within 1 %", which adds samples to taxels until the error bars of a run are small.
#pragma once

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "core/document/edit.h"
#include "ui/widgets/text_fit.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// The image of one bar as numbers.
struct BarShown {
  int sensor = 0;  ///< index of the sensor in the simulation
  int taxel_id = 0;
  double value = 0;        ///< reading, in SI units
  double error = 0;        ///< error bar of the reading, in SI units; 0 if none is drawn
  Rect whisker;            ///< box between the caps of the error bar; empty if none is drawn
  float whisker_line = 0;  ///< thickness of the error bar's lines [pixels]
  double height = 0;       ///< [pixels]
  Rect rect;               ///< the filled part
  float y_mark = 0;        ///< uppermost pixel of the bar, its peak and its error bar
  double top = 0;          ///< reading at the top of the axis, in SI units
  double axis_height = 0;  ///< height of the whole axis [pixels]
  glm::vec3 color{0};      ///< colour of the filled part, sRGB
  bool outlined = false;   ///< whether an outline sets the bar off from the background
  bool over = false;       ///< whether the value is above a fixed range
};

/// A taxel that was drawn as a cell of the heat map.
struct CellShown {
  int sensor = 0;  ///< index of the sensor in the simulation
  int taxel_id = 0;
  double value = 0;    ///< reading, in SI units
  glm::vec3 color{0};  ///< colour of the reading, sRGB
  Rect rect;           ///< [pixels]
};

/// The bars or the cells as they were drawn in the last frame, with their texts; empty if the panel is closed.
struct BarsShown {
  std::vector<BarShown> bars;
  std::vector<CellShown> cells;  ///< cells that are within the panel
  std::vector<TextShown> texts;
};

/// The form of the readings in the panel.
enum class BarsForm { automatic, bars, cells };

/// The user's choices in the panel.
struct BarsState {
  BarsForm form = BarsForm::automatic;
};

/// The switches of the error bars.
struct ErrorBarsState {
  bool on = false;      ///< whether error bars are measured and drawn
  bool within = false;  ///< whether samples are added until the bars are within 1 %; needs `on`
  std::string text;     ///< result or next edit of the switch `within`; empty while it is off
};

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

/// The panel that draws the readings of the displayed step as bars.
extern const Feature kBars;
/// Sets "bars", "cells" and "bar_texts": the drawn bars or cells, and their texts with their boxes.
void dump_bars(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui

namespace taxel::studio {

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_error_bars_job(JobExecutor& executor);

}  // namespace taxel::studio
