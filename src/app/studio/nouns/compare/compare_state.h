// The comparison of a run with a second layout: the request, the rows with readings of both in the same steps, their
// curves and numbers, the decisions of the panel, and the comparison as menus, files and exports use it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/bars/bars_state.h"
#include "app/studio/nouns/models/models_state.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "core/run/step.h"
#include "core/sensor/compare.h"

namespace taxel::studio {
enum class FileChange;
}

namespace taxel::ui {

/// Returns the readings of one layout in a step, in SI units: `side` is 0 for A, the layout of the run, and 1 for B.
[[nodiscard]] inline const std::vector<double>& side_readings(const ComparedStep& step, std::size_t side) {
  return step.readings[side == 0 ? ReadingModel::reading : ReadingModel::second].values;
}

/// A reading of one taxel in one row.
struct RowReading {
  double value = 0;  ///< in SI units
  int taxel = -1;    ///< index of the taxel, or -1 if all values are 0
  double x = 0;      ///< travel [m] or time [s] of the row
};

/// The numbers of one layout over the compared rows.
struct SideSummary {
  RowReading peak;            ///< largest reading
  RowReading jump;            ///< largest change of a reading between two neighbouring rows, at the later row
  int responding = 0;         ///< number of taxels whose peak is above kTaxelResponds of the largest
  std::vector<double> peaks;  ///< largest reading of each taxel
};

/// The curves and the numbers of one layout.
struct CompareSide {
  Trace trace;
  PlotCurves curves;
  SideSummary summary;
};

/// Adds the readings of row `rows[i]` from the first row that `side` does not have. The side must have been filled from
/// the beginning of `rows`. `which` is 0 for A and 1 for B.
void extend_side(CompareSide& side, std::span<const ComparedStepPtr> rows, std::size_t which, bool by_travel);

/// Returns the mean distance between neighbouring rows: travel [m] or time [s]. 0 with less than two rows.
[[nodiscard]] double row_distance(std::span<const ComparedStepPtr> rows, bool by_travel);

/// A second layout to compare the run with: a file, or the paper's released model.
struct CompareRequest {
  std::uint64_t number = 0;  ///< changes whenever the second layout is to be read again
  std::string file;          ///< layout file; empty for the paper's released model
  SecondContact contact = SecondContact::recorded;

  [[nodiscard]] bool is_paper() const { return file.empty(); }
  bool operator==(const CompareRequest&) const = default;
};

/// The readings of both layouts, as far as the recorded steps were read: `model` is the layout of the run, and `steps`
/// are its rows from the oldest one on.
struct ComparedLayouts : ComparedSteps {
  CompareRequest request;
  SensorModelPtr b;  ///< second layout; null while it is built
  /// Taxels of `b`; null if they are those of `model`.
  std::shared_ptr<const std::vector<Taxel>> taxels_of_b;
  bool reads_recorded = true;  ///< whether both read the same contact surfaces
  bool equal_contact = true;   ///< whether the material of `b` itself gives these surfaces
  ComparedStepPtr displayed;   ///< step that was displayed, or null
  /// Returns the layout of a side: 0 for A, 1 for B.
  [[nodiscard]] const SensorModelPtr& of(std::size_t side) const { return side == 0 ? model : b; }
};
using ComparedLayoutsPtr = std::shared_ptr<const ComparedLayouts>;

/// The state of the work on a comparison.
struct CompareProgress {
  bool busy = false;
  double building = 0;   ///< finished fraction of building the second layout
  std::size_t read = 0;  ///< number of rows of the run that were read, or passed over
  std::size_t due = 0;   ///< number of rows of the run
};

/// The panel as it was drawn in the last frame.
struct CompareShown {
  std::array<std::vector<ChosenCurve>, 2> curves;  ///< curves of A and of B
  std::vector<TaxelKey> focus;                     ///< curves that stand out; empty if all are equal
  std::string hovered;                             ///< name of the curve under the pointer, or empty
  std::string held;                                ///< sentence on what both layouts have in common
  BarsShown bars;
  ComparedStepPtr step;  ///< step of the bars, or null
};

struct CompareState {
  using PerDocument = CompareState;  ///< another document ends the comparison
  std::optional<CompareRequest> request;
  std::uint64_t number = 0;  ///< number of the newest request
  bool stopped = false;      ///< whether no further recorded steps are to be read
  CompareProgress progress;
  ComparedLayoutsPtr compared;  ///< newest result, or null

  // Options of the panel:
  bool relative = false;  ///< plot fractions of each layout's own largest reading
  bool responding_only = true;
  bool rings = true;  ///< draw the receptive fields of B in the view
  std::array<bool, 2> drawn{true, true};
  std::vector<TaxelKey> isolated;   ///< curves that stand out until they are clicked again
  std::optional<TaxelKey> hovered;  ///< curve that was under the pointer in the last frame

  std::array<CompareSide, 2> sides;    ///< rows of `compared`, as curves and numbers
  std::vector<ComparedStepPtr> taken;  ///< rows that `sides` hold
  CompareShown shown;
};

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

/// Returns a table `time,travel,A/taxel_<id>...,B/taxel_<id>...`, see readings_to_csv().
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

/// The panel with numbers, bars and curves of both layouts, on one contact and one timeline.
extern const Feature kCompare;
/// Sets "compare", which is null if nothing is compared.
void dump_compare(const App& app, nlohmann::ordered_json& state);

/// Compares the run with a second layout, or with the paper's released model. An empty path asks for the layout.
struct CompareLayout {
  std::string path = {};
  bool paper = false;
  bool operator==(const CompareLayout&) const = default;
};

/// Begins a comparison with a layout file, or with the paper's released model if `file` is empty, and opens its panel.
void compare_with(App& app, const std::string& file);

/// Returns the file of the second layout, or an empty text.
[[nodiscard]] std::string second_layout_file(const App& app);
/// Requests the file of the second layout to be read again.
void reread_second_layout(App& app);

/// A comparison as a table.
struct ComparisonTable {
  std::string csv;
  std::string names;  ///< names of A and B, as one sentence
};
/// Returns the displayed comparison. Empty if nothing is compared, or no row was read.
[[nodiscard]] std::optional<ComparisonTable> comparison_table(const App& app);
/// Returns whether comparison_table() has a result.
[[nodiscard]] bool has_comparison_table(const App& app);

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::CompareLayout& command, Host& host);

/// Reads a second layout again that another program has changed. A deleted one stays as it was read.
void tell_second_layout(Host& host, FileChange change);

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_compare_job(JobExecutor& executor);

}  // namespace taxel::studio
