#include "core/sim/plugin/pairs/sleeping.h"

namespace taxel {

#if mjVERSION_HEADER >= 3008000

bool is_asleep(const mjModel& m, const mjData& d, int body) {
  return m.body_treeid[body] >= 0 && d.body_awake[body] == mjS_ASLEEP;
}

namespace {

/// Returns true if a body may move without our forces: it is awake, or fixed to a mocap body.
bool may_move(const mjModel& m, const mjData& d, int body) {
  return m.body_mocapid[m.body_rootid[body]] >= 0 || (m.body_treeid[body] >= 0 && d.body_awake[body] == mjS_AWAKE);
}

}  // namespace

void keep_awake(const mjModel& m, mjData& d, int body, int toucher) {
  constexpr mjtNum kUnfelt = 1e-200;  // m/s or rad/s
  const int tree = m.body_treeid[body];
  if (tree < 0 || (m.opt.enableflags & mjENBL_SLEEP) == 0) return;
  if (d.tree_asleep[tree] < 0) {
    d.tree_asleep[tree] = -(1 + mjMINAWAKE);
  } else if (may_move(m, d, toucher)) {
    d.qvel[m.tree_dofadr[tree]] = kUnfelt;
  }
}

#else  // MuJoCo 3.3, whose version numbers have three digits, so that all of them are smaller

bool is_asleep(const mjModel&, const mjData&, int) {
  return false;
}

void keep_awake(const mjModel&, mjData&, int, int) {}

#endif

}  // namespace taxel
