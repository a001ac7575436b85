// Frames and names of a scene's bodies, joints, geoms, sites and cameras that the overlays draw.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// Returns X_WS in the step of a frame, or nothing if the step was saved without bodies.
[[nodiscard]] std::optional<Pose> site_pose(const SimFrame& frame, const SceneSite& site);

/// Returns the frames that overlays.frames selects; geoms and sites only if their group is shown.
[[nodiscard]] std::vector<Pose> shown_frames(const SceneInput& input);

struct NamedPlace {
  const std::string* name = nullptr;  ///< name, valid as long as the input's frame
  dvec3 p_W{0};
};
/// Returns the places of the parts that overlays.labels selects, in the order of the parts. The world has no label.
[[nodiscard]] std::vector<NamedPlace> labelled_places(const SceneInput& input);

}  // namespace taxel::ui
