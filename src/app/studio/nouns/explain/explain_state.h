// The requested and the computed explanation of a reading, see core/sensor/explain, the remedy for a jump that the
// method caused, and runs that are made at once to display one of their steps: that of the example of the paper's
// artifact, which is explained at its largest step, and the run after a remedy.
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
  bool wants_focus = false;          ///< whether the panel comes to the front in the next frame
  bool was_in_front = false;         ///< whether the panel was in front in ANALYSE in the last frame
  std::uint64_t run_of_message = 0;  ///< SimFrame::runs of the run that the message about the largest step is about
};

/// The step of a run made at once that is displayed at the end.
enum class ShownAfterRun {
  largest_change,  ///< step with the largest change of a reading; the change is explained
  same_step        ///< step that was displayed before the layout was changed
};

/// A run from the start that is made at once, a number of steps per frame.
struct RunAhead {
  using PerDocument = RunAhead;  ///< another document ends it

  enum class Phase { none, waits_for_model, begins, runs };
  Phase phase = Phase::none;
  ShownAfterRun shows = ShownAfterRun::largest_change;
  SensorModelPtr without = nullptr;  ///< the run begins when the simulation reads by another model; null for any model
  std::uint64_t until = 0;           ///< last step to make; the end of the scenario may come before
  std::uint64_t displayed = 0;       ///< step to display, for ShownAfterRun::same_step
  std::uint64_t runs = 0;            ///< SimFrame::runs of the run before
  std::uint64_t requested_at = 0;    ///< newest step when the last steps were requested
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

/// Begins the run of the paper's artifact, with the default limits of a jump and without breakpoints.
void show_largest_change(WindowUi& ui, RunAhead& ahead);

/// Continues a run that is made at once, as soon as the simulation reads by the model with polished samples. Returns
/// true if the run is complete, so that show_result() is due. Gives up if the layout cannot be simulated, if the user
/// plays or displays a recorded step, and if the run fails or stops at a breakpoint.
[[nodiscard]] bool advance_run_ahead(WindowUi& ui, const Shown& shown, RunAhead& ahead);

/// Displays the step of a run that is complete. The taxel with the largest change is selected and explained, and the
/// plot magnifies the change, with a message.
void show_result(App& app);

/// Removes the message about the largest step when another run has begun.
void end_message_of_run(App& app);

/// Returns the line of the view about a run that is made at once: its purpose and its progress. Empty if there is none.
[[nodiscard]] std::string run_ahead_hint(const Shown& shown, const RunAhead& ahead);

/// Displays the largest change of the recorded steps, with its taxel selected and magnified in the plot.
void answer_why_it_jumped(App& app);
/// Does so when the panel comes to the front in ANALYSE while no taxel is selected.
void answer_at_first_sight(App& app);

/// An edit of the layout under which the same two contacts read without the jump.
struct Remedy {
  std::string text;  ///< "16 times as many samples, 4 instead of 0.25 per mm²"
  Edit edit;
};

/// Returns the remedy that the explanation has found to bring the change below its limit: for sampling noise the
/// number of samples that its sentences name; a pad for a star field or inverted tets; a wider limit of the angle for a
/// cut field. Empty if the contact itself caused the jump, if there is none, or if nothing that was tried helps.
[[nodiscard]] std::optional<Remedy> remedy_of(const Explanation& explanation, const Layout& layout);

/// Returns why the document cannot be edited by a remedy: the readings are not of its layout. Empty if it can.
[[nodiscard]] std::string remedy_blocked(const Shown& shown);

/// Posts the edit. When the simulation reads by the edited layout, the same run is made at once, and the step is
/// displayed that is displayed now.
void apply_remedy(WindowUi& ui, const Shown& shown, RunAhead& ahead, const Remedy& remedy);

/// The panel that explains a reading: diagnosis, samples, polygons, other numbers of samples, and where the force goes.
extern const Feature kExplain;
/// Sets "runs_ahead", whether a run is made at once, its line in the view, and "explain": what `taxel explain --json`
/// prints, with step, selected polygon and ghost, or null.
void dump_explanation(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui

namespace taxel::studio {

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_explain_job(JobExecutor& executor);

}  // namespace taxel::studio
