// Commands about the interface alone, carried out. A command without an overload here is one to the program.
#pragma once

#include "app/studio/frame/app.h"
#include "app/studio/frame/arrangement.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/reading_range.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/camera_follow.h"
#include "app/studio/nouns/camera/follow_state.h"
#include "app/studio/nouns/explain/explain.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/explain/explain_tool.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/file_dialog_tool.h"
#include "app/studio/nouns/generate/generate.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/measure/measure_tool.h"
#include "app/studio/nouns/perturb/perturb_state.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/probe/probe_tool.h"
#include "app/studio/nouns/scenario/path_recorder.h"
#include "app/studio/nouns/scenario/path_state.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/taxel/gesture.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/shell/interface/tools.h"
#include "ui/scene/pick/gizmo.h"
#include "ui/widgets/keyboard_focus.h"

namespace taxel::ui {

/// Returns the next speed above or below, along 1/16 ... 1/2, 1, 2 ... 16.
[[nodiscard]] double next_speed(double speed, bool faster);

/// Returns the plane that mirrors a sensor from side to side, by its frame: through the origin if the origin is close
/// to the middle of `bounds`, otherwise through the middle. Frame M.
[[nodiscard]] MirrorPlane mirror_plane_of(const Layout& layout, const Aabb& bounds);

/// Carries out a command about the interface: one overload each.
struct CarryOut {
  App& app;

  // Window.
  void operator()(const ShowOpenDialog&) const { open_dialog(*app.ui, app.get<FileDialog>()); }
  void operator()(const Escape&) const { cancel_innermost(app); }
  void operator()(const EnterPanel& command) const { enter_panel(*app.ui, command.title); }
  void operator()(const OpenPalette&) const;
  void operator()(const Call& command) const { command.function(app); }
  void operator()(const TogglePanel& command) const;
  void operator()(const ToggleTheme&) const { flip(app.get<Appearance>().dark); }
  void operator()(const ToggleFullScreen&) const { flip(app.get<WindowState>().full_screen); }
  void operator()(const ToggleDesktopDialog&) const { flip(app.get<FileDialog>().prefers_desktop); }
  void operator()(const ScaleInterface& command) const;
  void operator()(const ResetArrangement&) const;
  void operator()(const MaximisePanel&) const;

  // 3-D view.
  void operator()(const ToggleOverlay& command) const { flip(app.viewer->overlays().*command.overlay); }
  void operator()(const ToggleGroup& command) const {
    flip((app.viewer->overlays().*command.groups).at(command.group));
  }
  void operator()(const CycleFrames&) const { app.viewer->overlays().frames = next(app.viewer->overlays().frames); }
  void operator()(const CycleLabels&) const { app.viewer->overlays().labels = next(app.viewer->overlays().labels); }
  void operator()(const ToggleClipPlane&) const { toggle_clip(*app.viewer, *app.shown); }
  void operator()(const FlipClipPlane&) const { app.viewer->clip = app.viewer->clip->flipped(); }
  void operator()(const ToggleRangeLock&) const { flip(app.viewer->range.automatic); }
  void operator()(const ToggleReadingRangeLock&) const { toggle_reading_lock(*app.viewer, *app.shown); }
  void operator()(const LinkRanges&) const { flip(app.viewer->readings.linked); }
  void operator()(const FrameCamera& command) const;
  void operator()(const AlignCamera&) const { align_camera(*app.viewer, *app.shown, app.get<FollowState>()); }
  void operator()(const TakeStandardView& command) const {
    free_camera(*app.viewer, app.get<FollowState>());
    take_standard_view(app.viewer->camera(), command.axis);
  }
  void operator()(const ToggleOrthographic&) const {
    free_camera(*app.viewer, app.get<FollowState>());
    flip(app.viewer->camera().orthographic);
  }
  void operator()(const StepCamera& command) const {
    look_through_next(*app.viewer, *app.shown, app.get<FollowState>(), command.direction);
  }
  void operator()(const SelectParentBody&) const {
    select_parent(*app.ui, app.viewer->selection, app.shown->run, app.get<PerturbState>(), app.get<ControlsState>());
  }

  // Recorded steps, and the run.
  void operator()(const GoToEvent& command) const;
  void operator()(const GoToNewestStep&) const { app.ui->post(ScrubTo{app.shown->run.frame->history.last}); }
  void operator()(const TogglePlayBackwards&) const { app.ui->post(ReplayHistory{app.shown->run.replay < 0 ? 0 : -1}); }
  void operator()(const ToggleLoop&) const;
  void operator()(const ToggleBreakOnJump&) const;
  void operator()(const ExplainReading&) const {
    explain_reading(*app.viewer, *app.shown, app.get<ExplainState>(), app.get<PanelsShown>()[kExplain]);
  }
  void operator()(const ToggleRecording&) const { app.ui->post(SetRecording{!app.shown->run.frame->recording.on}); }
  void operator()(const ToggleRecordPath&) const {
    toggle_path_recording(*app.ui, *app.viewer, *app.shown, app.get<PathState>(), app.get<Messages>());
  }
  void operator()(const ChangeSpeed& c) const { app.ui->post(SetSpeed{next_speed(app.shown->run.speed, c.faster)}); }

  // Selection, tools and edits of the layout.
  void operator()(const SelectAll&) const;
  void operator()(const SelectNone&) const { app.viewer->selection.clear(); }
  void operator()(const InvertSelection&) const;
  void operator()(const BeginGesture& command) const {
    begin_gesture(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), app.get<PathState>(), command.tool,
                  command.copies);
  }
  void operator()(const ConstrainGesture& command) const { constrain_gesture(app.get<ToolState>(), command.axis); }
  void operator()(const AcceptGesture&) const {
    accept_gesture(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), app.get<PathState>());
  }
  void operator()(const CancelTool&) const { cancel_tool(*app.ui, app.viewer->selection, app.get<ToolState>()); }
  void operator()(const ToggleTool& command) const;
  void operator()(const ProbeInLayout&) const;
  void operator()(const ToggleProbe&) const {
    if (toggle_probe(*app.viewer, app.shown->document, app.get<ProbeState>())) leave_tool();
  }
  void operator()(const ToggleMeasure&) const {
    if (toggle_measure(*app.viewer, app.shown->document, app.get<MeasureState>())) leave_tool();
  }
  void operator()(const ToggleGenerate&) const {
    toggle_generate(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), app.get<GenerateState>());
  }
  void operator()(const DeleteSelected&) const {
    app.ui->post(EditProject{DeleteTaxels{app.viewer->selection.taxels}, {}});
  }
  void operator()(const ProjectSelectedBack&) const;
  void operator()(const RenameSelected&) const;
  void operator()(const MoveInOrder& command) const;
  void operator()(const MirrorSelected&) const;
  void operator()(const HideSelected&) const;
  void operator()(const ShowOnlySelected&) const;

 private:
  static void flip(bool& value) { value = !value; }
  /// Cancels the tool in use, because another one begins.
  void leave_tool() const {
    if (app.get<ToolState>().tool != Tool::none) cancel_tool(*app.ui, app.viewer->selection, app.get<ToolState>());
  }
};

/// Whether a command is about the interface alone, so that it takes effect at once.
template <class C>
concept InterfaceCommand = requires(const CarryOut& carry_out, C command) {
  carry_out(command);
};

}  // namespace taxel::ui
