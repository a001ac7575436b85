// MuJoCo's arrays of numbers as our vectors, and back.
#pragma once

#include <mujoco/mujoco.h>

#include "core/base/math.h"

namespace taxel {

inline dvec3 vec3(const mjtNum* p) {
  return {p[0], p[1], p[2]};
}
/// w x y z, as MuJoCo orders them.
inline dquat quat(const mjtNum* q) {
  return {q[0], q[1], q[2], q[3]};
}
inline void put(mjtNum* out, const dvec3& v) {
  for (int i = 0; i < 3; ++i) out[i] = v[i];
}
inline void put(mjtNum* out, const dquat& q) {
  out[0] = q.w, out[1] = q.x, out[2] = q.y, out[3] = q.z;
}

}  // namespace taxel
