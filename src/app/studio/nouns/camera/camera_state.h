// The camera of the 3-D view: its commands, its first look at a new scene, the camera or the body of the scene that it
// follows in SIMULATE, and tests of whether the view shows the sensors.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/perturb/perturb_state.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "ui/scene/camera.h"
#include "ui/scene/picking.h"

namespace taxel::ui {

/// The camera or the body that the view of SIMULATE follows.
struct FollowState {
  int camera = -1;               ///< index in SceneMarks::cameras of the view's camera, or -1
  double depth = 1;              ///< camera to the middle of the scene when it was chosen [m]
  Camera free;                   ///< the view's camera before a camera of the scene was chosen
  int body = -1;                 ///< body that the camera follows, or -1
  dvec3 point_B{0}, point_W{0};  ///< followed point: in the body frame, and in the world at the last frame
};

struct FrameCamera {
  bool selection = false;  ///< only the selected taxels, otherwise everything
  bool operator==(const FrameCamera&) const = default;
};
struct AlignCamera {};
/// Looks from the end of an axis: 0..5 for +x, -x, +y, -y, +z, -z.
struct TakeStandardView {
  int axis = 0;
  bool operator==(const TakeStandardView&) const = default;
};
struct ToggleOrthographic {};
/// Looks through the next or the previous camera of the scene.
struct StepCamera {
  int direction = 1;  ///< 1 or -1
  bool operator==(const StepCamera&) const = default;
};

/// Looks through one camera of the scene.
struct LookThroughCamera {
  int camera = -1;  ///< index in SceneMarks::cameras, or -1 to return to the view that the user moves
  bool operator==(const LookThroughCamera&) const = default;
};

void carry_out(const FrameCamera& command, App& app);
void carry_out(const AlignCamera& command, App& app);
void carry_out(const TakeStandardView& command, App& app);
void carry_out(const ToggleOrthographic& command, App& app);
void carry_out(const StepCamera& command, App& app);
void carry_out(const LookThroughCamera& command, App& app);

/// Cameras, one per mode, that turn to the displayed scene.
struct Framing {
  std::array<bool, 2> turns{};  ///< the camera frames the scene as soon as its mode has something to display
  std::array<bool, 2> first{};  ///< the camera also turns to the touching side, because another document was opened
  bool checks_view = false;     ///< the mode has changed: a sensor outside of the view is to be framed
  /// Cameras saved with the project (LAYOUT) or the step (SIMULATE) that was opened.
  std::array<std::optional<Camera>, 2> saved;
  /// Cameras, one per mode, as they framed the scene or its contact without the user.
  std::array<std::optional<Camera>, 2> framed;
};
/// The camera of a scenario's run, which looks at the contact until the user moves it.
struct ContactCamera {
  bool leads = false;
};
/// Moves the camera of a playing scenario to its contact, `seconds` further, so that contact and pad fill the view.
void lead_to_contact(App& app, double seconds);

/// Frames each camera that waits for it, and the present camera if it does not show the sensor after a change of mode.
void frame_cameras(App& app);
/// Returns whether the user has not moved the camera of the present mode since it framed the scene.
[[nodiscard]] bool has_untouched_camera(const App& app);

/// The eight corners of a sensor's bounding box, which is aligned with the axes of its mesh [m], world.
using BoxCorners = std::array<dvec3, 8>;

/// Returns the corners of a box in a frame M that has the pose X_WM.
[[nodiscard]] BoxCorners corners_of(const Aabb& box_M, const Pose& X_WM);

/// Returns the boxes of the sensors that the present mode shows: all sensors of the scene in SIMULATE, and the sensor
/// of the document in LAYOUT.
[[nodiscard]] std::vector<BoxCorners> sensor_boxes(const Viewer& viewer, const Shown& shown);

/// Returns whether every corner of the box projects into the view.
[[nodiscard]] bool is_inside_view(const BoxCorners& box_W, const Camera& camera, int width, int height);

/// Returns whether the whole box is beyond one side of the view, or behind the eye. A box that surrounds the view is
/// not outside.
[[nodiscard]] bool is_outside_view(const BoxCorners& box_W, const Camera& camera, int width, int height);

/// Returns whether every sensor of the present mode is outside the view. False before the view has a size, and without
/// sensors.
[[nodiscard]] bool sensors_are_outside_view(const Viewer& viewer, const Shown& shown);

/// Returns whether a scene with several sensors with taxels is displayed. The view then shows the sensors, which touch
/// the grasped object, and not the whole robot.
[[nodiscard]] bool has_several_sensors(const Viewer& viewer, const Shown& shown);
/// Turns the camera of the present mode: to the touching side of the layout, tip up, or to a hand at three quarters of
/// its palm. The direction stays if the displayed scene has one sensor, or if a hand has no palm at the side.
void look_at_touching_side(Viewer& viewer, const Shown& shown);
/// Returns the camera of a mode before anything is loaded.
[[nodiscard]] Camera first_camera(Mode mode);
/// Frames a scene that is displayed for the first time; if `turns`, from its touching side. A MuJoCo scene whose file
/// sets a direction, a centre or a size of its view gets the camera of the file.
void show_scene_first(Viewer& viewer, const Shown& shown, bool turns);
/// Moves the camera so that all displayed objects fill the view; in a scene with several sensors, all sensors. The
/// direction of view stays.
void frame_scene(Viewer& viewer, const Shown& shown);
/// Restores the initial direction of view. A MuJoCo scene gets the camera of its file (mjv_defaultFreeCamera).
void align_camera(Viewer& viewer, const Shown& shown, FollowState& follow);

/// Returns whether the view looks through a camera of the scene, which the user cannot move.
[[nodiscard]] bool looks_through_camera(const Viewer& viewer, const FollowState& follow);
[[nodiscard]] bool has_cameras(const Viewer& viewer, const RunView& run);
/// Looks through a camera of the scene, which must exist.
void look_through(const Viewer& viewer, const Shown& shown, FollowState& follow, int camera);
/// Looks through the next camera of the scene (`direction` 1) or the previous camera (-1).
void look_through_next(const Viewer& viewer, const Shown& shown, FollowState& follow, int direction);
/// Centres the camera on the picked point. If the point's body can move, the camera follows the body.
void track_body(Viewer& viewer, const RunView& run, FollowState& follow, const Pick& under);
/// Stops following. The camera of SIMULATE returns to where the user left it, or stays where it followed the body to.
void leave_followed(Viewer& viewer, FollowState& follow);
/// Calls leave_followed() in SIMULATE, because the user moves the camera.
void free_camera(Viewer& viewer, FollowState& follow);
/// Returns a text that names the followed camera or body and how to stop following. Empty if the camera follows
/// nothing.
[[nodiscard]] std::string follow_text(const Viewer& viewer, const RunView& run, const FollowState& follow);

[[nodiscard]] bool can_select_parent(const Viewer& viewer, const RunView& run);
/// Selects the parent of the selected body.
void select_parent(WindowUi& ui, Selection& selection, const RunView& run, PerturbState& perturb,
                   ControlsState& controls);

/// Moves the camera with the camera or body that it follows.
void follow_scene(Viewer& viewer, const RunView& run, FollowState& follow);
/// Lets the camera follow the chosen body or camera, in each frame.
extern const Feature kCameraFollow;
/// Sets "followed" and "sensor_boxes": the corners of each sensor in the window.
void dump_camera_follow(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
