#include "core/sim/model/scene_view.h"

#include <algorithm>

#include "core/sim/model/drawn_mesh.h"
#include "core/sim/model/geometry.h"

namespace taxel {

std::vector<SceneGeom> drawable_geoms(const mjModel& m, std::vector<int>& geoms) {
  std::vector<SceneGeom> drawn;
  geoms.clear();
  for (int g = 0; g < m.ngeom; ++g) {
    const int material = m.geom_matid[g];
    const float* rgba = material >= 0 ? m.mat_rgba + 4 * material : m.geom_rgba + 4 * g;
    if (!(rgba[3] > 0)) continue;
    SceneGeom geom;
    geom.name = geom_name(m, g);
    geom.body = body_name(m, m.geom_bodyid[g]);
    geom.body_index = m.geom_bodyid[g];
    geom.mesh = drawn_mesh(m, g);
    if (geom.mesh == nullptr) continue;
    geom.rgba = {rgba[0], rgba[1], rgba[2], rgba[3]};
    geom.plane = m.geom_type[g] == mjGEOM_PLANE;
    geom.group = std::clamp(m.geom_group[g], 0, mjNGROUP - 1);  // clamped as in MuJoCo's viewer
    drawn.push_back(std::move(geom));
    geoms.push_back(g);
  }
  return drawn;
}

}  // namespace taxel
