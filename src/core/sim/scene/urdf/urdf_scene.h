// URDF as a scene: MuJoCo's own converter makes MJCF of it, to which sensors can be added.
#pragma once

#include <filesystem>

#include "core/sim/scene/dropped_attributes.h"

namespace taxel {

/// Returns true if the file's root element is <robot>.
bool is_urdf(const std::filesystem::path& file);

/// Returns the scene that MuJoCo reads from a URDF, as MJCF next to the file. Throws Error naming the file with
/// MuJoCo's reason.
CurrentMjcf mjcf_of_urdf(const std::filesystem::path& file);

}  // namespace taxel
