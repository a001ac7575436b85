// Other shapes of geoms of a compiled scene, for batches over objects.
#pragma once

#include <string>
#include <vector>

#include "core/document/batch/scene_job.h"
#include "core/sim/scene/loaded_scene.h"

namespace taxel {

/// Changes geoms, and compiles the scene again. Throws Error with a JSON pointer such as /geoms/ball/size: there is no
/// such geom, its type has another number of sizes, or its body has an <inertial> that a mass would not change. `name`
/// is the scene's in MuJoCo's own reasons.
void change_geoms(CompiledScene& scene, const std::vector<GeomChange>& changes, const std::string& name);

}  // namespace taxel
