// The forces of all hydroelastic pairs of one mjData, coupled through the bodies they share.
#pragma once

#include <mujoco/mujoco.h>

#include <span>
#include <vector>

#include "core/hydro/traction_points.h"
#include "core/sim/plugin/pairs/body_contacts.h"
#include "core/sim/plugin/pairs/implicit_wrenches.h"

namespace taxel {

/// Memory for apply_contact_forces, reused from step to step.
struct ContactForceWorkspace {
  /// One pair with a surface.
  struct Active {
    BodyContacts* body = nullptr;
    std::size_t pair = 0;
    TractionPoints points;
    double length = 1;          ///< size of the contact [m]
    Twist V_rub;                ///< where the search begins, then what it found
    Matrix6 inverse_inertia{};  ///< J M^-1 J^T
    std::vector<mjtNum> J;      ///< 6 x nv: relative twist of the body at M's origin, frame M
    std::vector<mjtNum> MinvJ;  ///< 6 x nv: M^-1 J^T
    std::size_t group = 0;      ///< pairs whose wrenches move each other's bodies have the same
  };
  TractionPoints felt_only;  ///< of a pair that is sensed and not applied
  std::vector<Active> active;
  std::size_t active_count = 0;
  std::vector<mjtNum> force, acceleration, jacobian;
  std::vector<Matrix6> responses;    ///< J_i M^-1 J_j^T of active pairs, by rows of i
  std::vector<std::size_t> members;  ///< of a group
  ImplicitWrenches wrenches;
};

/// Evaluates the bodies that apply forces, solves for all wrenches with the velocities of the end of the step, keeps
/// each in its PairState and adds it to qfrc_passive of both bodies. To be called once per PASSIVE stage; M is factored
/// then. `late_forces` (nv values) are the generalized forces that MuJoCo computes only later, taken from the step
/// before: constraints and actuators.
///
/// Pairs whose wrenches move each other's bodies are solved together (implicit_wrenches.h).
/// Bodies asleep get no force; bodies of touching pairs are kept from falling asleep.
void apply_contact_forces(const mjModel& m, mjData& d, std::span<BodyContacts* const> bodies,
                          std::span<const mjtNum> late_forces, ContactForceWorkspace& work);

}  // namespace taxel
