// The document's mesh: its unit, its repair, its section in the inspector, and the directions of the finger.
// Arrows show tip and pad while they are a guess, and clicks on faces set them.
#pragma once

#include <string>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/taxel/tool_state.h"

namespace taxel::ui {

/// The direction of the finger that the next click on a face sets.
enum class FramePick { none, tip, pad };

struct MeshState {
  using PerDocument = MeshState;  ///< another document resets all of it
  bool shows_changes = false;     ///< whether the changes of the repair are drawn over the skin
  int step = -1;                  ///< index in RepairReport::steps of the step last framed, or -1
  /// Tip and pad of the document are a guess: arrows show both until the user confirms or sets them.
  bool frame_is_guess = false;
  FramePick pick = FramePick::none;
};

struct SetMeshUnit {
  double metres = 1;  ///< length of one unit of the mesh file
};
struct PolishSamples {};  ///< polishes the document's samples if a preview's are shown

/// Returns the state of the mesh, with the distances by which its repair moved the surface: "open", "closed",
/// "wrapped, off by 0.120 mm rms, 0.500 mm at most".
[[nodiscard]] std::string mesh_state_text(const SensorModel& model);

/// Draws the rows of the mesh's properties about repair: the state of the mesh and the level of the repair.
void draw_repair_rows(WindowUi& ui, const DocumentView& document, const SensorModel& model);
/// Draws the buttons below the rows, and a line for each step of the repair.
void draw_repair_steps(WindowUi& ui, Viewer& viewer, const DocumentView& document, MeshState& mesh, FollowState& follow,
                       const SensorModel& model);

/// Draws the section of the inspector: unit, size, direction of the sensor, and defects of the mesh.
void draw_mesh_section(WindowUi& ui, Viewer& viewer, const DocumentView& document, MeshState& mesh, FollowState& follow,
                       PanelsShown& panels, const SensorModel& model);

/// Returns the fields and buttons of that section.
[[nodiscard]] std::vector<PanelPart> mesh_parts();

/// Every defect of the mesh, in a window of its own.
extern const Feature kMeshReport;
/// Sets "frame_guess", and "show_changes" of the mesh of the document.
void dump_mesh(const App& app, nlohmann::ordered_json& state);

struct FrameArrow {
  std::string name;          ///< "tip" or "pad"
  dvec3 from_W{0}, to_W{0};  ///< [m]
};

/// Returns the arrows of tip and pad from the middle of the mesh to outside of the mesh. Empty unless the directions
/// are a guess or are being set.
[[nodiscard]] std::vector<FrameArrow> frame_arrows(const Viewer& viewer, const Shown& displayed, const MeshState& mesh);

/// Posts an edit that sets both directions. After the edit, the directions are no longer a guess.
void set_frame(WindowUi& ui, MeshState& mesh, const SensorFrame& frame);

/// Returns the frame with the tip or the pad in a direction, or along the file's axis if that axis is within 25 degrees
/// of the direction. The other direction stays at right angles.
[[nodiscard]] SensorFrame with_direction(SensorFrame frame, FramePick what, const dvec3& direction);

/// Sets the tip or the pad to the direction of the face at a pixel of the view, if the next click is to set one of
/// them. Returns whether the click was used.
bool pick_frame(WindowUi& ui, const Viewer& viewer, const Shown& shown, const ToolState& tool, MeshState& mesh,
                double x, double y);

/// The directions of the finger, which a click on a face sets.
extern const Feature kMeshFrame;

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::SetMeshUnit& command, Host& host);
void carry_out(const ui::PolishSamples& command, Host& host);

}  // namespace taxel::studio
