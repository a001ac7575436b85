// Contact surfaces and forces as decorative geoms of MuJoCo's visualizer, for any viewer that calls mjv_updateScene().
#pragma once

#include <mujoco/mujoco.h>

#include "core/sim/plugin/pairs/body_contacts.h"

namespace taxel {

/// Returns the largest elastic pressure of the surfaces of the sensed state [Pa], 0 without contact.
double largest_pressure(const BodyContacts& body);

/// Appends the sensed state of a body to the scene, if the options ask for it:
/// - mjVIS_CONTACTPOINT: the contact surfaces as triangles, coloured by the elastic pressure from 0 (blue) to
///   `full_scale` [Pa] (red);
/// - mjVIS_CONTACTFORCE: an arrow from the centre of pressure of each surface, as long as MuJoCo's own arrows: |force|
/// *
///   visual.map.force / stat.meanmass.
/// Leaves out pairs that a partner computes. Sets the scene's status to 1, as MuJoCo does, if it has no room left.
void draw_contacts(const mjModel& m, const BodyContacts& body, double full_scale, const mjvOption& options,
                   mjvScene& scene);

}  // namespace taxel
