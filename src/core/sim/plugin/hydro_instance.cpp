#include "core/sim/plugin/hydro_instance.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/hash.h"
#include "core/base/stopwatch.h"
#include "core/hydro/body_cache.h"
#include "core/hydro/soft_mesh.h"
#include "core/sim/model/geometry.h"
#include "core/sim/model/scene_view.h"
#include "core/sim/plugin/plugin_table.h"

namespace taxel {
namespace {

bool same(const Pose& a, const Pose& b) {
  return a.q == b.q && a.p == b.p;
}
bool same(const Twist& a, const Twist& b) {
  return a.linear == b.linear && a.angular == b.angular;
}

/// Velocity of a body at the world point p, world axes.
Twist body_twist(const mjModel& m, const mjData& d, int body, const dvec3& p_W) {
  mjtNum v[6];  // angular, linear, at the origin of the body frame
  mj_objectVelocity(&m, &d, mjOBJ_XBODY, body, v, 0);
  const dvec3 w(v[0], v[1], v[2]), origin(d.xpos[3 * body], d.xpos[3 * body + 1], d.xpos[3 * body + 2]);
  return {dvec3(v[3], v[4], v[5]) + glm::cross(w, p_W - origin), w};
}

/// Material of a touched geom: as configured, else rigid with the geom's own friction.
OtherMaterial other_material(const mjModel& m, const SensorConfig& config, int geom, ShapeType type) {
  OtherMaterial other;
  const auto found = config.materials.find(geom_name(m, geom));
  if (found != config.materials.end()) other = found->second;
  if (!other.has_friction) other.material.friction = m.geom_friction[3 * geom];
  if (!other.has_field) other.material.field = type == ShapeType::mesh ? FieldKind::pad : FieldKind::medial_axis;
  return other;
}

/// How far the vertices of each mesh lie from the other one, at most [m].
double distance_apart(const TriMesh& of_geom, const TriMesh& of_layout, const Pose& X_GM) {
  const auto farthest = [](const TriMesh& from, const TriMesh& to, const Pose& X_to_from) {
    const MeshIndex index(std::make_shared<const TriMesh>(to));
    const RigidTransform X(X_to_from);
    double most = 0;
    for (const dvec3& v : from.vertices()) most = std::max(most, index.closest_point(X(v)).distance);
    return most;
  };
  return std::max(farthest(of_geom, of_layout, X_GM.inverse()), farthest(of_layout, of_geom, X_GM));
}

/// Whether the file of the geom's mesh has another hash than this, where both are known.
bool another_file(const mjModel& m, int geom, const std::string& sha256) {
  const int path = m.mesh_pathadr[m.geom_dataid[geom]];
  std::error_code ignored;
  if (sha256.empty() || path < 0 || !std::filesystem::is_regular_file(m.paths + path, ignored)) return false;
  return sha256_hex(read_file(m.paths + path)) != sha256;
}

void check_one_soft(const HydroBody& sensor, const HydroBody& other, const std::string& name) {
  if (!sensor.soft() && !other.soft())
    throw Error(fmt::format("sensor and geom \"{}\" are both rigid: one of them must be soft", name));
}

/// The wrench on the other body, about the origin of its frame B and in B's axes, of a wrench on A.
Wrench reaction(const Wrench& on_A, const RigidTransform& X_BA) {
  const dvec3 force = -(X_BA.R * on_A.force);
  return {force, -(X_BA.R * on_A.torque) + glm::cross(X_BA.p, force)};
}

/// The velocity of B relative to A at B's origin, in B's axes, as that of A relative to B at A's origin, in A's.
Twist reversed(const Twist& of_B, const RigidTransform& X_AB) {
  const dvec3 A_in_B = X_AB.inverse_point(dvec3(0));
  return {-(X_AB.R * (of_B.linear + glm::cross(of_B.angular, A_in_B))), -(X_AB.R * of_B.angular)};
}

}  // namespace

HydroInstance::HydroInstance(const mjModel& m, int instance)
    : instance_(instance), config_(read_sensor_config(m, instance)), declared_(declared_sensors(m, instance)) {
  add_sensors_that_touch(declared_, config_);
  if (!config_.layout.empty())
    hand_over(m, compile_layout(find_layout(config_.layout, layout_folders(m, config_.geom))));
}

HydroInstance::HydroInstance(const HydroInstance& other)
    : failure(other.failure),
      instance_(other.instance_),
      config_(other.config_),
      declared_(other.declared_),
      model_(other.model_),
      X_GM_(other.X_GM_),
      touched_(other.touched_),
      sensors_(other.sensors_),
      broad_phase_(other.broad_phase_),
      warnings_(other.warnings_),
      slots_(other.slots_),
      latest_(other.latest_),
      sensed_(other.sensed_) {
  reading_.hits = other.reading_.hits;
  reading_.values = other.reading_.values;
  reading_.force = other.reading_.force;
  reading_.shear = other.reading_.shear;
}

void HydroInstance::check_output_fits(const mjModel& m, const SensorModel& model) const {
  const int size = sensor_dimension(config_.output, model.taxel_count());
  for (int s = 0; s < m.nsensor; ++s) {
    if (m.sensor_plugin[s] != instance_ || m.sensor_dim[s] == size) continue;
    throw Error("", "layout",
                fmt::format("needs {} values in sensordata, the model was compiled with {}: compile it again", size,
                            m.sensor_dim[s]));
  }
}

void HydroInstance::hand_over(const mjModel& m, SensorModelPtr model) {
  check_output_fits(m, *model);
  model_ = std::move(model);
  read_sensor(*model_, {}, reading_);  // sizes the buffers
  warnings_.clear();
  X_GM_ = mesh_file_pose(m, config_.geom);
  compare_with_model(m);
  compile_others(m);
  reset();
}

void HydroInstance::replace_samples(const mjModel& m, mjData& d, SensorModelPtr model) {
  check_output_fits(m, *model);
  model_ = std::move(model);
  read(m, d);
}

void HydroInstance::compile_others(const mjModel& m) {
  touched_.clear();
  sensors_.clear();
  broad_phase_.clear();
  for (const int geom : config_.others) {
    try {
      const TouchedGeom touched = compile_other(m, geom);
      broad_phase_.add(geom);
      if (touched.role.sensor >= 0) sensors_.push_back(touched_.size());
      if (touched.body != nullptr) broad_phase_.set_body(touched_.size(), *touched.body, touched.X_GB);
      touched_.push_back(touched);
    } catch (const Error& error) {
      if (config_.others_named) throw Error("", "others", error.what());
      warnings_.push_back(std::string(error.what()) + "; it is not touched hydroelastically");
    }
  }
}

TouchedGeom HydroInstance::compile_other(const mjModel& m, int geom) {
  TouchedGeom touched;
  touched.geom = geom;
  touched.role = pair_role(declared_, instance_, config_, geom);
  if (touched.role.sensor >= 0) {  // its body comes with link()
    if (config_.materials.contains(geom_name(m, geom)))
      warnings_.push_back(fmt::format(
          "\"materials\" names geom \"{}\", which is a sensor: its layout's material counts", geom_name(m, geom)));
    return touched;
  }
  Shape shape = geom_shape(m, geom);
  const OtherMaterial other = other_material(m, config_, geom, shape.type);
  if (m.geom_type[geom] == mjGEOM_SDF && other.resolution > 0) shape = geom_shape(m, geom, other.resolution);
  shape.resolution = other.resolution;
  if (const RepairedMeshPtr repaired = repair_soft_mesh(shape, other.material))
    warnings_.push_back(fmt::format("geom \"{}\": {}", geom_name(m, geom), repair_summary(repaired->report)));
  touched.body = share_body(shape, other.material, geom_name(m, geom));
  check_one_soft(*model_->body, *touched.body, geom_name(m, geom));
  touched.properties = combine(model_->body->material, other.material);
  return touched;
}

void HydroInstance::link(const mjModel& m, const HydroInstance& other) {
  if (model_ == nullptr) return;
  for (const std::size_t i : sensors_) {
    TouchedGeom& t = touched_[i];
    if (t.role.sensor != other.instance_ || other.model_ == nullptr || t.body == other.model_->body) continue;
    t.body = nullptr;
    broad_phase_.remove_body(i);
    try {
      check_one_soft(*model_->body, *other.model_->body, geom_name(m, t.geom));
    } catch (const Error& error) {
      if (config_.others_named) throw Error("", "others", error.what());
      if (!t.role.mirrored) warnings_.push_back(std::string(error.what()) + "; it is not touched hydroelastically");
      t.role.sensor = -1;  // not asked again
      continue;
    }
    t.body = other.model_->body;
    t.properties = combine(model_->body->material, t.body->material);
    t.X_GB = other.X_GM_;
    broad_phase_.set_body(i, *t.body, t.X_GB);
  }
}

void HydroInstance::link_all(const mjModel& m, mjData& d) {
  for (const std::size_t i : sensors_)
    if (touched_[i].role.sensor >= 0) link(m, own_sensor(m, d, touched_[i].role.sensor));
}

void HydroInstance::compare_with_model(const mjModel& m) {
  const int geom = config_.geom;
  const std::string name = fmt::format("geom \"{}\"", geom_name(m, geom));
  const TriMeshPtr shown = drawn_mesh(m, geom);
  if (shown == nullptr) {
    warnings_.push_back(name + " has no surface to compare: the layout's mesh is taken in the geom's own frame");
    return;
  }
  double apart = distance_apart(*shown, *model_->mesh, X_GM_);
  // A scene may hold the mesh file itself or the mesh that was made of it by a repair.
  if (model_->mesh != model_->loaded) apart = std::min(apart, distance_apart(*shown, *model_->loaded, X_GM_));
  // Single precision and re-centring stay below 1e-6.
  if (apart <= 1e-5 * model_->mesh->bounds().diagonal()) return;
  const std::string lie = fmt::format("the surfaces lie up to {:.3g} mm apart (the layout's mesh counts)", 1e3 * apart);
  if (m.geom_type[geom] != mjGEOM_MESH) {
    warnings_.push_back(name + " has no mesh: the layout's mesh is taken in the geom's own frame, where " + lie);
  } else {
    const bool other_file = another_file(m, geom, model_->layout.mesh.sha256);
    warnings_.push_back(fmt::format("the mesh of {} is not the layout's{}: {}", name,
                                    other_file ? ", the hash of its file differs" : "", lie));
  }
}

void HydroInstance::clear_pairs(Evaluation& e) const {
  for (const std::size_t i : e.near) {
    e.pairs[i].wrench = {};
    e.pairs[i].surface.clear();
  }
  e.near.clear();
}

void HydroInstance::locate(const mjModel& m, const mjData& d, Evaluation& e) const {
  e.X_WM = geom_pose(m, d, config_.geom) * X_GM_;
  e.pairs.resize(touched_.size());
  e.near.reserve(touched_.size());
  const Aabb& box = model_->skin->mesh().bounds();
  broad_phase_.find(d, e.X_WM * box.center(), 0.5 * box.diagonal(), e.near);
  if (e.near.empty()) return;
  const Twist V_WM = body_twist(m, d, m.geom_bodyid[config_.geom], e.X_WM.p);
  const dmat3 R_WM = e.X_WM.rotation();
  for (const std::size_t i : e.near) {
    const Twist V_WB = body_twist(m, d, m.geom_bodyid[touched_[i].geom], e.X_WM.p);
    PairState& pair = e.pairs[i];
    pair.X_WB = geom_pose(m, d, touched_[i].geom);
    if (touched_[i].role.sensor >= 0) pair.X_WB = pair.X_WB * touched_[i].X_GB;
    pair.V = {(V_WM.linear - V_WB.linear) * R_WM, (V_WM.angular - V_WB.angular) * R_WM};  // v R = R^T v
    pair.V_rub = pair.V;
  }
}

Evaluation& HydroInstance::evaluate(const mjModel& m, mjData& d) {
  const Stopwatch watch(times.surfaces);
  link_all(m, d);
  if (latest_ == sensed_) latest_ = 1 - latest_;
  Evaluation& e = slots_[latest_];
  clear_pairs(e);
  locate(m, d, e);
  for (const std::size_t i : e.near) {
    if (touched_[i].role.mirrored) continue;
    intersect(*model_->body, *touched_[i].body, e.X_WM, e.pairs[i].X_WB, e.pairs[i].surface, workspace_);
  }
  e.valid = true;
  return e;
}

bool HydroInstance::fresh(const mjModel& m, const mjData& d) {
  const Evaluation& e = slots_[latest_];
  if (!e.valid) return false;
  locate(m, d, probe_);
  return same(e.X_WM, probe_.X_WM) && e.near == probe_.near &&
         std::all_of(e.near.begin(), e.near.end(), [&](std::size_t i) {
           return same(e.pairs[i].X_WB, probe_.pairs[i].X_WB) && same(e.pairs[i].V, probe_.pairs[i].V);
         });
}

void HydroInstance::note_step_too_large(const mjModel& m, std::size_t pair, double largest) {
  TouchedGeom& touched = touched_[pair];
  if (touched.step_too_large) return;
  touched.step_too_large = true;
  warnings_.push_back(
      fmt::format("the contact of geoms \"{}\" and \"{}\" is too stiff for the time step of {:.4g} s: as it is now, "
                  "the largest stable "
                  "step is {:.3g} s",
                  geom_name(m, config_.geom), geom_name(m, touched.geom), m.opt.timestep, largest));
}

void HydroInstance::note_pressed_through() {
  for (const std::size_t i : slots_[sensed_].near) {
    if (touched_[i].at_core || slots_[sensed_].pairs[i].surface.at_core() == 0) continue;
    touched_[i].at_core = true;
    warnings_.push_back(fmt::format("geom \"{}\" presses through the skin to its rigid core: pressure is missing there",
                                    touched_[i].body->name));
  }
}

void HydroInstance::note_mujoco_contacts(const mjModel& m, const mjData& d) {
  for (int c = 0; c < d.ncon; ++c) {
    const mjContact& contact = d.contact[c];
    if (contact.efc_address < 0) continue;
    if (contact.geom[0] != config_.geom && contact.geom[1] != config_.geom) continue;
    const std::size_t i = pair_with(contact.geom[0] == config_.geom ? contact.geom[1] : contact.geom[0]);
    if (i == touched_.size()) continue;
    TouchedGeom& t = touched_[i];
    if (!t.role.applies || t.role.mirrored || t.mujoco_too) continue;
    t.mujoco_too = true;
    warnings_.push_back(
        fmt::format("MuJoCo's own contact of geoms \"{}\" and \"{}\" acts as well: exclude the pair, or "
                    "set contype and conaffinity to 0 and name the geom in \"others\"",
                    geom_name(m, config_.geom), geom_name(m, t.geom)));
  }
}

Evaluation& HydroInstance::present(const mjModel& m, mjData& d) {
  if (fresh(m, d)) return slots_[latest_];
  Evaluation& e = evaluate(m, d);
  for (const std::size_t i : e.near)
    e.pairs[i].wrench = traction(e.pairs[i].surface, touched_[i].properties, e.pairs[i].V).wrench;
  return e;
}

std::size_t HydroInstance::pair_with(int geom) const {
  const auto found =
      std::lower_bound(touched_.begin(), touched_.end(), geom, [](const TouchedGeom& t, int g) { return t.geom < g; });
  return found != touched_.end() && found->geom == geom ? static_cast<std::size_t>(found - touched_.begin())
                                                        : touched_.size();
}

void HydroInstance::mirror_pairs(const mjModel& m, mjData& d) {
  Evaluation& e = slots_[sensed_];
  for (const std::size_t i : e.near) {
    if (!touched_[i].role.mirrored) continue;
    HydroInstance& other = own_sensor(m, d, touched_[i].role.sensor);
    const std::size_t theirs = other.pair_with(config_.geom);
    if (!other.failure.empty() || theirs == other.touched_.size()) continue;
    const Evaluation& computed = other.present(m, d);
    const Stopwatch watch(times.surfaces);
    const RigidTransform X_MB(e.X_WM.inverse() * computed.X_WM);
    mirror(computed.pairs[theirs].surface, X_MB, e.pairs[i].surface);
    e.pairs[i].wrench = reaction(computed.pairs[theirs].wrench, X_MB);
    e.pairs[i].V_rub = reversed(computed.pairs[theirs].V_rub, X_MB);
  }
}

void HydroInstance::sense(const mjModel& m, mjData& d) {
  present(m, d);
  sensed_ = latest_;
  mirror_pairs(m, d);
  note_pressed_through();
  note_mujoco_contacts(m, d);
  read(m, d);
}

void HydroInstance::read(const mjModel& m, mjData& d) {
  surfaces_.clear();
  motions_.clear();
  for (const std::size_t i : slots_[sensed_].near) {
    const PairState& pair = slots_[sensed_].pairs[i];
    surfaces_.push_back(&pair.surface);
    if (model_->layout.readout.shear) motions_.push_back({touched_[i].properties, pair.V_rub});
  }
  const Stopwatch watch(times.readings);
  read_sensor(*model_, surfaces_, reading_, RayPath::fastest, motions_);
  for (int s = 0; s < m.nsensor; ++s)
    if (m.sensor_plugin[s] == instance_) write_output(d.sensordata + m.sensor_adr[s]);
}

void HydroInstance::write_output(mjtNum* out) {
  const Evaluation& e = slots_[sensed_];
  for (const Output block : config_.output) {
    if (block == Output::readings) out = std::copy(reading_.values.begin(), reading_.values.end(), out);
    if (block == Output::wrench) {
      Wrench sum;
      for (const std::size_t i : e.near) {
        const PairState& pair = e.pairs[i];
        sum.force += e.X_WM.rotate(pair.wrench.force);
        sum.torque += e.X_WM.rotate(pair.wrench.torque);
      }
      for (int i = 0; i < 3; ++i) out[i] = sum.force[i], out[i + 3] = sum.torque[i];
      out += 6;
    }
    if (block == Output::area) {
      *out = 0;
      for (const std::size_t i : e.near) *out += e.pairs[i].surface.area();
      ++out;
    }
  }
}

void HydroInstance::reset() {
  for (Evaluation& e : slots_) {
    e = {};
    e.pairs.resize(touched_.size());
  }
  read_sensor(*model_, {}, reading_);
}

}  // namespace taxel
