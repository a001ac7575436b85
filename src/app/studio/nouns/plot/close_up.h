// A part of the plot, magnified around one step of a taxel: its readings in every step, its exact readings, and its
// readings before a remedy.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "core/base/page/curve.h"
#include "core/layout/layout.h"
#include "core/run/history/lanes.h"

namespace taxel::studio {
class FeatureJob;
class JobExecutor;
}  // namespace taxel::studio

namespace taxel::ui {

/// The change of a taxel's reading that the plot magnifies.
struct PlotCloseUp {
  TaxelKey key;
  std::uint64_t step = 0;  ///< later one of the two steps of the change
  bool operator==(const PlotCloseUp&) const = default;
};

/// Number of steps before and after a change that a close-up displays.
inline constexpr std::uint64_t kCloseUpSteps = 30;
/// Height of the change in a close-up [pixels at scale 1].
inline constexpr double kChangeHeight = 48;

/// Readings of one taxel in steps of a run.
struct StepCurve {
  std::vector<double> x;         ///< travel [mm] or time [s]
  std::vector<double> readings;  ///< in SI; NaN if unknown
};

/// The exact readings of a taxel in the steps of a close-up.
struct ExactCurve {
  PlotCloseUp of;
  std::shared_ptr<const SimScene> scene;  ///< scene that was read
  bool by_travel = false;
  StepCurve curve;
  std::string problem;  ///< reason why there are no exact readings; empty if there are some
};
using ExactCurvePtr = std::shared_ptr<const ExactCurve>;

/// The readings of a taxel before a remedy.
struct EarlierCurve {
  TaxelKey key;
  bool by_travel = false;
  StepCurve curve;
  Layout after;  ///< edited layout with the remedy, with which the curve is compared
};
using EarlierCurvePtr = std::shared_ptr<const EarlierCurve>;

/// Returns the recorded steps that a close-up displays. Needs a row.
[[nodiscard]] StepRange close_up_steps(const HistoryLanes& lanes, const PlotCloseUp& close_up);

/// Returns the index of a taxel's reading in the rows of a run; empty if there is no such taxel.
[[nodiscard]] std::optional<std::size_t> reading_index(const std::vector<SensorShown>& sensors, const TaxelKey& key);

/// Returns the recorded readings of a taxel in a range of steps.
[[nodiscard]] StepCurve recorded_curve(const HistoryLanes& lanes, std::size_t reading, StepRange steps, bool by_travel);

/// Returns the readings of a taxel in all recorded steps, to be compared with those after a remedy. Null if there are
/// none.
[[nodiscard]] EarlierCurvePtr readings_before(const RunView& run, const TaxelKey& key, const Layout& after);

/// A close-up in the units of the plot.
struct CloseUpView {
  CurveBounds bounds;
  CurvePoints readings, exact, before;  ///< readings of each step; empty if there are none
  double from = 0, to = 0;              ///< the two readings of the change
  double x_from = 0, x_to = 0;
  /// Returns the height of the change in a plot of this height [pixels].
  [[nodiscard]] double change_height(double plot_height) const;
};

/// Returns the view of a close-up in a plot of this height, in pixels at scale 1. It has all its curves, unless the
/// change would be lower than kChangeHeight; then it has the change in its middle. `scale` converts SI units to the
/// vertical axis. Empty if the taxel or the steps are not recorded.
[[nodiscard]] std::optional<CloseUpView> view_close_up(const RunView& run, const std::vector<SensorShown>& sensors,
                                                       const PlotCloseUp& close_up, const ExactCurvePtr& exact,
                                                       const EarlierCurvePtr& before, double scale, double plot_height);

// The next functions draw into the present plot of ImPlot.

/// Draws the exact readings and those before a remedy, which are behind all other curves.
void draw_behind_close_up(const WindowUi& ui, const CloseUpView& view, const ImVec4& color);
/// Draws the readings of each step, with the change, and a key of the curves.
void draw_close_up(const WindowUi& ui, const CloseUpView& view, const ImVec4& color, const std::string& problem);
/// Draws the readings before a remedy over the whole run. `scale` as in view_close_up().
void draw_earlier_curve(const WindowUi& ui, const EarlierCurve& before, const ImVec4& color, double scale);

}  // namespace taxel::ui

namespace taxel::studio {

/// Makes the job that computes the exact readings of a close-up.
[[nodiscard]] std::unique_ptr<FeatureJob> make_close_up_job(JobExecutor& executor);

}  // namespace taxel::studio
