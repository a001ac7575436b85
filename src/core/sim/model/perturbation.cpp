#include "core/sim/model/perturbation.h"

#include <algorithm>
#include <vector>

#include "core/sim/model/geometry.h"
#include "core/sim/model/mujoco_vectors.h"

namespace taxel {
namespace {

/// Orientation of a body's inertial frame, which mjvPerturb refers to.
dquat inertial_turn(const mjModel& m, const mjData& d, int body) {
  return quat(d.xquat + 4 * body) * quat(m.body_iquat + 4 * body);
}

dvec3 grabbed_point(const mjData& d, const mjvPerturb& perturb) {
  return body_pose(d, perturb.select) * vec3(perturb.localpos);
}

/// The apparent mass at a point, 3 / trace(J M^-1 J^T), as in mjv_initPerturb; 1 if nothing can move.
double mass_at(const mjModel& m, mjData& d, int body, const dvec3& p_W) {
  if (m.nv == 0) return 1;
  std::vector<mjtNum> J(3 * static_cast<std::size_t>(m.nv)), M_inv_JT(J.size());
  mj_jac(&m, &d, J.data(), nullptr, &p_W[0], body);
  mj_solveM(&m, &d, M_inv_JT.data(), J.data(), 3);
  const mjtNum trace = mju_dot(J.data(), M_inv_JT.data(), static_cast<int>(J.size()));
  return trace == 0 ? 1 : 3 / std::max(trace, mjMINVAL);
}

}  // namespace

void Perturbation::grab(const mjModel& m, mjData& d, int body, const dvec3& point_B) {
  mjv_defaultPerturb(&start_);
  start_.select = body;
  put(start_.localpos, point_B);
  const dvec3 point_W = grabbed_point(d, start_);
  put(start_.refselpos, point_W);
  put(start_.refpos, vec3(d.xipos + 3 * body));
  put(start_.refquat, inertial_turn(m, d, body));
  start_.localmass = mass_at(m, d, body, point_W);
}

bool Perturbation::follow(const mjModel& m, mjData& d, const Perturb& request, int body, const dvec3& point_B) {
  const bool again = request_.kind == request.kind && request_.grip == request.grip && start_.select == body;
  if (!again) grab(m, d, body, point_B);
  request_ = request;
  now_ = start_;
  now_.active = request.kind == Perturb::Kind::pull ? mjPERT_TRANSLATE : mjPERT_ROTATE;
  put(now_.refselpos, vec3(start_.refselpos) + request.moved_W);
  put(now_.refpos, vec3(start_.refpos) + request.moved_W);
  put(now_.refquat, glm::normalize(request.turned_W * quat(start_.refquat)));
  if (m.body_weldid[body] == 0 && m.body_mocapid[body] < 0) return false;
  mjv_applyPerturbPose(&m, &d, &now_, request.running ? 0 : 1);
  return true;
}

void Perturbation::add_force(const mjModel& m, mjData& d) const {
  if (now_.active == 0) return;
  mjv_applyPerturbPose(&m, &d, &now_, 0);
  if (m.body_weldid[now_.select] != 0) mjv_applyPerturbForce(&m, &d, &now_);
}

void Perturbation::clear_force(mjData& d) const {
  if (now_.active != 0) std::fill_n(d.xfrc_applied + 6 * now_.select, 6, 0.0);
}

std::optional<PerturbShown> Perturbation::shown(const mjModel& m, const mjData& d) const {
  if (now_.active == 0) return std::nullopt;
  return PerturbShown{request_.kind, now_.select, grabbed_point(d, now_), vec3(now_.refselpos),
                      glm::normalize(quat(now_.refquat) * glm::conjugate(inertial_turn(m, d, now_.select)))};
}

}  // namespace taxel
