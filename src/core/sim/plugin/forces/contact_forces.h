// Computation of the forces of all hydroelastic pairs of one mjData, coupled through the bodies that the pairs share.
#pragma once

#include <mujoco/mujoco.h>

#include <span>
#include <vector>

#include "core/hydro/contact_stiffness.h"
#include "core/hydro/traction_points.h"
#include "core/sim/plugin/forces/implicit_wrenches.h"
#include "core/sim/plugin/forces/stiff_servos.h"
#include "core/sim/plugin/pairs/body_contacts.h"

namespace taxel {

/// Memory of apply_contact_forces(), reused from step to step.
struct ContactForceWorkspace {
  /// One pair with a surface.
  struct Active {
    BodyContacts* body = nullptr;
    std::size_t pair = 0;
    TractionPoints points;
    StiffnessBound bound;
    double share = 1;           ///< part of the wrench that is applied (explicit_step.h)
    double length = 1;          ///< size of the contact [m]
    Twist V_rub;                ///< start of the search for the twist of the wrench, then its result
    Matrix6 inverse_inertia{};  ///< J M^-1 J^T, M with the damping of stiff servos
    std::vector<mjtNum> J;      ///< 6 x nv: relative twist of the body at M's origin, frame M
    std::vector<mjtNum> MinvJ;  ///< 6 x nv: M^-1 J^T
    std::size_t group = 0;      ///< number of the group; the wrenches of a group move each other's bodies
  };
  Active felt_only;  ///< pair that is sensed and not applied
  std::vector<Active> active;
  std::size_t active_count = 0;
  std::vector<BodyContacts*> near;  ///< bodies that are near to a geom
  std::vector<mjtNum> force, acceleration, jacobian;
  std::vector<Matrix6> responses;    ///< J_i M^-1 J_j^T of active pairs i and j, row by row
  std::vector<std::size_t> members;  ///< active pairs of one group
  ImplicitWrenches wrenches;
  StiffServos servos;
};

/// Evaluates the bodies that apply forces, solves for all wrenches with the velocities at the end of the step, stores
/// each wrench in its PairState, and adds it to qfrc_passive of both bodies. Must be called once in each PASSIVE stage;
/// the inertia matrix M is already factored there. `late_forces` (nv values) are the generalized forces of constraints
/// and actuators, which MuJoCo computes only later; their values are those of the previous step. If has_stiff_servos(),
/// they are those of constraints alone, and actuators are computed here (stiff_servos.h).
///
/// Pairs whose wrenches move each other's bodies are solved together (implicit_wrenches.h). Sleeping bodies get no
/// force; bodies of touching pairs are prevented from falling asleep.
void apply_contact_forces(const mjModel& m, mjData& d, std::span<BodyContacts* const> bodies,
                          std::span<const mjtNum> late_forces, ContactForceWorkspace& work);

}  // namespace taxel
