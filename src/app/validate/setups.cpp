#include "app/validate/setups.h"

#include <fmt/format.h>

#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/make/primitives.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/plugin/plugin_table.h"
#include "core/sim/scene/inertia.h"
#include "core/sim/scene/loaded_scene.h"

namespace taxel {

Layout FlatPatch::layout(double samples, std::uint64_t seed, SampleWeights weights) {
  Layout layout;
  layout.mesh.file = "plate";
  layout.sampling.density = samples / (kPi * kRadius * kRadius);
  layout.sampling.seed = seed;
  layout.sampling.weights = weights;
  layout.material.thickness = 0.8 * kThickness;
  layout.readout.max_depth = kThickness;
  for (int j = -3; j <= 3; ++j) {
    for (int i = -3; i <= 3; ++i) {
      Taxel taxel;
      taxel.id = static_cast<int>(layout.taxels.size());
      taxel.center = dvec3(0.00201 * i, 0.00203 * j, 0.5 * kThickness);
      taxel.radius = kRadius;
      layout.taxels.push_back(taxel);
    }
  }
  return layout;
}

SensorModelPtr FlatPatch::model(const Layout& layout) {
  const auto plate = std::make_shared<TriMesh>(make_box(dvec3(kHalf, kHalf, 0.5 * kThickness)));
  return build_sensor_model(layout, plate, "", "plate");
}

namespace {

constexpr const char* kName = "closed form of dynamics";
constexpr const char* kMeshFile = "skin.obj";

/// Returns a layout with one taxel at the bottom of the skin, whose reading is not used.
SensorModelPtr sensor_of(const SoftOnFloor& setup) {
  Layout layout;
  layout.name = kName;
  layout.mesh.file = kMeshFile;
  layout.material = setup.material;
  const double depth = -setup.skin->bounds().lo.z;
  layout.sampling.density = 100 / (kPi * depth * depth);
  Taxel taxel;
  taxel.center = {0, 0, -depth};
  taxel.normal = {0, 0, -1};
  taxel.radius = depth;
  layout.taxels = {taxel};
  return build_sensor_model(layout, setup.skin, "", kName);
}

/// Returns the MJCF; `keys` are those of the sensor that is handed over.
std::string scene_xml(const SoftOnFloor& s, const std::string& keys) {
  const dmat3 I = solid_inertia(*s.skin, s.mass).moment;
  return fmt::format(R"(<mujoco model="{name}">
  <option timestep="{timestep}" integrator="{integrator}" gravity="{gx} {gy} {gz}"><flag energy="enable"/></option>
  <extension><plugin plugin="taxel.sensor"><instance name="skin">
    {keys}<config key="geom" value="skin"/><config key="others" value="floor"/>
  </instance></plugin></extension>
  <asset><mesh name="skin" file="skin.obj"/></asset>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 1" contype="0" conaffinity="0" friction="{friction}"/>
    <body pos="0 0 {start}"><freejoint/>
      <inertial mass="{mass}" pos="0 0 {center}" diaginertia="{Ix} {Iy} {Iz}"/>
      <geom name="skin" type="mesh" mesh="skin" contype="0" conaffinity="0"/>
    </body>
  </worldbody>
  <sensor><plugin name="skin" plugin="taxel.sensor" instance="skin"/></sensor>
</mujoco>
)",
                     fmt::arg("name", kName), fmt::arg("keys", keys), fmt::arg("timestep", s.timestep),
                     fmt::arg("integrator", s.integrator), fmt::arg("gx", s.gravity.x), fmt::arg("gy", s.gravity.y),
                     fmt::arg("gz", s.gravity.z), fmt::arg("friction", s.material.friction), fmt::arg("start", s.start),
                     fmt::arg("mass", s.mass), fmt::arg("center", s.center), fmt::arg("Ix", I[0][0]),
                     fmt::arg("Iy", I[1][1]), fmt::arg("Iz", I[2][2]));
}

}  // namespace

SoftOnFloorRun::SoftOnFloorRun(const SoftOnFloor& setup) {
  register_sensor_plugin();
  const SensorModelPtr model = sensor_of(setup);
  scene_ = compile_scene(scene_xml(setup, hosted_keys(*model)), {{kMeshFile, write_obj(*setup.skin)}}, kName);
  data_.reset(mj_makeData(scene_.model.get()));
  if (data_ == nullptr) throw Error(kName, "MuJoCo cannot make the simulation data");
  instance_ = sensor_instances(*scene_.model).at(0);
  find_sensor(*data_, instance_)->hand_over(*scene_.model, model);
}

void SoftOnFloorRun::step(int count) {
  for (int i = 0; i < count; ++i) mj_step(scene_.model.get(), data_.get());
  const HydroInstance& sensor = *find_sensor(*data_, instance_);
  if (!sensor.contacts().failure.empty()) throw Error(kName, sensor.contacts().failure);
}

void SoftOnFloorRun::set_velocity(const dvec3& v) {
  for (int i = 0; i < 3; ++i) data_->qvel[i] = v[i];
}

dvec3 SoftOnFloorRun::spin_W() const {
  const dquat q(data_->qpos[3], data_->qpos[4], data_->qpos[5], data_->qpos[6]);
  return q * dvec3(data_->qvel[3], data_->qvel[4], data_->qvel[5]);
}

void SoftOnFloorRun::set_spin(const dvec3& w) {
  for (int i = 0; i < 3; ++i) data_->qvel[3 + i] = w[i];
}

double SoftOnFloorRun::energy() const {
  mj_fwdPosition(scene_.model.get(), data_.get());  // a step does not update derived positions
  mj_energyPos(scene_.model.get(), data_.get());
  mj_energyVel(scene_.model.get(), data_.get());
  return data_->energy[0] + data_->energy[1];
}

bool SoftOnFloorRun::touching() const {
  return !find_sensor(*data_, instance_)->sensed().pairs.at(0).surface.empty();
}

}  // namespace taxel
