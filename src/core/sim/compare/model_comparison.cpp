// Readings of one step by other models, among them MuJoCo's own tactile sensors.
//
// MuJoCo's sensors are read in a small model of their own that shares nothing with the running scene: the skin on slide
// joints, without friction, and each touched body as a mocap body, one at a time. The depth is MuJoCo's signed distance
// at a mesh of the taxels' samples. The touch is the force of MuJoCo's contact points within a taxel's sphere, when the
// constraints carry the elastic force of the hydroelastic contact: the load is applied to the skin, and contacts
// without compliance (solref -0 -0) balance it at rest.
//
// Pitfalls: MuJoCo needs a mesh with a volume, so a tetrahedron in the middle is added to the vertices of the taxels;
// each pair starts without the solver's warm start, so that the result depends on the poses alone. Theory:
// docs/theory/sensor.md, "Other models of the same contact".
#include "core/sim/compare/model_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/hydro/intersect.h"
#include "core/sensor/readout/reading.h"
#include "core/sim/compare/contact_again.h"

namespace taxel {
namespace {

constexpr double kFullImpedance = 0.9999;  // largest value that MuJoCo accepts; a ten-thousandth of the force is lost

void set(double* to, const dvec3& v) {
  for (int i = 0; i < 3; ++i) to[i] = v[i];
}
void set(double* to, const dquat& q) {
  to[0] = q.w, to[1] = q.x, to[2] = q.y, to[3] = q.z;
}

void fill_mesh(mjsMesh* mesh, const std::vector<dvec3>& vertices, const std::vector<ivec3>& faces) {
  std::vector<float> points;
  for (const dvec3& v : vertices)
    for (int i = 0; i < 3; ++i) points.push_back(static_cast<float>(v[i]));
  std::vector<int> corners;
  for (const ivec3& f : faces) corners.insert(corners.end(), {f.x, f.y, f.z});
  mjs_setFloat(mesh->uservert, points.data(), static_cast<int>(points.size()));
  mjs_setInt(mesh->userface, corners.data(), static_cast<int>(corners.size()));
  mesh->inertia = mjMESH_INERTIA_SHELL;  // is defined for every mesh, even an open one
}

mjsMesh* add_mesh(mjSpec* spec, const std::string& name, const TriMesh& mesh) {
  mjsMesh* added = mjs_addMesh(spec, nullptr);
  mjs_setName(added->element, name.c_str());
  fill_mesh(added, mesh.vertices(), mesh.faces());
  return added;
}

mjsGeom* add_contact_geom(mjsBody* body) {
  mjsGeom* geom = mjs_addGeom(body, nullptr);
  geom->condim = 1;  // no friction
  geom->contype = geom->conaffinity = 1;
  // Negative values are stiffness and damping. Both are almost 0, so the contact has no compliance of its own.
  geom->solref[0] = geom->solref[1] = -1e-9;
  geom->solimp[0] = geom->solimp[1] = kFullImpedance;
  return geom;
}

mjtGeom geom_type(ShapeType type) {
  switch (type) {
    case ShapeType::plane:
      return mjGEOM_PLANE;
    case ShapeType::sphere:
      return mjGEOM_SPHERE;
    case ShapeType::capsule:
      return mjGEOM_CAPSULE;
    case ShapeType::ellipsoid:
      return mjGEOM_ELLIPSOID;
    case ShapeType::cylinder:
      return mjGEOM_CYLINDER;
    case ShapeType::box:
      return mjGEOM_BOX;
    default:
      return mjGEOM_MESH;
  }
}

void add_object(mjSpec* spec, const std::string& name, const Shape* shape, const TriMesh* sensor_mesh) {
  mjsBody* body = mjs_addBody(mjs_findBody(spec, "world"), nullptr);
  body->mocap = 1;
  mjsGeom* geom = add_contact_geom(body);
  mjs_setName(geom->element, name.c_str());
  const TriMesh* mesh = shape != nullptr && shape->mesh ? shape->mesh.get() : sensor_mesh;
  geom->type = shape != nullptr ? geom_type(shape->type) : mjGEOM_MESH;
  if (geom->type == mjGEOM_MESH) {
    add_mesh(spec, name, *mesh)->needsdf = 1;
    mjs_setString(geom->meshname, name.c_str());
    return;
  }
  set(geom->size, shape->size);
  if (geom->type == mjGEOM_PLANE) set(geom->size, dvec3(0, 0, 1));  // size 0 means an infinite plane
}

/// Adds the skin on three slide joints, with the spheres of the taxels. The mesh "taxels" must exist.
void add_sensor_body(mjSpec* spec, const SensorModel& model) {
  mjsBody* body = mjs_addBody(mjs_findBody(spec, "world"), nullptr);
  mjs_setName(body->element, "sensor");
  body->mass = 1;
  body->explicitinertial = 1;
  set(body->inertia, dvec3(1));
  for (const dvec3& axis : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)}) {
    mjsJoint* slide = mjs_addJoint(body, nullptr);
    slide->type = mjJNT_SLIDE;
    set(slide->axis, axis);
  }
  add_mesh(spec, "skin", model.skin->mesh());
  mjsGeom* skin = add_contact_geom(body);
  skin->type = mjGEOM_MESH;
  mjs_setString(skin->meshname, "skin");
  mjsGeom* taxels = mjs_addGeom(body, nullptr);
  taxels->type = mjGEOM_MESH;
  taxels->contype = taxels->conaffinity = 0;
  mjs_setName(taxels->element, "taxels");
  mjs_setString(taxels->meshname, "taxels");
  for (std::size_t k = 0; k < model.layout.taxels.size(); ++k) {
    const Taxel& taxel = model.layout.taxels[k];
    const std::string name = fmt::format("taxel{}", k);
    mjsSite* site = mjs_addSite(body, nullptr);
    mjs_setName(site->element, name.c_str());
    site->type = mjGEOM_SPHERE;
    set(site->pos, taxel.center);
    set(site->size, dvec3(taxel.radius));
    mjsSensor* touch = mjs_addSensor(spec);
    mjs_setName(touch->element, name.c_str());
    touch->type = mjSENS_TOUCH;
    touch->objtype = mjOBJ_SITE;
    mjs_setString(touch->objname, name.c_str());
  }
  mjsSensor* tactile = mjs_addSensor(spec);
  mjs_setName(tactile->element, "depth");
  tactile->type = mjSENS_TACTILE;
  tactile->objtype = mjOBJ_MESH;
  mjs_setString(tactile->objname, "taxels");
  tactile->reftype = mjOBJ_GEOM;
  mjs_setString(tactile->refname, "taxels");
}

std::string numbered_object(std::size_t number) {
  return fmt::format("object{}", number);
}

}  // namespace

/// Adds the mesh of the tactile sensor. MuJoCo requires a mesh with a volume, so a tetrahedron in the middle of the
/// vertices is added.
void MujocoSensors::add_taxel_mesh(mjSpec* spec, const SensorModel& model) {
  const ReceptiveFields& fields = model.fields;
  for (std::size_t k = 0; k < taxels_; ++k) {
    const bool sampled = k + 1 < fields.first.size() && fields.first[k] < fields.first[k + 1];
    if (!sampled) {
      vertices_.push_back({model.layout.taxels[k].center, k, 1.0});
      continue;
    }
    const auto first = static_cast<std::size_t>(fields.first[k]), last = static_cast<std::size_t>(fields.first[k + 1]);
    const std::size_t begin = vertices_.size(), stride = 1 + (last - first) / kMostVertices;
    double sum = 0;
    for (std::size_t e = first; e < last; e += stride) {
      const ReceptiveFields::Entry& entry = fields.entries[e];
      vertices_.push_back({model.samples[static_cast<std::size_t>(entry.sample)].position, k, entry.weight});
      sum += entry.weight;
    }
    for (std::size_t i = begin; i < vertices_.size(); ++i) vertices_[i].share /= sum > 0 ? sum : 1.0;
  }
  std::vector<dvec3> all;
  for (const Vertex& vertex : vertices_) all.push_back(vertex.at);
  const int n = static_cast<int>(all.size());
  const Aabb& box = model.mesh->bounds();
  for (const dvec3& corner : {dvec3(0), dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)})
    all.push_back(box.center() + 0.25 * box.diagonal() * corner);
  mjsMesh* mesh = mjs_addMesh(spec, nullptr);
  mjs_setName(mesh->element, "taxels");
  fill_mesh(mesh, all, {{n, n + 2, n + 1}, {n, n + 1, n + 3}, {n, n + 3, n + 2}, {n + 1, n + 2, n + 3}});
}

MujocoSensors::MujocoSensors(const SensorModel& model, const std::vector<TouchedBody>& touched,
                             const std::vector<SensorModelPtr>& sensors)
    : taxels_(model.layout.taxels.size()) {
  const SpecHandle spec(mj_makeSpec());
  set(spec->option.gravity, dvec3(0));
  add_taxel_mesh(spec.get(), model);
  add_sensor_body(spec.get(), model);
  for (std::size_t i = 0; i < touched.size(); ++i) {
    if (touched[i].body == nullptr) continue;
    const TriMesh* mesh =
        touched[i].sensor >= 0 ? sensors[static_cast<std::size_t>(touched[i].sensor)]->mesh.get() : nullptr;
    add_object(spec.get(), numbered_object(i), touched[i].shape.get(), mesh);
  }
  model_.reset(mj_compile(spec.get(), nullptr));
  if (model_ == nullptr) throw Error(fmt::format("MuJoCo refuses the bodies: {}", mjs_getError(spec.get())));
  data_.reset(mj_makeData(model_.get()));
  if (data_ == nullptr) throw Error("MuJoCo cannot make the data of the bodies");
  sensor_body_ = mj_name2id(model_.get(), mjOBJ_BODY, "sensor");
  touches_ = model_->sensor_adr[mj_name2id(model_.get(), mjOBJ_SENSOR, "taxel0")];
  const int depth = mj_name2id(model_.get(), mjOBJ_SENSOR, "depth");
  depths_ = model_->sensor_adr[depth];
  if (model_->sensor_dim[depth] != static_cast<int>(3 * (vertices_.size() + 4)))
    throw Error("MuJoCo has changed the vertices of the taxels' mesh");
  for (std::size_t i = 0; i < touched.size(); ++i) {
    const int geom = mj_name2id(model_.get(), mjOBJ_GEOM, numbered_object(i).c_str());
    geoms_.push_back(geom);
    mocaps_.push_back(geom < 0 ? -1 : model_->body_mocapid[model_->geom_bodyid[geom]]);
    if (geom >= 0) model_->geom_contype[geom] = model_->geom_conaffinity[geom] = 0;
  }
}

void MujocoSensors::place(const Pose& X_WM, const std::vector<Pose>& X_WB) {
  mj_resetData(model_.get(), data_.get());  // clears the previous step, also the warm start of the solver
  set(model_->body_pos + 3 * sensor_body_, X_WM.p);
  set(model_->body_quat + 4 * sensor_body_, X_WM.q);
  for (std::size_t i = 0; i < mocaps_.size(); ++i) {
    if (mocaps_[i] < 0) continue;
    set(data_->mocap_pos + 3 * mocaps_[i], X_WB[i].p);
    set(data_->mocap_quat + 4 * mocaps_[i], X_WB[i].q);
  }
}

void MujocoSensors::add_pair(std::size_t body, const dvec3& load_W, std::vector<double>& depths, MujocoReadings& out) {
  const int geom = geoms_[body];
  model_->geom_contype[geom] = model_->geom_conaffinity[geom] = 1;
  set(data_->xfrc_applied + 6 * sensor_body_, -load_W);
  mj_forward(model_.get(), data_.get());
  model_->geom_contype[geom] = model_->geom_conaffinity[geom] = 0;
  for (std::size_t k = 0; k < taxels_; ++k) out.touch[k] += data_->sensordata[static_cast<std::size_t>(touches_) + k];
  for (std::size_t i = 0; i < depths.size(); ++i)
    depths[i] = std::max(depths[i], data_->sensordata[static_cast<std::size_t>(depths_) + i]);
}

MujocoReadings MujocoSensors::read(const Pose& X_WM, const std::vector<Pose>& X_WB, const std::vector<dvec3>& load_W) {
  MujocoReadings out{std::vector<double>(taxels_, 0.0), std::vector<double>(taxels_, 0.0)};
  std::vector<double> depths(vertices_.size(), 0.0);
  for (std::size_t i = 0; i < geoms_.size(); ++i) {
    if (geoms_[i] < 0 || load_W[i] == dvec3(0)) continue;
    place(X_WM, X_WB);
    add_pair(i, load_W[i], depths, out);
  }
  for (std::size_t i = 0; i < depths.size(); ++i) out.depth[vertices_[i].taxel] += vertices_[i].share * depths[i];
  return out;
}

namespace {

/// Returns the reading of the paper's released code, sum of w p, over the layout's own hits.
std::vector<double> weighted_sum_of(const SensorModel& model, std::span<const RayHit> hits) {
  RayHits again;
  again.clear(model.rays.size());
  for (std::size_t ray = 0; ray < hits.size(); ++ray)
    if (hits[ray].hit()) again.offer(static_cast<std::int32_t>(ray), hits[ray]);
  again.finish();
  std::vector<double> sums;
  aggregate(model, again, Aggregate::weighted_sum, sums);
  return sums;
}

}  // namespace

ModelComparison::~ModelComparison() = default;

ModelComparison::ModelComparison(std::shared_ptr<const SimScene> scene, std::size_t sensor, Progress* progress)
    : scene_(std::move(scene)), sensor_(sensor) {
  if (sensor_ >= scene_->sensors.size() || !scene_->sensors[sensor_])
    throw Error(fmt::format("there is no sensor {}, the scene has {}", sensor_, scene_->sensors.size()));
  const SensorModel& model = *scene_->sensors[sensor_];
  no_star_ = no_mujoco_ = missing_touched(*scene_);
  if (!no_star_.empty()) return;
  try {
    if (!model.layout.material.compliant()) throw Error("the sensor is rigid: it has no pressure field");
    Layout layout = model.layout;
    layout.material.field = FieldKind::star;
    SensorBuild how(progress);
    how.quality = model.quality;
    star_ = build_sensor_model(layout, model.loaded, "", layout.name, how);
  } catch (const Error& error) {
    no_star_ = error.message();
  }
  try {
    if (model.layout.taxels.empty()) throw Error("there are no taxels");
    mujoco_ = std::make_unique<MujocoSensors>(model, scene_->touched[sensor_], scene_->sensors);
  } catch (const Error& error) {
    no_mujoco_ = error.message();
  }
}

ModelReading ModelComparison::read_star(const StepView& step) const {
  if (!star_) return {ReadingModel::star, {}, no_star_};
  return read_in_place(ReadingModel::star, *star_, scene_->touched[sensor_], step, sensor_);
}

ModelReading ModelComparison::read_exact(const SensorView& view) const {
  const SensorModel& model = *scene_->sensors[sensor_];
  ModelReading out{ReadingModel::exact, {}, ""};
  std::vector<ExactReading> found(model.layout.taxels.size());
  parallel_chunks(model.taxel_count(), 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) found[static_cast<std::size_t>(k)] = exact_reading(model, k, view.surfaces);
  });
  for (std::size_t k = 0; k < found.size(); ++k) {
    out.values.push_back(found[k].value.value_or(std::nan("")));
    if (!found[k].value && out.missing.empty())
      out.missing = fmt::format("taxel {}: {}", model.layout.taxels[k].id, found[k].missing);
  }
  return out;
}

void ModelComparison::read_mujoco(const StepView& step, ModelReading& depth, ModelReading& touch) {
  depth.missing = touch.missing = no_mujoco_;
  if (!mujoco_) return;
  const std::vector<TouchedBody>& touched = scene_->touched[sensor_];
  const auto [X_WB, unknown] = touched_poses(step, sensor_);
  const Pose& X_WM = step.sensors[sensor_].X_WM;
  std::vector<dvec3> load_W(touched.size(), dvec3(0));
  IntersectWorkspace workspace;
  ContactSurface surface;
  for (std::size_t i = 0; i < touched.size(); ++i) {
    if (touched[i].body == nullptr) continue;
    intersect_touched(*scene_->sensors[sensor_]->body, touched[i], X_WM, X_WB[i], surface, workspace);
    load_W[i] = X_WM.rotate(pressure_wrench(surface).force);
  }
  MujocoReadings found = mujoco_->read(X_WM, X_WB, load_W);
  depth.values = std::move(found.depth);
  touch.values = std::move(found.touch);
  depth.missing = touch.missing = unknown;
}

ModelReadings ModelComparison::read(const StepView& step) {
  const SensorView& view = step.sensors[sensor_];
  ModelReading depth{ReadingModel::tactile, {}, ""}, touch{ReadingModel::touch, {}, ""};
  read_mujoco(step, depth, touch);
  return {{{ReadingModel::reading, {view.readings.begin(), view.readings.end()}, ""},
           read_star(step),
           {ReadingModel::weighted_sum, weighted_sum_of(*scene_->sensors[sensor_], view.hits), ""},
           read_exact(view),
           std::move(depth),
           std::move(touch)},
          {}};
}

}  // namespace taxel
