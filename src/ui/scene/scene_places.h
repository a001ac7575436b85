// Frames and names of a scene's bodies, joints, geoms, sites and cameras, as the overlays want them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// X_WS in the step of a frame; none: a step that was saved without bodies.
[[nodiscard]] std::optional<Pose> site_pose(const SimFrame& frame, const SceneSite& site);

/// Those that overlays.frames asks for; geoms and sites of groups that are shown.
[[nodiscard]] std::vector<Pose> shown_frames(const SceneInput& input);

struct NamedPlace {
  const std::string* name = nullptr;  ///< lives as long as the input's frame
  dvec3 p_W{0};
};
/// Returns the places of the parts that overlays.labels asks for, in the same order. The world has no label.
[[nodiscard]] std::vector<NamedPlace> labelled_places(const SceneInput& input);

}  // namespace taxel::ui
