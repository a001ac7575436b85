// Commands about the interface alone, carried out. A command without an overload here is one to the program.
#pragma once

#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/app/ui_state.h"
#include "app/studio/features/camera/camera_follow.h"
#include "app/studio/features/explain/explain_tool.h"
#include "app/studio/features/generate/generate.h"
#include "app/studio/features/measure/measure_tool.h"
#include "app/studio/features/probe/probe_tool.h"
#include "app/studio/features/scenario/path_recorder.h"
#include "app/studio/features/taxel/gesture.h"
#include "ui/widgets/keyboard_focus.h"

namespace taxel::ui {

/// Returns the next speed above or below, along 1/16 ... 1/2, 1, 2 ... 16.
[[nodiscard]] double next_speed(double speed, bool faster);

/// Returns the plane that mirrors a sensor from side to side, by its frame: through the origin if the origin is close
/// to the middle of `bounds`, otherwise through the middle. Frame M.
[[nodiscard]] MirrorPlane mirror_plane_of(const Layout& layout, const Aabb& bounds);

/// Carries out a command about the interface: one overload each.
struct CarryOut {
  UiState& ui;
  const UiInput& input;

  // Window.
  void operator()(const ShowOpenDialog&) const { open_dialog(ui); }
  void operator()(const Escape&) const;
  void operator()(const EnterPanel& command) const { enter_panel(ui, command.title); }
  void operator()(const OpenPalette&) const;
  void operator()(const StartTour&) const { ui.tour_step = 0; }
  void operator()(const TogglePanel& command) const;
  void operator()(const ToggleTheme&) const { flip(ui.saved.dark); }
  void operator()(const ToggleFullScreen&) const { flip(ui.full_screen); }
  void operator()(const ScaleInterface& command) const;
  void operator()(const ResetArrangement&) const;

  // 3-D view.
  void operator()(const ToggleOverlay& command) const { flip(ui.saved.overlays.*command.overlay); }
  void operator()(const ToggleGroup& command) const { flip((ui.saved.overlays.*command.groups).at(command.group)); }
  void operator()(const CycleFrames&) const { ui.saved.overlays.frames = next(ui.saved.overlays.frames); }
  void operator()(const CycleLabels&) const { ui.saved.overlays.labels = next(ui.saved.overlays.labels); }
  void operator()(const ToggleClipPlane&) const { toggle_clip(ui, input); }
  void operator()(const FlipClipPlane&) const { ui.clip = ui.clip->flipped(); }
  void operator()(const ToggleRangeLock&) const { flip(ui.range.automatic); }
  void operator()(const FrameCamera& command) const;
  void operator()(const AlignCamera&) const { align_camera(ui, input); }
  void operator()(const StepCamera& command) const { look_through_next(ui, input, command.direction); }
  void operator()(const SelectParentBody&) const { select_parent(ui, input); }

  // Recorded steps, and the run.
  void operator()(const GoToEvent& command) const;
  void operator()(const GoToNewestStep&) const { ui.ask(ScrubTo{input.frame->history.last}); }
  void operator()(const TogglePlayBackwards&) const { ui.ask(ReplayHistory{input.replay < 0 ? 0 : -1}); }
  void operator()(const ToggleLoop&) const;
  void operator()(const ToggleBreakOnJump&) const;
  void operator()(const ExplainReading&) const { explain_reading(ui, input); }
  void operator()(const ToggleRecording&) const { ui.ask(SetRecording{!input.frame->recording.on}); }
  void operator()(const ToggleRecordPath&) const { toggle_path_recording(ui, input); }
  void operator()(const ChangeSpeed& c) const { ui.ask(SetSpeed{next_speed(input.speed, c.faster)}); }

  // Selection, tools and edits of the layout.
  void operator()(const SelectAll&) const;
  void operator()(const SelectNone&) const { ui.selection.clear(); }
  void operator()(const InvertSelection&) const;
  void operator()(const BeginGesture& command) const { begin_gesture(ui, input, command.tool, command.copies); }
  void operator()(const ConstrainGesture& command) const { constrain_gesture(ui, command.axis); }
  void operator()(const AcceptGesture&) const { accept_gesture(ui, input); }
  void operator()(const CancelTool&) const { cancel_tool(ui); }
  void operator()(const ToggleTool& command) const;
  void operator()(const ToggleProbe&) const { toggle_probe(ui, input); }
  void operator()(const ToggleMeasure&) const { toggle_measure(ui, input); }
  void operator()(const ToggleGenerate&) const { toggle_generate(ui, input); }
  void operator()(const DeleteSelected&) const { ui.ask(EditProject{DeleteTaxels{ui.selection.taxels}, {}}); }
  void operator()(const ProjectSelectedBack&) const;
  void operator()(const RenameSelected&) const;
  void operator()(const MoveInOrder& command) const;
  void operator()(const MirrorSelected&) const;
  void operator()(const HideSelected&) const;
  void operator()(const ShowOnlySelected&) const;

 private:
  static void flip(bool& value) { value = !value; }
};

/// Whether a command is about the interface alone, so that it takes effect at once.
template <class C>
concept InterfaceCommand = requires(const CarryOut& carry_out, C command) {
  carry_out(command);
};

}  // namespace taxel::ui
