// The tools and commands that change taxels. A gesture begins at the selected taxels, follows pointer and keys, and is
// one step of the history.
#pragma once

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/studio/nouns/taxel/gesture_edit.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "core/document/edit.h"

namespace taxel::ui {

struct GenerateState;

/// Returns the view of the layout for gestures.
[[nodiscard]] GestureView gesture_view(const Viewer& viewer, const Shown& shown);

/// Begins a gesture with the selected waypoint or the selected taxels. If `copies`, the gesture adds and changes copies
/// of the taxels. Does nothing if nothing is selected.
void begin_gesture(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool_state, PathState& path, Tool tool,
                   bool copies = false);
void accept_gesture(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, const PathState& path);
/// Cancels any tool and restores the state before the tool.
void cancel_tool(WindowUi& ui, Selection& selection, ToolState& tool);

/// Adds the characters typed in this frame to the number of the running gesture.
void type_number(ToolState& tool);
void constrain_gesture(ToolState& tool, int axis);  ///< constrains to an axis; a second call frees again

/// Requests the edit that pointer and keys make of the gesture, if they have changed.
void follow_gesture(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, const PathState& path);
/// Ends any tool without an edit.
void end_tool(ToolState& tool);

/// Adds a taxel on the surface under a pixel of the view. Does nothing on the background.
void place_taxel(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool, double x, double y);
/// Changes the radii of the selected taxels by 2 % per notch of Ctrl+wheel. A series of notches is one step of the
/// history.
void resize_by_wheel(WindowUi& ui, const Selection& selection, const DocumentView& document, ToolState& tool,
                     double notches);

/// The taxel that a click would add.
struct PlacementGhost {
  Taxel taxel;
  int samples = 0;  ///< number of samples of the displayed model in its receptive field
};
[[nodiscard]] std::optional<PlacementGhost> placement_ghost(const Viewer& viewer, const Shown& displayed,
                                                            const ToolState& tool, double x, double y);

/// Begins a gesture on the selected taxels or the selected waypoint; `copies`: on copies of the taxels.
struct BeginGesture {
  Tool tool{};
  bool copies = false;
  bool operator==(const BeginGesture&) const = default;
};
/// Restricts the running gesture to an axis, or frees it if it is restricted to that axis.
struct ConstrainGesture {
  int axis = 0;  ///< 0 x, 1 y, 2 z
  bool operator==(const ConstrainGesture&) const = default;
};
struct AcceptGesture {};
struct CancelTool {};
/// Starts a tool, or leaves it if it is the active one.
struct ToggleTool {
  Tool tool{};
  bool operator==(const ToggleTool&) const = default;
};
struct DeleteSelected {};
struct ProjectSelectedBack {};
struct RenameSelected {};
struct MoveInOrder {
  bool earlier = false;
  bool operator==(const MoveInOrder&) const = default;
};
struct MirrorSelected {};
struct HideSelected {};
/// Hides all taxels but the selected ones, or shows all if just those are shown.
struct ShowOnlySelected {};
struct CopyTaxels {};  ///< the selected ones, as JSON
struct PasteTaxels {};

void carry_out(const BeginGesture& command, App& app);
void carry_out(const ConstrainGesture& command, App& app);
void carry_out(const AcceptGesture& command, App& app);
void carry_out(const CancelTool& command, App& app);
void carry_out(const ToggleTool& command, App& app);
void carry_out(const DeleteSelected& command, App& app);
void carry_out(const ProjectSelectedBack& command, App& app);
void carry_out(const RenameSelected& command, App& app);
void carry_out(const MoveInOrder& command, App& app);
void carry_out(const MirrorSelected& command, App& app);
void carry_out(const HideSelected& command, App& app);
void carry_out(const ShowOnlySelected& command, App& app);

/// Returns the plane that mirrors a sensor from side to side, by its frame: through the origin if the origin is close
/// to the middle of `bounds`, otherwise through the middle. Frame M.
[[nodiscard]] MirrorPlane mirror_plane_of(const Layout& layout, const Aabb& bounds);

/// Cancels the tool in use, because another one begins.
void leave_tool(App& app);

/// Handles the view's mouse before the camera does. x, y: pointer in pixels of the view. Returns whether a tool
/// consumed it.
bool handle_tool_mouse(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool, GenerateState& generate,
                       PathState& path, const SceneInput& scene, double x, double y, bool hovered);

/// The tools that change taxels, with their lines and hints over the view.
extern const Feature kTaxelTools;
/// Sets "tool": the one in use.
void dump_tool(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::CopyTaxels& command, Host& host);
void carry_out(const ui::PasteTaxels& command, Host& host);

}  // namespace taxel::studio
