// Commands about the cameras, and the first look of a camera at a new scene.
#pragma once

#include <array>
#include <optional>

#include "app/studio/frame/command.h"
#include "ui/scene/pick/camera.h"

namespace taxel::ui {

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

void carry_out(const FrameCamera& command, App& app);
void carry_out(const AlignCamera& command, App& app);
void carry_out(const TakeStandardView& command, App& app);
void carry_out(const ToggleOrthographic& command, App& app);
void carry_out(const StepCamera& command, App& app);

/// Cameras, one per mode, that turn to the displayed scene.
struct Framing {
  std::array<bool, 2> turns{};  ///< the camera turns as soon as its mode has something to display
  bool checks_view = false;     ///< the mode has changed: a sensor outside of the view is to be framed
  /// Cameras saved with the project (LAYOUT) or the step (SIMULATE) that was opened.
  std::array<std::optional<Camera>, 2> saved;
};
/// Frames each camera that waits for it, and the present camera if it does not show the sensor after a change of mode.
void frame_cameras(App& app);

}  // namespace taxel::ui
