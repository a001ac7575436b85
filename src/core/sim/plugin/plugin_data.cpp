#include "core/sim/plugin/plugin_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/base/text/message.h"
#include "core/mesh/compare.h"
#include "core/sensor/readout/reading.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/pairs/geom_body.h"
#include "core/sim/plugin/pairs/pair_warnings.h"
#include "core/sim/plugin/side_by_side.h"

namespace taxel {
namespace {

/// Returns the largest distance of a vertex of either mesh from the other mesh [m].
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

/// Returns the mesh of a geom in the frame of its mesh file, in the single precision of the model, if no file has it: a
/// scene may come from memory or from another machine. Otherwise returns null.
TriMeshPtr mesh_in_memory(const mjModel& m, int geom) {
  const int mesh = m.geom_dataid[geom];
  if (m.geom_type[geom] != mjGEOM_MESH || mesh < 0) return nullptr;
  std::error_code ignored;
  if (m.mesh_pathadr[mesh] >= 0 && std::filesystem::exists(m.paths + m.mesh_pathadr[mesh], ignored)) return nullptr;
  const TriMesh compiled = compiled_mesh(m, geom);
  const RigidTransform X_MG(mesh_file_pose(m, geom).inverse());
  std::vector<dvec3> vertices = compiled.vertices();
  for (dvec3& v : vertices) v = X_MG(v);
  return std::make_shared<const TriMesh>(std::move(vertices), compiled.faces());
}

/// Returns true if the file of the geom's mesh has another hash than `sha256`, and both hashes are known.
bool another_file(const mjModel& m, int geom, const std::string& sha256) {
  const int path = m.mesh_pathadr[m.geom_dataid[geom]];
  std::error_code ignored;
  if (sha256.empty() || path < 0 || !std::filesystem::is_regular_file(m.paths + path, ignored)) return false;
  return sha256_hex(read_file(m.paths + path)) != sha256;
}

/// Returns true if the geom's mesh is of the layout's mesh file, by its hash, or by its name if the layout has no hash.
bool same_file(const mjModel& m, int geom, const MeshRef& mesh) {
  const int path = m.mesh_pathadr[m.geom_dataid[geom]];
  std::error_code ignored;
  if (path < 0 || !std::filesystem::is_regular_file(m.paths + path, ignored)) return false;
  if (!mesh.sha256.empty()) return !another_file(m, geom, mesh.sha256);
  return std::filesystem::path(m.paths + path).filename() == std::filesystem::path(mesh.file).filename();
}

/// Throws Error if the geom has the layout's mesh in another place than its file: `refpos` and `refquat` of a mesh
/// asset are not in a compiled model. `shown` is the geom's mesh and `tolerance` [m] that of equal places.
void expect_no_reference_pose(const mjModel& m, int geom, const SensorModel& model, const TriMesh& shown,
                              double tolerance) {
  const std::optional<Pose> X_GF = find_rigid_motion(*model.loaded, shown, tolerance);
  const RigidTransform X_GM(mesh_file_pose(m, geom));
  const auto is_in_place = [&](const dvec3& v) {
    return glm::distance(RigidTransform(*X_GF)(v), X_GM(v)) <= tolerance;
  };
  const std::vector<dvec3>& vertices = model.loaded->vertices();
  if (!X_GF || std::all_of(vertices.begin(), vertices.end(), is_in_place)) return;
  if (!same_file(m, geom, model.layout.mesh)) return;
  Pose X_BF = Pose{quat(m.geom_quat + 4 * geom), vec3(m.geom_pos + 3 * geom)} * *X_GF;
  if (X_BF.q.w < 0) X_BF.q = -X_BF.q;
  const auto rounded = [](double value) { return std::abs(value) < 1e-7 ? 0.0 : value; };
  throw Error("", "geom",
              fmt::format("the mesh \"{}\" of geom \"{}\" has refpos or refquat, which a compiled model does not keep, "
                          "so the taxels would be in another place: leave both out, and give the geom "
                          "pos=\"{:.6g} {:.6g} {:.6g}\" quat=\"{:.6g} {:.6g} {:.6g} {:.6g}\" in its body",
                          object_name(m, mjOBJ_MESH, m.geom_dataid[geom], "mesh"), geom_name(m, geom),
                          rounded(X_BF.p.x), rounded(X_BF.p.y), rounded(X_BF.p.z), rounded(X_BF.q.w), rounded(X_BF.q.x),
                          rounded(X_BF.q.y), rounded(X_BF.q.z)));
}

/// Returns warnings if the geom's surface is not that of the layout's mesh. Throws Error if `refpos` or `refquat` has
/// moved it.
std::vector<std::string> compare(const mjModel& m, int geom, const SensorModel& model) {
  const std::string name = fmt::format("geom \"{}\"", geom_name(m, geom));
  const TriMeshPtr shown = drawn_mesh(m, geom);
  if (shown == nullptr)
    return {name + " has no surface to compare: the layout's mesh is taken in the geom's own frame"};
  // Errors of single precision and of moving the mesh to its centre are below 1e-6 of the diagonal.
  const double tolerance = 1e-5 * model.mesh->bounds().diagonal();
  if (m.geom_type[geom] == mjGEOM_MESH) expect_no_reference_pose(m, geom, model, *shown, tolerance);
  const Pose X_GM = mesh_file_pose(m, geom);
  double apart = distance_apart(*shown, *model.mesh, X_GM);
  // A scene may have the mesh file itself or the mesh that a repair built from it.
  if (model.mesh != model.loaded) apart = std::min(apart, distance_apart(*shown, *model.loaded, X_GM));
  if (apart <= tolerance) return {};
  const std::string lie = fmt::format("the surfaces lie up to {:.3g} mm apart (the layout's mesh counts)", 1e3 * apart);
  if (m.geom_type[geom] != mjGEOM_MESH)
    return {name + " has no mesh: the layout's mesh is taken in the geom's own frame, where " + lie};
  const bool other_file = another_file(m, geom, model.layout.mesh.sha256);
  return {fmt::format("the mesh of {} is not the layout's{}: {}", name,
                      other_file ? ", the hash of its file differs" : "", lie)};
}

/// Throws Error if a sensor can touch no geom of a scene that has some: it would read 0 forever. A scene of the sensor
/// alone is one to which others are attached.
void check_touches(const mjModel& m, const ContactSettings& settings) {
  const int weld = m.body_weldid[m.geom_bodyid[settings.geom]];
  const bool is_alone =
      std::all_of(m.geom_bodyid, m.geom_bodyid + m.ngeom, [&](int body) { return m.body_weldid[body] == weld; });
  if (!settings.others.empty() || is_alone) return;
  throw Error(
      "", "others",
      fmt::format("no geom can touch geom \"{}\" or another geom of its body \"{}\": give one of them contype and "
                  "conaffinity that match those of an object, or name the touched geoms",
                  settings.geom_name, body_name(m, m.geom_bodyid[settings.geom])));
}

/// Returns compare(), which other data with the same content share.
WarningsPtr shared_comparison(const mjModel& m, int geom, const SensorModel& model) {
  const auto make = [&] { return compare(m, geom, model); };
  const std::optional<std::string> content = geom_content(m, geom);
  if (!content) return std::make_shared<const std::vector<std::string>>(make());
  return share_warnings(
      {geom_name(m, geom), *content, hash_of_mesh(*model.mesh), hash_of_mesh(*model.loaded), model.layout.mesh.sha256},
      make);
}

SensorModelPtr compile_on_geom(const mjModel& m, const FoundLayout& found, int geom) {
  return compile_layout(found, [&] { return mesh_in_memory(m, geom); });
}

}  // namespace

CompiledSensors compile_side_by_side(const mjModel& m) {
  const std::vector<int> instances = sensor_instances(m);
  CompiledSensors compiled{std::vector<SensorModelPtr>(instances.size()), std::vector<WarningsPtr>(instances.size())};
  parallel_chunks(static_cast<int>(instances.size()), 1, [&](int i, int) {
    try {
      const SensorConfig config = read_sensor_config(m, instances[at(i)]);
      if (config.layout.empty()) return;
      const FoundLayout found = find_layout(config.layout, layout_folders(m, config.geom));
      compiled.models[at(i)] = compile_on_geom(m, found, config.geom);
      compiled.comparisons[at(i)] = shared_comparison(m, config.geom, *compiled.models[at(i)]);
    } catch (...) {  // the instance does the same, and reports it
    }
  });
  return compiled;
}

HydroInstance::HydroInstance(const mjModel& m, int instance)
    : config_(read_sensor_config(m, instance)), contacts_({instance, 0}, declared_bodies(m, instance)) {
  check_touches(m, contacts_.settings());
  if (config_.layout.empty()) {
    check_slip_output(config_);
    return;
  }
  const FoundLayout found = find_layout(config_.layout, layout_folders(m, config_.geom));
  config_.bristles = bristles_with_layout(config_.bristles, found.layout);
  check_slip_output(config_);
  contacts_.set_bristles(config_.bristles);
  check_calibrated_output(config_, found.layout);
  hand_over(m, compile_on_geom(m, found, config_.geom));
}

HydroInstance::HydroInstance(const HydroInstance& other)
    : config_(other.config_),
      contacts_(other.contacts_),
      model_(other.model_),
      compared_(other.compared_),
      field_weights_(other.field_weights_),
      slip_(other.slip_),
      reported_(other.reported_) {
  reading_.hits = other.reading_.hits;
  reading_.values = other.reading_.values;
  reading_.force = other.reading_.force;
  reading_.shear = other.reading_.shear;
}

void HydroInstance::check_output_fits(const mjModel& m, const SensorModel& model) const {
  const int size = sensor_dimension(config_.output, model.taxel_count());
  for (int s = 0; s < m.nsensor; ++s) {
    if (m.sensor_plugin[s] != contacts_.id().instance || m.sensor_dim[s] == size) continue;
    throw Error("", "layout",
                fmt::format("needs {} values in sensordata, the model was compiled with {}: compile it again", size,
                            m.sensor_dim[s]));
  }
}

void HydroInstance::hand_over(const mjModel& m, SensorModelPtr model) {
  check_output_fits(m, *model);
  set_reported_values(m, *model);
  model_ = std::move(model);
  const Pose X_GM = mesh_file_pose(m, config_.geom);
  compared_ = shared_comparison(m, config_.geom, *model_);
  contacts_.warnings = *compared_;
  contacts_.set_body(m, model_->body, model_->skin->mesh().bounds(), X_GM);
  read_sensor(*model_, {}, reading_);  // sizes the buffers
  set_field_weights();
}

/// Builds the chain of the taxels of the next model if the output has its values. Another chain than that of the
/// present model begins again.
void HydroInstance::set_reported_values(const mjModel& m, const SensorModel& next) {
  if (!has_output(config_, Output::calibrated)) return;
  const Layout& layout = next.layout;
  const bool is_first = model_ == nullptr;
  if (!is_first && layout.calibration == model_->layout.calibration && layout.taxels == model_->layout.taxels) return;
  check_calibrated_output(config_, layout);
  reported_.emplace(m, contacts_.id().instance, layout);
  if (!is_first) reported_->begin_again();
}

/// Sets the weights of the taxels on the skin, with which slip is read.
void HydroInstance::set_field_weights() {
  if (!config_.bristles.has_bristles()) return;
  field_weights_ = model_->skin_fields != nullptr ? model_->skin_fields->weights
                                                  : std::make_shared<const FieldWeights>(model_->layout, *model_->skin);
  slip_.assign(reading_.values.size(), 0.0);
}

void HydroInstance::replace_samples(const mjModel& m, mjData& d, SensorModelPtr model) {
  check_output_fits(m, *model);
  set_reported_values(m, *model);
  model_ = std::move(model);
  set_field_weights();
  read(m, d);
}

void HydroInstance::sense(const mjModel& m, mjData& d) {
  sense_and_warn(m, d, contacts_);
  is_unread_ = true;
}

void HydroInstance::read_slip_of_taxels() {
  if (!field_weights_) return;
  std::vector<const StickingFriction*> frictions;
  for (const std::size_t i : sensed().near) frictions.push_back(&sensed().pairs[i].sticking);
  read_slip(*model_, *field_weights_, frictions, slip_);
}

void HydroInstance::read(const mjModel& m, mjData& d) {
  is_unread_ = false;
  surfaces_.clear();
  motions_.clear();
  for (const std::size_t i : sensed().near) {
    const PairState& pair = sensed().pairs[i];
    surfaces_.push_back(&pair.surface);
    const StickingFriction* sticking = pair.sticking.roots.empty() ? nullptr : &pair.sticking;
    if (model_->layout.readout.shear) motions_.push_back({touched()[i].properties, pair.V_rub, sticking});
  }
  const Stopwatch watch(contacts_.times.readings);
  read_sensor(*model_, surfaces_, reading_, RayPath::fastest, motions_);
  read_slip_of_taxels();
  if (reported_) reported_->evaluate(m, d, reading_.values);
  for (int s = 0; s < m.nsensor; ++s)
    if (m.sensor_plugin[s] == contacts_.id().instance) write_output(d.sensordata + m.sensor_adr[s]);
}

void HydroInstance::advance(const mjModel& m, mjData& d) {
  if (reported_) reported_->advance(m, d);
}

void read_sensors(const mjModel& m, mjData& d, std::span<HydroInstance* const> sensors) {
  std::size_t polygons = 0;
  for (const HydroInstance* sensor : sensors)
    for (const std::size_t i : sensor->sensed().near) polygons += sensor->sensed().pairs[i].surface.polygons.size();
  side_by_side(sensors.size(), polygons, [&](std::size_t i) {
    try {
      sensors[i]->read(m, d);
    } catch (const std::exception& error) {
      sensors[i]->contacts().failure = shown_message(error);
    }
  });
}

void HydroInstance::write_output(mjtNum* out) const {
  for (const Output block : config_.output) {
    if (block == Output::readings) {
      out = std::copy(reading_.values.begin(), reading_.values.end(), out);
    } else if (block == Output::slip) {
      out = std::copy(slip_.begin(), slip_.end(), out);
    } else if (block == Output::calibrated) {
      out = std::copy(reported_->values().begin(), reported_->values().end(), out);
    } else {
      out = write_block(contacts_.sensed(), block, out);
    }
  }
}

namespace {

/// Returns the bounds of a body in its own frame; empty for a half-space.
Aabb bounds_of(const HydroBody& body) {
  Aabb box;
  if (const auto* soft = std::get_if<SoftBody>(&body.geometry))
    for (const dvec3& v : soft->field->vertices()) box.include(v);
  return box;
}

}  // namespace

ContactInstance::ContactInstance(const mjModel& m, int instance)
    : instance_(instance), config_(read_contact_config(m, instance)) {
  const std::vector<DeclaredBody> declared = declared_bodies(m, instance);
  bodies_.reserve(config_.bodies.size());
  for (std::size_t k = 0; k < config_.bodies.size(); ++k) {
    BodyContacts& body = bodies_.emplace_back(BodyId{instance, static_cast<int>(k)}, declared);
    HydroBodyPtr soft;
    try {
      std::string repair;
      soft = geom_body(m, body.settings().geom, config_.materials, repair);
      if (!repair.empty()) body.warnings.push_back(repair);
    } catch (const Error& error) {
      throw Error("", "materials", error.what());
    }
    const Aabb bounds = bounds_of(*soft);
    body.set_body(m, std::move(soft), bounds, Pose{});
  }
}

void ContactInstance::sense(const mjModel& m, mjData& d) {
  for (BodyContacts& body : bodies_) sense_and_warn(m, d, body);
  for (int s = 0; s < m.nsensor; ++s) {
    if (m.sensor_plugin[s] != instance_) continue;
    mjtNum* out = d.sensordata + m.sensor_adr[s];
    for (const BodyContacts& body : bodies_)
      for (const Output block : config_.output) out = write_block(body.sensed(), block, out);
  }
}

}  // namespace taxel
