// The scenario, which moves the finger: the waypoints of its path in the 3-D view, the recording of a path from the
// motion of the tool, and its section in the inspector.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/perturb/perturb_state.h"
#include "app/studio/nouns/taxel/gesture_edit.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "core/document/scenario/scenario.h"

namespace taxel::ui {

/// The recorded motion of the tool.
struct PathRecording {
  std::vector<WayPoint> points;
  double clock = 0;            ///< recorded time [s]: simulated, or real time while paused
  std::optional<double> time;  ///< simulated time of the previous frame [s], if known
  std::uint64_t runs = 0;      ///< value of SimFrame::runs for the recorded run
  bool over = false;           ///< whether the run was over in the previous frame
  WayPoint last;               ///< newest pose, whether it became a waypoint or not
};

/// The part of the state of paths that another document resets.
struct PathOfDocument {
  std::optional<PathRecording> recording;  ///< path that is recorded now, or nothing
  LastScenarios last;                      ///< values of kinds that the document had before
};

struct PathState : PathOfDocument {
  using PerDocument = PathOfDocument;
  int selected = -1;            ///< index of the selected waypoint, or -1
  bool held = false;            ///< whether the button is held on the waypoint
  bool moved = false;           ///< whether the waypoint was dragged since the press
  std::uint64_t gesture = 0;    ///< number of the drag in the history
  dvec2 start{0};               ///< pointer at the press [pixels of the view]
  dvec3 grabbed_W{0};           ///< position of the waypoint's glyph at the press
  std::optional<WayPoint> was;  ///< waypoint at the press
  /// Kind chosen in the inspector while the kind still lacks a required value, such as a recording. Until then it
  /// cannot become the document's kind.
  std::optional<ScenarioKind> chosen;

  double record_every = 0.05;  ///< time between recorded waypoints [s]
};

/// Returns the edited scenario of the document if the running scene was built from the document; null otherwise.
[[nodiscard]] const Scenario* edited_scenario(const Viewer& viewer, const Shown& shown);

/// Returns the edited path of the document, or nothing if the scenario is of another kind.
[[nodiscard]] std::optional<ShownPath> edited_path(const Viewer& viewer, const Shown& shown,
                                                   const PathState& path_state);

/// Returns the initial waypoints of a new path, which approximate the running scenario.
[[nodiscard]] std::vector<WayPoint> points_to_begin_with(const Viewer& viewer, const Shown& shown);

/// Adds a waypoint at the present pose of the finger, after the selected waypoint, or at the end if none is selected.
void add_way_point(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path);
/// Deletes the selected waypoint. A path retains at least two waypoints.
void delete_way_point(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path);
/// Returns whether a waypoint that can be moved is selected.
[[nodiscard]] bool has_way_point(const Viewer& viewer, const Shown& shown, const PathState& path);
/// Begins a gesture at the selected waypoint. Returns false if no waypoint is selected.
bool take_way_point(const Viewer& viewer, const Shown& shown, PathState& path);
/// Returns the edit that moves the waypoint by the gesture: with the pointer in the plane that faces the camera, along
/// an axis of the world, or by a typed number.
[[nodiscard]] GestureEdit moved_way_point(const Viewer& viewer, const Shown& shown, const ToolState& tool,
                                          const PathState& path);
/// Cancels the drag of the selected waypoint, which returns to its former place.
void cancel_way_point_drag(WindowUi& ui, PathState& path);

/// Handles the mouse. A click on a glyph selects the waypoint, and a drag moves the waypoint in the plane that faces
/// the camera. Returns whether the mouse was consumed.
bool handle_path_mouse(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, PathState& state,
                       const PointerEvent& event);

/// The waypoints of a path in the view.
extern const Feature kPath;

/// Returns whether there is a tool whose path the document could have.
[[nodiscard]] bool can_record_path(const Viewer& viewer, const Shown& shown);

/// Begins a recording, or ends the running one. The recorded waypoints become the document's path, as one edit.
void toggle_path_recording(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path, Messages& messages);

/// Deselects and releases the waypoint after another scene has begun. A recording continues with the new run.
void let_go_of_way_points(PathState& path_state);

/// Records the path of the ball that the user moves.
extern const Feature kPathRecorder;
/// Sets "scenario": the edited and the running one, and the waypoints.
void dump_scenario(const App& app, nlohmann::ordered_json& state);

struct ToggleRecordPath {};
void carry_out(const ToggleRecordPath& command, App& app);

/// Returns the fields and buttons of that section, of all kinds of scenarios.
[[nodiscard]] std::vector<PanelPart> scenario_parts();

/// Draws the inspector's section: the kind of the scenario, its values, its waypoints, and the button that runs the
/// scenario. Each change is an edit of the document.
void draw_scenario_section(WindowUi& ui, const Viewer& viewer, const Shown& displayed, PathState& path,
                           Messages& messages);

}  // namespace taxel::ui
