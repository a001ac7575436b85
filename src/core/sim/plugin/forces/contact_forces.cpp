// The forces of all hydroelastic pairs of one mjData in one PASSIVE stage.
//
// 1. Each pair with a surface gets the Jacobian J of its relative twist and M^-1 J^T; M contains the damping of stiff
//    servos (stiff_servos.h).
// 2. All other forces give the twist of each pair at the end of the step without the pairs.
// 3. Pairs whose wrenches move each other's bodies, J_i M^-1 J_j^T not 0, form a group, and each group is one system of
//    equations (implicit_wrenches.h).
// 4. A pair that ends in this step may give back no more energy than it holds (explicit_step.h): its share is lowered
//    and the group is solved again, at most four times.
// 5. Wrenches are added to qfrc_passive of both bodies, and bodies that touch are kept awake.
//
// Cost: a solution with M for six columns per pair, and evaluations of the laws, each over the points of a surface.
// Most checks of the time step and of the energy end with a bound that costs little. Pitfalls: constraints and
// actuators come later in MuJoCo's step, so their forces are those of the previous step; sensed pairs that apply no
// force are no part of a group. Theory: docs/theory/sim.md.
#include "core/sim/plugin/forces/contact_forces.h"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <functional>

#include "core/base/math.h"
#include "core/base/stopwatch.h"
#include "core/hydro/contact_stiffness.h"
#include "core/sim/plugin/forces/explicit_step.h"
#include "core/sim/plugin/pairs/pair_warnings.h"
#include "core/sim/plugin/side_by_side.h"

namespace taxel {
namespace {

/// Returns true if the body sleeps. A sleeping body gets no force.
bool is_asleep(const mjModel& m, const mjData& d, int body);

/// Keeps the tree of a body awake while a moving body touches it. MuJoCo does not know our contacts: a tree falls
/// asleep after mjMINAWAKE quiet steps, counted in tree_asleep from -(1 + mjMINAWAKE) up to -1. A tree that already
/// sleeps gets a velocity too small to change any number of the simulation. At the beginning of the next step MuJoCo
/// wakes each tree that has a velocity, with all trees that fell asleep together with it.
void keep_awake(const mjModel& m, mjData& d, int body, int toucher);

#if mjVERSION_HEADER >= 3008000

bool is_asleep(const mjModel& m, const mjData& d, int body) {
  return m.body_treeid[body] >= 0 && d.body_awake[body] == mjS_ASLEEP;
}

/// Returns true if a body may move without our forces: it is awake, or fixed to a mocap body.
bool may_move(const mjModel& m, const mjData& d, int body) {
  return m.body_mocapid[m.body_rootid[body]] >= 0 || (m.body_treeid[body] >= 0 && d.body_awake[body] == mjS_AWAKE);
}

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

using Active = ContactForceWorkspace::Active;

constexpr int kMostReleaseRounds = 4;  // solutions of a group with lower shares

std::size_t size(int n) {
  return static_cast<std::size_t>(n);
}

PairState& state_of(Active& a) {
  return a.body->latest().pairs[a.pair];
}
int first_body(const mjModel& m, const Active& a) {
  return m.geom_bodyid[a.body->settings().geom];
}
int other_body(const mjModel& m, const Active& a) {
  return m.geom_bodyid[a.body->touched()[a.pair].geom];
}

/// Computes the Jacobian J of the relative twist, in frame M at M's origin, and A = J M^-1 J^T (6 x 6).
void fill_dynamics(const mjModel& m, mjData& d, ContactForceWorkspace& work, Active& a) {
  const std::size_t nv = size(m.nv);
  const Evaluation& e = a.body->latest();
  const mjtNum origin[3] = {e.X_WM.p.x, e.X_WM.p.y, e.X_WM.p.z};
  work.jacobian.resize(12 * nv);
  mjtNum* sensor = work.jacobian.data();
  mjtNum* other = sensor + 6 * nv;
  mj_jac(&m, &d, sensor, sensor + 3 * nv, origin, first_body(m, a));
  mj_jac(&m, &d, other, other + 3 * nv, origin, other_body(m, a));
  const dmat3 R_WM = e.X_WM.rotation();
  a.J.resize(6 * nv);
  for (std::size_t half = 0; half < 2; ++half) {
    for (std::size_t j = 0; j < nv; ++j) {
      dvec3 column_W;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t at = (3 * half + i) * nv + j;
        column_W[static_cast<int>(i)] = sensor[at] - other[at];
      }
      const dvec3 column = column_W * R_WM;  // R^T v
      for (std::size_t i = 0; i < 3; ++i) a.J[(3 * half + i) * nv + j] = column[static_cast<int>(i)];
    }
  }
  a.MinvJ.resize(6 * nv);
  work.servos.solve(m, d, a.MinvJ.data(), a.J.data(), 6);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      a.inverse_inertia[i][j] = mju_dot(a.J.data() + i * nv, a.MinvJ.data() + j * nv, m.nv);
}

/// Computes the acceleration M^-1 f without the pairs: f is the sum of the passive forces so far, the applied and bias
/// forces, and `late_forces`.
void free_acceleration(const mjModel& m, mjData& d, std::span<const mjtNum> late_forces, ContactForceWorkspace& work) {
  work.force.resize(size(m.nv));
  work.acceleration.resize(size(m.nv));
  mjtNum* f = work.force.data();
  mj_rne(&m, &d, 0, f);
  for (int i = 0; i < m.nv; ++i) f[i] = d.qfrc_passive[i] + d.qfrc_applied[i] + late_forces[size(i)] - f[i];
  for (int b = 1; b < m.nbody; ++b) {
    const mjtNum* x = d.xfrc_applied + 6 * b;
    if (std::any_of(x, x + 6, [](mjtNum v) { return v != 0; })) mj_applyFT(&m, &d, x, x + 3, d.xipos + 3 * b, b, f);
  }
  if (work.servos.active())
    for (int i = 0; i < m.nv; ++i) f[i] += d.qfrc_actuator[i];
  work.servos.solve(m, d, work.acceleration.data(), f, 1);
}

/// Returns the pair's twist at the end of the step without the wrenches of the pairs.
Twist free_twist(const mjModel& m, const ContactForceWorkspace& work, Active& a) {
  const PairState& pair = state_of(a);
  std::array<double, 6> rate{};
  mju_mulMatVec(rate.data(), a.J.data(), work.acceleration.data(), 6, m.nv);
  const double h = m.opt.timestep;
  return {pair.V.linear + h * dvec3(rate[0], rate[1], rate[2]), pair.V.angular + h * dvec3(rate[3], rate[4], rate[5])};
}

/// Reduces the surface of a pair for evaluations of its law.
void set_law(const mjModel& m, mjData& d, BodyContacts& body, std::size_t pair, Active& a) {
  a.body = &body;
  a.pair = pair;
  a.share = 1;
  a.points.assign(state_of(a).surface);
  a.bound = stiffness_bound(state_of(a).surface);
  if (body.bristles() != nullptr) read_bristles(m, d, body, pair);
}

Traction whole_law_of(const mjModel& m, const Active& a, const Twist& V) {
  PairProperties properties = a.body->touched()[a.pair].properties;
  if (a.body->bristles() == nullptr) return a.points.evaluate(properties, V);
  properties.friction = 0;
  Traction sum = a.points.evaluate(properties, V);
  a.body->bristles()->contact(a.pair).add_friction(bristle_law(*a.body, a.pair, m.opt.timestep), V, sum);
  return sum;
}

Traction law_of(const mjModel& m, const Active& a, const Twist& V) {
  Traction t = whole_law_of(m, a, V);
  if (a.share == 1) return t;
  for (Wrench* w : {&t.elastic, &t.wrench}) {
    w->force *= a.share;
    w->torque *= a.share;
  }
  for (auto& row : t.secant)
    for (double& x : row) x *= a.share;
  return t;
}

void keep(const mjModel& m, Active& a, const Wrench& wrench, const Twist& V_end) {
  PairState& pair = state_of(a);
  pair.implicit_step = m.opt.timestep;
  pair.wrench = wrench;
  pair.V_rub = V_end;
  a.V_rub = V_end;
}

/// Returns J_i M^-1 J_j^T.
Matrix6 response(const mjModel& m, const Active& i, const Active& j) {
  Matrix6 A{};
  const std::size_t nv = size(m.nv);
  for (std::size_t r = 0; r < 6; ++r)
    for (std::size_t c = 0; c < 6; ++c) A[r][c] = mju_dot(i.J.data() + r * nv, j.MinvJ.data() + c * nv, m.nv);
  return A;
}

bool moves(const Matrix6& A) {
  return std::any_of(A.begin(), A.end(), [](const auto& row) {
    return std::any_of(row.begin(), row.end(), [](double x) { return x != 0; });
  });
}

/// Groups the pairs: pairs whose wrenches move each other's bodies, directly or through other pairs, are in one group.
/// Fills work.responses.
void group_pairs(const mjModel& m, ContactForceWorkspace& work) {
  const std::span<Active> active(work.active.data(), work.active_count);
  work.responses.resize(active.size() * active.size());
  for (std::size_t i = 0; i < active.size(); ++i) {
    active[i].group = i;
    work.responses[i * active.size() + i] = active[i].inverse_inertia;
    for (std::size_t j = 0; j < i; ++j) {
      const Matrix6 A = response(m, active[i], active[j]);
      work.responses[i * active.size() + j] = A;
      work.responses[j * active.size() + i] = transposed(A);
      const std::size_t theirs = active[j].group, ours = active[i].group;
      if (theirs == ours || !moves(A)) continue;
      for (Active& a : active)
        if (a.group == ours) a.group = theirs;
    }
  }
}

/// Returns the elastic energy that a pair holds [J].
double held_energy(Active& a) {
  const PairState& pair = state_of(a);
  const Pose X_MB = a.body->latest().X_WM.inverse() * pair.X_WB;
  return elastic_energy(pair.surface, *a.body->body(), *a.body->touched()[a.pair].body, RigidTransform(X_MB));
}

/// Lowers the share of a pair that would give back more energy than it has. Returns true if it did.
bool limit_release(const mjModel& m, Active& a, const ImplicitWrenches::Pair& solved) {
  constexpr double kNearly = 1 - 1e-4;  // a share above it changes nothing that matters
  const double h = m.opt.timestep;
  const Wrench& elastic = a.points.pressure_wrench();
  if (!(power(elastic, solved.V_end) > 0)) return false;  // does not end in this step
  const Twist& V = state_of(a).V;
  // A spring of stiffness k that pushes with F holds F^2/(2 k). Most steps give back far less.
  constexpr double kFar = 0.05;
  const double held = 0.5 * glm::dot(elastic.force, elastic.force) / a.bound.linear;
  if (0.5 * h * (std::abs(power(solved.wrench, V)) + power(solved.wrench, solved.V_end)) < kFar * held) return false;
  const double left = held_energy(a) + 0.5 * h * power(elastic, V);
  const double share = release_share(left, solved.wrench, V, solved.V_end, a.inverse_inertia, h);
  if (share > kNearly) return false;
  a.share *= share;
  return true;
}

/// Solves all members of a group together. Wrenches of other groups do not move the bodies of this group.
void solve_group(const mjModel& m, ContactForceWorkspace& work) {
  const std::vector<std::size_t>& members = work.members;
  ImplicitWrenches& wrenches = work.wrenches;
  wrenches.begin(members.size(), m.opt.timestep);
  for (std::size_t i = 0; i < members.size(); ++i) {
    Active& a = work.active[members[i]];
    wrenches.pair(i) = {a.V_rub, free_twist(m, work, a), a.length, {}, {}};
  }
  for (std::size_t i = 0; i < members.size(); ++i)
    for (std::size_t j = 0; j < members.size(); ++j)
      wrenches.set_inverse_inertia(i, j, work.responses[members[i] * work.active_count + members[j]]);
  const auto law = [&](std::size_t i, const Twist& V) { return law_of(m, work.active[members[i]], V); };
  for (int round = 0;; ++round) {
    wrenches.solve(std::cref(law));  // a copy of its three references would be on the heap
    if (round == kMostReleaseRounds || m.opt.integrator == mjINT_RK4) break;
    bool limited = false;
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (limit_release(m, work.active[members[i]], wrenches.pair(i))) limited = true;
      wrenches.pair(i).V_start = wrenches.pair(i).V_end;
    }
    if (!limited) break;
  }
  for (std::size_t i = 0; i < members.size(); ++i)
    keep(m, work.active[members[i]], wrenches.pair(i).wrench, wrenches.pair(i).V_end);
}

void apply(const mjModel& m, mjData& d, Active& a) {
  const Evaluation& e = a.body->latest();
  const PairState& pair = state_of(a);
  const dvec3 force = e.X_WM.rotate(pair.wrench.force), torque = e.X_WM.rotate(pair.wrench.torque);
  const mjtNum origin[3] = {e.X_WM.p.x, e.X_WM.p.y, e.X_WM.p.z};
  const mjtNum f[3] = {force.x, force.y, force.z}, t[3] = {torque.x, torque.y, torque.z};
  const mjtNum minus_f[3] = {-force.x, -force.y, -force.z}, minus_t[3] = {-torque.x, -torque.y, -torque.z};
  if (!is_asleep(m, d, first_body(m, a))) mj_applyFT(&m, &d, f, t, origin, first_body(m, a), d.qfrc_passive);
  if (!is_asleep(m, d, other_body(m, a)))
    mj_applyFT(&m, &d, minus_f, minus_t, origin, other_body(m, a), d.qfrc_passive);
  keep_awake(m, d, first_body(m, a), other_body(m, a));
  keep_awake(m, d, other_body(m, a), first_body(m, a));
}

/// Checks that the time step is stable: friction and damping are implicit, but the stiffness is explicit. A cheap bound
/// is sufficient for most pairs. Beyond it a pair is checked when its bound has grown, and at every eighth step,
/// because a check takes up to a fifth of the time of a step.
void check_step(const mjModel& m, Active& a) {
  if (a.body->checks[a.pair].step_too_large) return;
  const PairState& pair = state_of(a);
  const double h = m.opt.timestep;
  const Matrix6& A = a.inverse_inertia;
  const double reach = a.bound.reach + a.length;  // corners are farther out than centroids
  const double stiffest = stiffest_mode_bound(A, a.bound.linear, reach);
  if (h * h * stiffest < kStepLimit || !is_step_check_due(a.body->checks[a.pair], stiffest)) return;
  const Pose X_MB = a.body->latest().X_WM.inverse() * pair.X_WB;
  Matrix6 K = contact_stiffness(pair.surface, *a.body->body(), *a.body->touched()[a.pair].body, RigidTransform(X_MB));
  PairProperties smooth = a.body->touched()[a.pair].properties;
  smooth.friction = 0;  // it steadies only motion that is slower than its regularisation
  const Matrix6 S = a.points.evaluate(smooth, a.V_rub).secant;
  if (largest_stable_step({A, K, S}, h) == h) return;
  const double growth = stiffness_growth(held_energy(a), a.points.pressure_wrench(), pair.V, A);
  for (auto& row : K)
    for (double& x : row) x *= growth;
  warn_of_pair(m, *a.body, a.pair, &PairChecks::step_too_large,
               fmt::format("is too stiff for the time step of {:.4g} s: up to the depth that their motion "
                           "leads to, the largest stable step is {:.3g} s",
                           h, largest_stable_step({A, K, S}, h)));
}

/// Warns of a contact whose force is no gradient of an energy, since back faces are left out, and that loses too little
/// energy to hide it.
void check_back_faces(const mjModel& m, Active& a) {
  constexpr double kShare = 0.01;       // of the force, of back faces that count
  constexpr double kDissipation = 0.5;  // [s/m]; with it no one of 500 tumbling boxes gained energy, with 0.1 four did
  const TouchedGeom& touched = a.body->touched()[a.pair];
  if (a.body->checks[a.pair].undamped_back || touched.properties.dissipation >= kDissipation) return;
  const double left_out = state_of(a).surface.left_out(Rejection::back_face).force;
  if (left_out <= kShare * glm::length(a.points.pressure_wrench().force) || !moves(a.inverse_inertia)) return;
  warn_of_pair(m, *a.body, a.pair, &PairChecks::undamped_back,
               fmt::format("leaves out back faces, so its force is not the gradient of an energy, and with a "
                           "dissipation of {:.3g} s/m its bodies may gain energy: give the soft one at least "
                           "{} s/m",
                           touched.properties.dissipation, kDissipation));
}

/// Computes all surfaces of the present state.
void evaluate_bodies(const mjModel& m, mjData& d, std::span<BodyContacts* const> bodies, ContactForceWorkspace& work) {
  std::size_t polygons = 0;  // of the step before
  work.near.clear();
  for (BodyContacts* body : bodies) {
    for (const std::size_t i : body->latest().near) polygons += body->latest().pairs[i].surface.polygons.size();
    body->begin_evaluation(m, d);
    if (body->latest().near.empty())
      body->compute_surfaces();
    else
      work.near.push_back(body);
  }
  side_by_side(work.near.size(), polygons, [&](std::size_t i) { work.near[i]->compute_surfaces(); });
}

/// Collects all pairs that have a surface, with their dynamics.
void collect(const mjModel& m, mjData& d, std::span<BodyContacts* const> bodies, ContactForceWorkspace& work) {
  work.active_count = 0;
  evaluate_bodies(m, d, bodies, work);
  for (BodyContacts* body : bodies) {
    Evaluation& e = body->latest();
    const Stopwatch watch(body->times.forces);
    for (const std::size_t i : e.near) {
      if (e.pairs[i].surface.empty()) continue;
      if (!body->touched()[i].role.applies) {
        set_law(m, d, *body, i, work.felt_only);
        e.pairs[i].wrench = law_of(m, work.felt_only, e.pairs[i].V).wrench;
        e.pairs[i].implicit_step = m.opt.timestep;
        continue;
      }
      if (work.active_count == work.active.size()) work.active.emplace_back();
      Active& a = work.active[work.active_count++];
      set_law(m, d, *body, i, a);
      a.length = body->length(i);
      a.V_rub = e.pairs[i].V;
      fill_dynamics(m, d, work, a);
    }
  }
}

}  // namespace

void apply_contact_forces(const mjModel& m, mjData& d, std::span<BodyContacts* const> bodies,
                          std::span<const mjtNum> late_forces, ContactForceWorkspace& work) {
  work.servos.set(m, d);
  collect(m, d, bodies, work);
  if (work.active_count == 0) return;
  const Stopwatch watch(work.active.front().body->times.forces);  // the first body is charged for all pairs
  const std::span<Active> active(work.active.data(), work.active_count);
  free_acceleration(m, d, late_forces, work);
  group_pairs(m, work);
  for (std::size_t group = 0; group < active.size(); ++group) {
    work.members.clear();
    for (std::size_t k = 0; k < active.size(); ++k)
      if (active[k].group == group) work.members.push_back(k);
    if (!work.members.empty()) solve_group(m, work);
  }
  for (Active& a : active) {
    check_step(m, a);
    check_back_faces(m, a);
    apply(m, d, a);
  }
}

}  // namespace taxel
