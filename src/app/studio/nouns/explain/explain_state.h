// The requested and the computed explanation of a reading, see core/sensor/explain, the remedy for a jump that the
// method caused, and the example of the paper's artifact, which pauses at its first jump and explains it at once.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "core/document/edit.h"
#include "core/sensor/explain/explanation.h"

namespace taxel::ui {

/// A taxel of the simulation in the displayed step.
struct ExplainRequest {
  int sensor = 0;
  int taxel = 0;  ///< id of the taxel
  bool operator==(const ExplainRequest&) const = default;
};

/// The result of a request for one step.
struct ExplainedStep {
  ExplainRequest request;
  std::uint64_t step = 0;
  Explanation explanation;
  std::string problem;  ///< reason why there is no explanation; empty if there is one
};
using ExplainedPtr = std::shared_ptr<const ExplainedStep>;

/// A polygon of a sensor's contact surfaces, with the numbers that hits use.
struct PolygonNumber {
  int surface = 0, polygon = 0;
  bool operator==(const PolygonNumber&) const = default;
};

struct ExplainState {
  ExplainedPtr explained;                ///< explanation of the displayed or an earlier step, or null
  std::optional<PolygonNumber> polygon;  ///< polygon of `step` selected in table, scatter plot and view
  std::uint64_t step = 0;
  bool wants_focus = false;  ///< whether the panel comes to the front in the next frame
  /// After a remedy: the run begins again when the simulation reads by another model than this one. Null otherwise.
  SensorModelPtr rerun_without;
};

/// The example of the paper's artifact.
struct HuntState {
  using PerDocument = HuntState;  ///< another document resets all of it

  bool waits_for_jump = false;  ///< whether the first stop of the run is to be explained
};

/// Opens the Explain panel. If no taxel is selected, selects the taxel that changed most since the previous step.
void explain_reading(Viewer& viewer, const Shown& shown, ExplainState& explain, bool& open);

/// Returns the taxel to explain; empty if the panel is closed, no taxel is selected, or the layout is edited.
[[nodiscard]] std::optional<ExplainRequest> explain_request(const Viewer& viewer, const Shown& shown, bool open);

/// Returns the explanation of the selected taxel in the displayed step; null if there is none, or not yet.
[[nodiscard]] const Explanation* shown_explanation(const Viewer& viewer, const Shown& shown,
                                                   const ExplainState& explain, bool open);

/// Selects a polygon of the displayed step and opens the panel. The selected taxel stays.
void inspect_polygon(const RunView& run, ExplainState& explain, bool& open, PolygonNumber polygon);

struct ExplainReading {};
void carry_out(const ExplainReading& command, App& app);

/// Breaks on jumps at a constant force, and waits for the first one.
void begin_hunt(WindowUi& ui, HuntState& hunt);

/// When the run has stopped at a jump: selects the taxel and opens its explanation.
void follow_hunt(Viewer& viewer, const Shown& shown, HuntState& hunt, ExplainState& explain, bool& panel_is_open);

/// An edit of the layout under which the same two contacts read without the jump.
struct Remedy {
  std::string text;  ///< "16 times as many samples, 4 instead of 0.25 per mm²"
  Edit edit;
};

/// Returns the remedy that the explanation has found to bring the change below its limit: for sampling noise
/// four times the samples that it needs, or that number where more would be too many; a pad for a star field or
/// inverted tets; a wider limit of the angle for a cut field. Empty if the contact itself caused the jump, if there is
/// none, or if nothing that was tried helps.
[[nodiscard]] std::optional<Remedy> remedy_of(const Explanation& explanation, const Layout& layout);

/// Returns why the document cannot be edited by a remedy: the readings are not of its layout. Empty if it can.
[[nodiscard]] std::string remedy_blocked(const Shown& shown);

/// Posts the edit. The run begins again when the simulation reads by the edited layout.
void apply_remedy(WindowUi& ui, const Shown& shown, ExplainState& explain, const Remedy& remedy);

/// Begins the run again after apply_remedy(), as soon as the simulation reads by the edited layout. Gives up if the
/// layout cannot be simulated.
void rerun_after_remedy(WindowUi& ui, const Shown& shown, ExplainState& explain);

/// The panel that explains a reading: diagnosis, samples, polygons, other numbers of samples, and where the force goes.
extern const Feature kExplain;
/// Sets "explain": what `taxel explain --json` prints, with step, selected polygon and ghost, or null.
void dump_explanation(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui

namespace taxel::studio {

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_explain_job(JobExecutor& executor);

}  // namespace taxel::studio
