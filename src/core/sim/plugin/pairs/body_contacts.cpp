// The contacts of one body: which geoms are near, their surfaces, and the results that are kept.
//
// Broad phase. Each geom has a bounding sphere about its origin, and a half-space has none; a comparison of centres
// finds the pairs that may touch. Of these, pairs whose bounding boxes are apart are left out: the links of a hand are
// long, and most of those that lie side by side never touch. Spheres and boxes are enlarged by more than rounding, so
// no contact is lost. A geom whose body is unknown has no reach.
//
// Results. MuJoCo calls the plugin in the PASSIVE stage, where forces are applied, and in the SENSOR stage, which may
// have another state. Two slots hold an evaluation each, so the values that were sensed last stay valid while the next
// step is evaluated. A SENSOR stage at the same poses and velocities takes the surfaces and wrenches of the PASSIVE
// stage, bit by bit; otherwise it evaluates again.
//
// Of two declared bodies one computes the surface, and the other mirrors it: the same polygons in its own frame, with
// the opposite wrench. Pitfall: bodies are compiled at different times, so partners are linked when both exist.
#include "core/sim/plugin/pairs/body_contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "core/hydro/hydro_body.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/pairs/declared_bodies.h"
#include "core/sim/plugin/pairs/geom_body.h"

namespace taxel {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNothing = -kInfinite;
/// Factor that enlarges the bounds. The enlargement is far above the rounding errors of positions and bounds.
constexpr double kSlack = 1 + 1e-9;

/// Returns the radius of the bounding sphere about the geom's origin.
double bounding_radius(std::span<const dvec3> vertices_B, const RigidTransform& X_GB) {
  double farthest = 0;
  for (const dvec3& v_B : vertices_B) {
    const dvec3 v = X_GB(v_B);
    farthest = std::max(farthest, glm::dot(v, v));
  }
  return kSlack * std::sqrt(farthest);
}

/// Returns true if a sphere reaches below the plane z = 0 of a geom.
bool reaches(const mjData& d, int geom, const dvec3& center_W, double radius) {
  const mjtNum *p = d.geom_xpos + 3 * geom, *R = d.geom_xmat + 9 * geom;
  return glm::dot(center_W - dvec3(p[0], p[1], p[2]), dvec3(R[2], R[5], R[8])) <= radius;
}

}  // namespace

void BroadPhase::clear() {
  geoms_.clear();
  radii_.clear();
}

void BroadPhase::add(int geom) {
  geoms_.push_back(geom);
  radii_.push_back(kNothing);
}

void BroadPhase::set_body(std::size_t number, const HydroBody& body, const Pose& X_GB) {
  double& radius = radii_[number];
  radius = kInfinite;
  if (const auto* soft = std::get_if<SoftBody>(&body.geometry))
    radius = bounding_radius(soft->field->vertices(), RigidTransform(X_GB));
  if (const auto* rigid = std::get_if<RigidMesh>(&body.geometry))
    radius = bounding_radius(rigid->index->mesh().vertices(), RigidTransform(X_GB));
}

void BroadPhase::remove_body(std::size_t number) {
  radii_[number] = kNothing;
}

void BroadPhase::find(const mjData& d, const dvec3& center_W, double radius, std::vector<std::size_t>& near) const {
  near.clear();
  radius *= kSlack;
  for (std::size_t i = 0; i < geoms_.size(); ++i) {
    const double reach = radius + radii_[i];
    const mjtNum* p = d.geom_xpos + 3 * geoms_[i];
    const double x = p[0] - center_W.x, y = p[1] - center_W.y, z = p[2] - center_W.z;
    if (!(std::abs(x) <= reach) || x * x + y * y + z * z > reach * reach) continue;
    if (reach < kInfinite || reaches(d, geoms_[i], center_W, radius)) near.push_back(i);
  }
}

namespace {

bool same(const Pose& a, const Pose& b) {
  return a.q == b.q && a.p == b.p;
}
bool same(const Twist& a, const Twist& b) {
  return a.linear == b.linear && a.angular == b.angular;
}

/// Returns the velocity of a body at the world point p, world axes.
Twist body_twist(const mjModel& m, const mjData& d, int body, const dvec3& p_W) {
  mjtNum v[6];  // angular, then linear velocity at the origin of the body frame
  mj_objectVelocity(&m, &d, mjOBJ_XBODY, body, v, 0);
  const dvec3 w(v[0], v[1], v[2]), origin(d.xpos[3 * body], d.xpos[3 * body + 1], d.xpos[3 * body + 2]);
  return {dvec3(v[3], v[4], v[5]) + glm::cross(w, p_W - origin), w};
}

void check_one_soft(const HydroBody& a, const HydroBody& b, bool sensor) {
  if (a.soft() || b.soft()) return;
  throw Error(fmt::format("{} and geom \"{}\" are both rigid: one of them must be soft",
                          sensor ? "sensor" : fmt::format("geom \"{}\"", a.name), b.name));
}

/// Returns the bounds of a body in its own frame; empty for a half-space.
Aabb box_of(const HydroBody& body) {
  Aabb box;
  if (const auto* soft = std::get_if<SoftBody>(&body.geometry))
    for (const dvec3& v : soft->field->vertices()) box.include(v);
  if (const auto* rigid = std::get_if<RigidMesh>(&body.geometry)) box = rigid->index->mesh().bounds();
  return box;
}

/// Returns true if two boxes have no point in common, by the separating axes of Gottschalk et al. (1996). X_AB is the
/// pose of b's frame in a's frame. Boxes that nearly touch are not apart.
bool are_apart(const Aabb& a, const Aabb& b, const Pose& X_AB) {
  const double slack = 1e-9 * (a.diagonal() + b.diagonal());
  const dvec3 half_a = 0.5 * a.extent() + slack, half_b = 0.5 * b.extent() + slack;
  const RigidTransform X(X_AB);
  const dvec3 t = X(b.center()) - a.center();
  const auto reach = [&](const dvec3& axis) {  // of both boxes along the axis
    const dvec3 in_b = axis * X.R;
    return glm::dot(glm::abs(axis), half_a) + glm::dot(glm::abs(in_b), half_b);
  };
  const auto separates = [&](const dvec3& axis) { return std::abs(glm::dot(axis, t)) > reach(axis); };
  for (int i = 0; i < 3; ++i) {
    dvec3 of_a(0);
    of_a[i] = 1;
    if (separates(of_a) || separates(X.R[i])) return true;
    for (int j = 0; j < 3; ++j)
      if (separates(glm::cross(of_a, X.R[j]))) return true;  // of parallel edges 0, which separates nothing
  }
  return false;
}

/// Returns the wrench on body B, about the origin and in the axes of B, that reacts to a wrench on body A.
Wrench reaction(const Wrench& on_A, const RigidTransform& X_BA) {
  const dvec3 force = -(X_BA.R * on_A.force);
  return {force, -(X_BA.R * on_A.torque) + glm::cross(X_BA.p, force)};
}

/// Converts the velocity of B relative to A (at B's origin, in B's axes) into the velocity of A relative to B (at A's
/// origin, in A's axes).
Twist reversed(const Twist& of_B, const RigidTransform& X_AB) {
  const dvec3 A_in_B = X_AB.inverse_point(dvec3(0));
  return {-(X_AB.R * (of_B.linear + glm::cross(of_B.angular, A_in_B))), -(X_AB.R * of_B.angular)};
}

/// Returns the key that names the touched geoms, for errors.
const char* key_of_others(const DeclaredBody& body) {
  return body.sensor ? "others" : "pairs";
}

/// Sets the properties of a touched geom that depend on both bodies.
void set_properties(const HydroBody& body, TouchedGeom& touched) {
  touched.properties = combine(body.material, touched.body->material);
  touched.inner = inner_point(*touched.body);
  touched.box = box_of(*touched.body);
  if (body.half_space()) touched.half_diagonal = 0.5 * touched.box.diagonal();
}

void clear_pairs(Evaluation& e) {
  for (const std::size_t i : e.near) {
    e.pairs[i].wrench = {};
    e.pairs[i].surface.clear();
    e.pairs[i].sticking.roots.clear();
  }
  e.near.clear();
}

/// Returns the bristles' part of plugin_state.
std::span<mjtNum> bristle_state(const mjModel& m, mjData& d, const BodyContacts& body) {
  const auto [instance, number] = body.id();
  const auto size = static_cast<std::size_t>(bristle_state_size(body.settings().bristles, m.ngeom));
  const std::size_t late = body.settings().apply ? static_cast<std::size_t>(m.nv) : 0;
  const std::size_t begin = late + static_cast<std::size_t>(number) * size;
  const std::span all(d.plugin_state + m.plugin_stateadr[instance],
                      static_cast<std::size_t>(m.plugin_statenum[instance]));
  if (begin + size > all.size())
    throw Error("", "bristles", "need more state than the model was compiled with: compile it again");
  return all.subspan(begin, size);
}

}  // namespace

BodyContacts::BodyContacts(BodyId id, std::vector<DeclaredBody> declared) : declared_(std::move(declared)) {
  while (declared_.at(self_).id != id) ++self_;
}

void BodyContacts::set_body(const mjModel& m, HydroBodyPtr body, const Aabb& bounds_M, const Pose& X_GM) {
  body_ = std::move(body);
  X_GM_ = X_GM;
  bounds_M_ = {dvec3(0), kInfinite, {}};
  if (!body_->half_space()) {
    bounds_M_ = {bounds_M.center(), 0.5 * bounds_M.diagonal(), box_of(*body_)};
    bounds_M_.box.include(bounds_M);
  }
  inner_M_ = inner_point(*body_);
  bristles_.reset();
  if (settings().bristles.has_bristles()) bristles_.emplace(*body_, settings().bristles);
  compile_others(m);
  reset();
}

BristleLaw bristle_law(const BodyContacts& body, std::size_t pair, double timestep) {
  return {body.settings().bristles.stiffness, body.touched()[pair].properties, timestep, kBristleTime};
}

const BristleContact& read_bristles(const mjModel& m, mjData& d, BodyContacts& body, std::size_t pair) {
  const Evaluation& e = body.latest();
  body.bristles()->read(pair, e.pairs[pair].surface, body.touched()[pair].geom, e.X_WM.inverse() * e.pairs[pair].X_WB,
                        bristle_state(m, d, body));
  return body.bristles()->contact(pair);
}

namespace {

/// Computes the wrench of a pair at its present velocity, without a step.
Traction present_traction(const mjModel& m, mjData& d, BodyContacts& body, std::size_t pair) {
  const PairState& state = body.latest().pairs[pair];
  PairProperties properties = body.touched()[pair].properties;
  if (body.bristles() == nullptr) return traction(state.surface, properties, state.V);
  properties.friction = 0;
  Traction sum = traction(state.surface, properties, state.V);
  read_bristles(m, d, body, pair).add_friction(bristle_law(body, pair, 0), state.V, sum);
  return sum;
}

/// Stores the friction of the bristles of latest(), from the same law as its wrenches.
void keep_sticking(const mjModel& m, mjData& d, BodyContacts& body) {
  if (body.bristles() == nullptr) return;
  Evaluation& e = body.latest();
  for (const std::size_t i : e.near) {
    PairState& pair = e.pairs[i];
    if (pair.surface.empty() || body.touched()[i].role.mirrored) continue;
    pair.sticking = sticking_friction(read_bristles(m, d, body, i), body.bristles()->skin(),
                                      bristle_law(body, i, pair.implicit_step), pair.V_rub);
  }
}

}  // namespace

void advance_bristles(const mjModel& m, mjData& d, BodyContacts& body) {
  SkinBristles* bristles = body.bristles();
  if (bristles == nullptr || body.body() == nullptr || !body.failure.empty() || !body.is_fresh(m, d)) return;
  const Evaluation& e = body.latest();
  const std::span<mjtNum> state = bristle_state(m, d, body);
  bristles->begin(state.size());
  // The last stage of Runge and Kutta is at the end of the step, the only stage of other integrators at its beginning.
  const bool at_end = m.opt.integrator == mjINT_RK4;
  for (const std::size_t i : e.near) {
    if (e.pairs[i].surface.empty() || body.touched()[i].role.mirrored) continue;
    read_bristles(m, d, body, i);
    bristles->write(i, body.touched()[i].geom, e.X_WM.inverse() * e.pairs[i].X_WB,
                    bristle_law(body, i, at_end ? 0 : m.opt.timestep), at_end ? Twist{} : e.pairs[i].V_rub, state);
  }
  const std::span<const mjtNum> next = bristles->written();
  std::copy(next.begin(), next.end(), state.begin());
}

void BodyContacts::compile_others(const mjModel& m) {
  touched_.clear();
  checks.clear();
  partners_.clear();
  broad_phase_.clear();
  for (const int geom : settings().others) {
    try {
      const TouchedGeom touched = compile_other(m, geom);
      if (touched.body != nullptr && body_->half_space() && touched.body->half_space()) {
        if (!settings().others_named) continue;  // two planes do not collide in MuJoCo either
        throw Error(fmt::format("geoms \"{}\" and \"{}\" are both planes", settings().geom_name, geom_name(m, geom)));
      }
      broad_phase_.add(geom);
      if (touched.role.partner.valid()) partners_.push_back(touched_.size());
      if (touched.body != nullptr) broad_phase_.set_body(touched_.size(), *touched.body, touched.X_GB);
      touched_.push_back(touched);
      checks.emplace_back();
    } catch (const Error& error) {
      if (settings().others_named) throw Error("", key_of_others(declared_[self_]), error.what());
      warnings.push_back(std::string(error.what()) + "; it is not touched hydroelastically");
    }
  }
}

TouchedGeom BodyContacts::compile_other(const mjModel& m, int geom) {
  TouchedGeom touched;
  touched.geom = geom;
  touched.role = pair_role(declared_, declared_[self_], geom);
  if (touched.role.partner.valid()) {  // link() sets the body later
    const auto partner = std::find_if(declared_.begin(), declared_.end(),
                                      [&](const DeclaredBody& body) { return body.id == touched.role.partner; });
    if (partner->sensor && settings().materials.contains(geom_name(m, geom)))
      warnings.push_back(fmt::format("\"materials\" names geom \"{}\", which is a sensor: its layout's material counts",
                                     geom_name(m, geom)));
    return touched;
  }
  touched.body = geom_body(m, geom, settings().materials, touched.repair);
  check_one_soft(*body_, *touched.body, declared_[self_].sensor);
  set_properties(*body_, touched);
  return touched;
}

void BodyContacts::link(const BodyContacts& other) {
  if (body_ == nullptr) return;
  for (const std::size_t i : partners_) {
    TouchedGeom& t = touched_[i];
    if (t.role.partner != other.id() || other.body_ == nullptr || t.body == other.body_) continue;
    t.body = nullptr;
    broad_phase_.remove_body(i);
    try {
      check_one_soft(*body_, *other.body_, declared_[self_].sensor);
    } catch (const Error& error) {
      if (settings().others_named) throw Error("", key_of_others(declared_[self_]), error.what());
      if (!t.role.mirrored) warnings.push_back(std::string(error.what()) + "; it is not touched hydroelastically");
      t.role.partner = {};  // the partner is not searched again
      continue;
    }
    t.body = other.body_;
    set_properties(*body_, t);
    t.X_GB = other.X_GM_;
    broad_phase_.set_body(i, *t.body, t.X_GB);
  }
}

void BodyContacts::locate(const mjModel& m, const mjData& d, Evaluation& e) const {
  e.X_WM = geom_pose(m, d, settings().geom) * X_GM_;
  e.pairs.resize(touched_.size());
  e.near.reserve(touched_.size());
  broad_phase_.find(d, e.X_WM * bounds_M_.center, bounds_M_.radius, e.near);
  const Pose X_MW = e.X_WM.inverse();
  std::erase_if(e.near, [&](std::size_t i) {
    Pose& X_WB = e.pairs[i].X_WB;
    X_WB = geom_pose(m, d, touched_[i].geom);
    if (touched_[i].role.partner.valid()) X_WB = X_WB * touched_[i].X_GB;
    const Aabb& other = touched_[i].box;
    return !bounds_M_.box.empty() && !other.empty() && are_apart(bounds_M_.box, other, X_MW * X_WB);
  });
  if (e.near.empty()) return;
  const Twist V_WM = body_twist(m, d, m.geom_bodyid[settings().geom], e.X_WM.p);
  const dmat3 R_WM = e.X_WM.rotation();
  for (const std::size_t i : e.near) {
    const Twist V_WB = body_twist(m, d, m.geom_bodyid[touched_[i].geom], e.X_WM.p);
    PairState& pair = e.pairs[i];
    pair.V = {(V_WM.linear - V_WB.linear) * R_WM, (V_WM.angular - V_WB.angular) * R_WM};  // v R = R^T v
    pair.V_rub = pair.V;
    pair.implicit_step = 0;
  }
}

void BodyContacts::begin_evaluation(const mjModel& m, mjData& d) {
  const Stopwatch watch(times.surfaces);
  for (const std::size_t i : partners_)
    if (touched_[i].role.partner.valid()) link(own_body(m, d, touched_[i].role.partner));
  if (latest_ == sensed_) latest_ = 1 - latest_;
  Evaluation& e = slots_[latest_];
  e.valid = false;
  clear_pairs(e);
  locate(m, d, e);
}

void BodyContacts::compute_surfaces() {
  const Stopwatch watch(times.surfaces);
  Evaluation& e = slots_[latest_];
  for (const std::size_t i : e.near) {
    if (touched_[i].role.mirrored) continue;
    intersect(*body_, *touched_[i].body, e.X_WM, e.pairs[i].X_WB, e.pairs[i].surface, workspace_);
  }
  if (bristles_) bristles_->forget_surfaces();
  e.valid = true;
}

Evaluation& BodyContacts::evaluate(const mjModel& m, mjData& d) {
  begin_evaluation(m, d);
  compute_surfaces();
  return latest();
}

bool BodyContacts::is_fresh(const mjModel& m, const mjData& d) {
  const Evaluation& e = slots_[latest_];
  if (!e.valid) return false;
  locate(m, d, probe_);
  return same(e.X_WM, probe_.X_WM) && e.near == probe_.near &&
         std::all_of(e.near.begin(), e.near.end(), [&](std::size_t i) {
           return same(e.pairs[i].X_WB, probe_.pairs[i].X_WB) && same(e.pairs[i].V, probe_.pairs[i].V);
         });
}

Evaluation& BodyContacts::present(const mjModel& m, mjData& d) {
  if (is_fresh(m, d)) return slots_[latest_];
  Evaluation& e = evaluate(m, d);
  for (const std::size_t i : e.near) e.pairs[i].wrench = present_traction(m, d, *this, i).wrench;
  return e;
}

std::size_t pair_with(const std::vector<TouchedGeom>& touched, int geom) {
  const auto found =
      std::lower_bound(touched.begin(), touched.end(), geom, [](const TouchedGeom& t, int g) { return t.geom < g; });
  return found != touched.end() && found->geom == geom ? static_cast<std::size_t>(found - touched.begin())
                                                       : touched.size();
}

void BodyContacts::mirror_pairs(const mjModel& m, mjData& d) {
  Evaluation& e = slots_[sensed_];
  for (const std::size_t i : e.near) {
    if (!touched_[i].role.mirrored) continue;
    BodyContacts& other = own_body(m, d, touched_[i].role.partner);
    const std::size_t theirs = pair_with(other.touched_, settings().geom);
    if (!other.failure.empty() || theirs == other.touched_.size()) continue;
    const Evaluation& computed = other.present(m, d);
    keep_sticking(m, d, other);
    const Stopwatch watch(times.surfaces);
    const RigidTransform X_MB(e.X_WM.inverse() * computed.X_WM);
    mirror(computed.pairs[theirs].surface, X_MB, e.pairs[i].surface);
    e.pairs[i].wrench = reaction(computed.pairs[theirs].wrench, X_MB);
    e.pairs[i].V_rub = reversed(computed.pairs[theirs].V_rub, X_MB);
    e.pairs[i].sticking = mirrored(computed.pairs[theirs].sticking, X_MB);
  }
}

void BodyContacts::sense(const mjModel& m, mjData& d) {
  present(m, d);
  sensed_ = latest_;
  keep_sticking(m, d, *this);
  mirror_pairs(m, d);
}

mjtNum* write_block(const Evaluation& e, Output block, mjtNum* out) {
  if (block == Output::area) {
    *out = 0;
    for (const std::size_t i : e.near) *out += e.pairs[i].surface.area();
    return out + 1;
  }
  Wrench sum;
  for (const std::size_t i : e.near) {
    const PairState& pair = e.pairs[i];
    const Wrench wrench = block == Output::elastic_wrench ? pressure_wrench(pair.surface) : pair.wrench;
    sum.force += e.X_WM.rotate(wrench.force);
    sum.torque += e.X_WM.rotate(wrench.torque);
  }
  for (int i = 0; i < 3; ++i) out[i] = sum.force[i], out[i + 3] = sum.torque[i];
  return out + 6;
}

void BodyContacts::reset() {
  for (Evaluation& e : slots_) {
    e = {};
    e.pairs.resize(touched_.size());
  }
}

void intersect_bodies(const BodyContacts& self, const BodyContacts& other, bool mirrored, const Pose& X_WM,
                      const Pose& X_WO, ContactSurface& out, IntersectWorkspace& workspace) {
  if (!mirrored) {
    intersect(*self.body(), *other.body(), X_WM, X_WO, out, workspace);
    return;
  }
  ContactSurface theirs;
  intersect(*other.body(), *self.body(), X_WO, X_WM, theirs, workspace);
  mirror(theirs, RigidTransform(X_WM.inverse() * X_WO), out);
}

}  // namespace taxel
