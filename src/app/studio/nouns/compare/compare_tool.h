// Decisions of the comparison of two layouts: requests, results that may be shown, and the chosen curves.
#pragma once

#include <optional>
#include <string>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/compare/compare_state.h"

namespace taxel::ui {

/// Begins a comparison with a layout file, or with the paper's released model if `file` is empty. Of a file the contact
/// of the run is read; the released model has a pressure field of its own.
void begin_comparison(CompareState& state, const std::string& file);
void end_comparison(CompareState& state);
/// Requests the file of the second layout to be read again.
void reread_second(CompareState& state);

/// Returns the request for the worker; empty if nothing is to be read: the panel is closed, no sensor is simulated, or
/// no second layout is chosen.
[[nodiscard]] std::optional<CompareRequest> compare_request(const Viewer& viewer, const Shown& shown,
                                                            const CompareState& state, bool open);

/// Returns the newest result if it belongs to the request, to the selected sensor and to the displayed layout;
/// otherwise null, so that nothing outdated is shown.
[[nodiscard]] const ComparedLayouts* displayed_comparison(const Viewer& viewer, const Shown& shown,
                                                          const CompareState& state, bool open);

/// Fills the sides with the rows of a result. If rows were only added, only these are read.
void take_rows(CompareState& state, const ComparedLayouts& compared, bool by_travel);

/// Returns the letter of a side: "A" for the layout of the run, "B" for the second layout.
[[nodiscard]] const char* side_letter(std::size_t side);
/// Returns the name of a layout for texts. `geom` is the name of the sensor, used if the layout has none.
[[nodiscard]] std::string side_name(const ComparedLayouts& compared, std::size_t side);
/// Returns the name of a taxel: "A (fingertip), taxel 3".
[[nodiscard]] std::string side_taxel(const ComparedLayouts& compared, const TaxelKey& key);
/// Returns what both layouts have in common, and what not.
[[nodiscard]] std::string held_equal(const ComparedLayouts& compared);
/// Returns a note about rows of the run without readings of B, or an empty text.
[[nodiscard]] std::string missing_rows(const ComparedLayouts& compared, const Trace& trace, bool by_travel);

/// Returns comparison_to_csv() of a comparison.
[[nodiscard]] std::string comparison_csv(const ComparedLayouts& compared);

/// Returns the curves of one side. Their keys have the side as sensor. With `responding_only` a taxel is left out if
/// its peak is not above kTaxelResponds of the side's largest, unless it is selected.
[[nodiscard]] std::vector<ChosenCurve> choose_side(const ComparedLayouts& compared, std::size_t side,
                                                   const SideSummary& summary, const Selection& selection,
                                                   bool responding_only);

/// Returns the factor from readings of a side in SI to the vertical axis of the plot.
[[nodiscard]] double side_scale(const ComparedLayouts& compared, std::size_t side, const SideSummary& summary,
                                bool relative);
/// Returns whether both sides are plotted as fractions: on request, or because their units differ.
[[nodiscard]] bool is_relative(const ComparedLayouts& compared, const CompareState& state);

/// A place in the plot and the largest vertical distance to a curve there.
struct PlotPoint {
  double x = 0, y = 0, reach = 0;
};
/// Returns the curve that is nearest to a point of the plot, among the drawn curves of both sides; empty if none is
/// within reach.
[[nodiscard]] std::optional<TaxelKey> nearest_curve(const CompareState& state, const ComparedLayouts& compared,
                                                    const PlotPoint& at);

}  // namespace taxel::ui
