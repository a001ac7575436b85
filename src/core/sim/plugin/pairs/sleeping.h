// Bodies that MuJoCo lets fall asleep. In MuJoCo 3.3 no body sleeps.
#pragma once

#include <mujoco/mujoco.h>

namespace taxel {

/// Returns true if the body sleeps. A sleeping body gets no force.
bool is_asleep(const mjModel& m, const mjData& d, int body);

/// Keeps the tree of a body awake while a moving body touches it. MuJoCo does not know our contacts: a tree falls
/// asleep after mjMINAWAKE quiet steps, counted in tree_asleep from -(1 + mjMINAWAKE) up to -1. A tree that already
/// sleeps gets a velocity too small to change any number of the simulation. At the beginning of the next step MuJoCo
/// wakes each tree that has a velocity, with all trees that fell asleep together with it.
void keep_awake(const mjModel& m, mjData& d, int body, int toucher);

}  // namespace taxel
