// Commands about gestures, tools and the selected taxels.
#pragma once

#include "app/studio/frame/command.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "core/document/edit.h"

namespace taxel::ui {

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

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::CopyTaxels& command, Host& host);
void carry_out(const ui::PasteTaxels& command, Host& host);

}  // namespace taxel::studio
