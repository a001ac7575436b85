#include "core/sim/plugin/drawn_contacts.h"

#include <algorithm>
#include <array>

namespace taxel {
namespace {

/// Colours from no pressure to the full scale: dark blue, blue, green, yellow, red.
constexpr std::array<std::array<float, 3>, 5> kRamp{{{0.25F, 0.30F, 0.62F},
                                                     {0.13F, 0.45F, 0.75F},
                                                     {0.20F, 0.70F, 0.55F},
                                                     {0.95F, 0.80F, 0.25F},
                                                     {0.85F, 0.25F, 0.15F}}};

std::array<float, 4> color_of(double fraction) {
  const double place = std::clamp(fraction, 0.0, 1.0) * (kRamp.size() - 1.0);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kRamp.size() - 2);
  const auto part = static_cast<float>(place - static_cast<double>(below));
  std::array<float, 4> color{0, 0, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) color[i] = kRamp[below][i] + part * (kRamp[below + 1][i] - kRamp[below][i]);
  return color;
}

/// Appends a decorative geom without a shape, for the contact of the geom of the body with another geom. Returns null
/// if the scene is full.
mjvGeom* append(mjvScene& scene, const BodyContacts& body, int touched_geom, const float* color) {
  if (scene.ngeom >= scene.maxgeom) {
    scene.status = 1;
    return nullptr;
  }
  mjvGeom* geom = scene.geoms + scene.ngeom;
  mjv_initGeom(geom, mjGEOM_NONE, nullptr, nullptr, nullptr, color);
  geom->category = mjCAT_DECOR;
  geom->objtype = mjOBJ_GEOM;
  geom->objid = body.settings().geom;
  geom->dataid = touched_geom;  // free for this use: triangles and arrows have no data
  geom->segid = scene.ngeom++;
  return geom;
}

/// Appends a triangle of the world. MuJoCo draws the points pos + s size[0] x + t size[1] y with s, t >= 0 and s + t <=
/// 1, where x and y are the first two columns of mat.
void append_triangle(mjvScene& scene, const BodyContacts& body, int touched_geom, const std::array<dvec3, 3>& corners,
                     const float* color) {
  const auto& [a, b, c] = corners;
  const dvec3 x = b - a, y = c - a, z = glm::cross(x, y);
  const dvec3 lengths{glm::length(x), glm::length(y), glm::length(z)};
  if (!(std::min({lengths.x, lengths.y, lengths.z}) > 0)) return;
  mjvGeom* geom = append(scene, body, touched_geom, color);
  if (geom == nullptr) return;
  geom->type = mjGEOM_TRIANGLE;
  geom->emission = 0.5F;
  for (int i = 0; i < 3; ++i) {
    geom->pos[i] = static_cast<float>(a[i]);
    geom->size[i] = i < 2 ? static_cast<float>(lengths[i]) : 1.0F;
    geom->mat[3 * i] = static_cast<float>(x[i] / lengths.x);
    geom->mat[3 * i + 1] = static_cast<float>(y[i] / lengths.y);
    geom->mat[3 * i + 2] = static_cast<float>(z[i] / lengths.z);
  }
}

void append_surface(mjvScene& scene, const BodyContacts& body, std::size_t pair, double full_scale) {
  const ContactSurface& surface = body.sensed().pairs[pair].surface;
  const RigidTransform X_WM(body.sensed().X_WM);
  for (const ContactPolygon& polygon : surface.polygons) {
    const auto at = [&](int k) { return static_cast<std::size_t>(polygon.first + k); };
    for (int k = 1; k + 1 < polygon.count; ++k) {
      const double pressure = (surface.pressure[at(0)] + surface.pressure[at(k)] + surface.pressure[at(k + 1)]) / 3;
      append_triangle(scene, body, body.touched()[pair].geom,
                      {X_WM(surface.vertices[at(0)]), X_WM(surface.vertices[at(k)]), X_WM(surface.vertices[at(k + 1)])},
                      color_of(pressure / full_scale).data());
    }
  }
}

void append_force(const mjModel& m, mjvScene& scene, const BodyContacts& body, std::size_t pair) {
  const PairState& contact = body.sensed().pairs[pair];
  const RigidTransform X_WM(body.sensed().X_WM);
  const int touched_geom = body.touched()[pair].geom;
  const dvec3 from_W = X_WM(center_of_pressure(contact.surface)), force_W = X_WM.R * contact.wrench.force;
  const dvec3 to_W = from_W + force_W * (m.vis.map.force / m.stat.meanmass);
  if (!(glm::length(to_W - from_W) > mjMINVAL)) return;
  mjvGeom* geom = append(scene, body, touched_geom, m.vis.rgba.contactforce);
  if (geom == nullptr) return;
  const mjtNum from[3]{from_W.x, from_W.y, from_W.z}, to[3]{to_W.x, to_W.y, to_W.z};
  mjv_connector(geom, mjGEOM_ARROW, m.vis.scale.forcewidth * m.stat.meansize, from, to);
}

}  // namespace

double largest_pressure(const BodyContacts& body) {
  double largest = 0;
  const Evaluation& state = body.sensed();
  if (state.valid)
    for (const std::size_t pair : state.near) largest = std::max(largest, state.pairs[pair].surface.max_pressure());
  return largest;
}

void draw_contacts(const mjModel& m, const BodyContacts& body, double full_scale, const mjvOption& options,
                   mjvScene& scene) {
  const Evaluation& state = body.sensed();
  if (!state.valid || !(full_scale > 0)) return;
  for (const std::size_t pair : state.near) {
    if (state.pairs[pair].surface.empty() || body.touched()[pair].role.mirrored) continue;
    if (options.flags[mjVIS_CONTACTPOINT] != 0) append_surface(scene, body, pair, full_scale);
    if (options.flags[mjVIS_CONTACTFORCE] != 0) append_force(m, scene, body, pair);
  }
}

}  // namespace taxel
