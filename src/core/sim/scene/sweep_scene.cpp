#include "core/sim/scene/sweep_scene.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/layout/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/sim/scene/inertia.h"

namespace taxel {
namespace {

constexpr const char* kFingerMesh = "finger.obj";
constexpr const char* kLayoutFile = "finger.taxels.json";
constexpr const char* kObjectMesh = "object.obj";

std::string text(const dvec3& v) {
  return fmt::format("{} {} {}", v.x, v.y, v.z);
}
std::string text(const dquat& q) {
  return fmt::format("{} {} {} {}", q.w, q.x, q.y, q.z);
}

void check(const SweepScenario& s) {
  const auto positive = [](double value, const char* name) {
    if (!(value > 0) || !std::isfinite(value))
      throw Error("", std::string("/") + name, fmt::format("must be greater than 0, is {}", value));
  };
  positive(s.depth, "depth");
  positive(s.speed, "speed");
  positive(s.record_every, "record_every");
  positive(s.timestep, "timestep");
  positive(s.finger_mass, "finger_mass");
  positive(s.box_size, "box_size");
  positive(s.before + s.past, "past");
  if (!std::isfinite(s.tilt_deg)) throw Error("", "/tilt_deg", "must be a number");
}

/// R_WM: `distal` forward and down by the tilt, `pad` down and back.
dquat finger_orientation(const SensorFrame& frame, double tilt_deg) {
  const dvec3 distal = glm::normalize(frame.distal);
  const dvec3 pad = glm::normalize(frame.pad - glm::dot(frame.pad, distal) * distal);
  const double tilt = tilt_deg * kPi / 180.0, c = std::cos(tilt), s = std::sin(tilt);
  const dmat3 axes_M(distal, pad, glm::cross(distal, pad));
  const dmat3 axes_W(dvec3(c, 0, -s), dvec3(-s, 0, -c), dvec3(0, 1, 0));
  return glm::normalize(glm::quat_cast(axes_W * glm::transpose(axes_M)));
}

/// Where the finger's frame must be for its lowest point to be at `place`, the middle of its width at y = 0.
Pose place_finger(const TriMesh& skin, const dquat& q, const dvec3& place) {
  const RigidTransform R(Pose{q, dvec3(0)});
  Aabb box;
  dvec3 lowest(0, 0, std::numeric_limits<double>::infinity());
  for (const dvec3& v : skin.vertices()) {
    const dvec3 p = R(v);
    box.include(p);
    if (p.z < lowest.z) lowest = p;
  }
  return {q, place - dvec3(lowest.x, box.center().y, lowest.z)};
}

/// The object as MJCF (asset, geom), with its height; its bounds begin at x = 0 and z = 0, its middle is at y = 0.
struct Object {
  std::string asset, geom;
  double top = 0;
};
Object make_object(const SweepScenario& s, std::vector<SceneFile>& files) {
  const std::string common = R"(contype="0" conaffinity="0" friction="0.5 0.005 0.0001" rgba="0.55 0.6 0.68 1"/>)";
  if (s.object.empty()) {
    const double half = 0.5 * s.box_size;
    return {"",
            fmt::format(R"(<geom name="{}" type="box" size="{}" pos="{}" {})", kObjectGeom, text(dvec3(half)),
                        text(dvec3(half, 0, half)), common),
            s.box_size};
  }
  const TriMeshPtr mesh = load_mesh(s.object).mesh;
  const Aabb& box = mesh->bounds();
  files.push_back({kObjectMesh, obj_text(*mesh)});
  return {fmt::format("\n    <mesh name=\"{}\" file=\"{}\" inertia=\"shell\"/>", kObjectGeom, kObjectMesh),
          fmt::format(R"(<geom name="{0}" type="mesh" mesh="{0}" pos="{1}" {2})", kObjectGeom,
                      text(dvec3(-box.lo.x, -box.center().y, -box.lo.z)), common),
          box.extent().z};
}

std::string inertial(const TriMesh& skin, double mass) {
  const Inertia body = solid_inertia(skin, mass);
  const dmat3& I = body.moment;
  return fmt::format(R"(<inertial mass="{}" pos="{}" fullinertia="{} {} {} {} {} {}"/>)", body.mass, text(body.center),
                     I[0][0], I[1][1], I[2][2], I[1][0], I[2][0], I[2][1]);
}

/// `sensor` is the key that says where the layout comes from. No gravity on the finger: the weld would sag.
std::string scene_xml(const SensorModel& model, const SweepScenario& s, const Pose& X_start, const Object& object,
                      const std::string& sensor) {
  return fmt::format(R"(<mujoco model="fingertip sweep">
  <option timestep="{timestep}"/>
  <statistic center="0 0 {top}" extent="{extent}"/>
  <extension>
    <plugin plugin="taxel.sensor">
      <instance name="finger">
        {sensor}
        <config key="geom" value="{finger}"/>
        <config key="others" value="{object}"/>
      </instance>
    </plugin>
  </extension>
  <asset>
    <mesh name="{finger}" file="{mesh}" inertia="shell"/>{object_asset}
  </asset>
  <worldbody>
    <light pos="-0.2 -0.3 0.5" dir="0.4 0.6 -1"/>
    {object_geom}
    <body name="mocap" mocap="true" pos="{pos}" quat="{quat}"/>
    <body name="finger" pos="{pos}" quat="{quat}" gravcomp="1">
      <freejoint/>
      {inertial}
      <geom name="{finger}" type="mesh" mesh="{finger}" contype="0" conaffinity="0" rgba="0.86 0.7 0.6 1"/>
    </body>
  </worldbody>
  <equality>
    <weld name="hold" body1="mocap" body2="finger" solref="0.002 1"/>
  </equality>
  <sensor>
    <plugin name="taxels" plugin="taxel.sensor" instance="finger"/>
  </sensor>
</mujoco>
)",
                     fmt::arg("timestep", s.timestep), fmt::arg("top", object.top),
                     fmt::arg("extent", 2.0 * object.top), fmt::arg("sensor", sensor), fmt::arg("finger", kFingerGeom),
                     fmt::arg("object", kObjectGeom), fmt::arg("mesh", kFingerMesh),
                     fmt::arg("object_asset", object.asset), fmt::arg("object_geom", object.geom),
                     fmt::arg("pos", text(X_start.p)), fmt::arg("quat", text(X_start.q)),
                     fmt::arg("inertial", inertial(model.skin->mesh(), s.finger_mass)));
}

}  // namespace

SweepScene build_sweep_scene(const SensorModel& model, const SweepScenario& scenario) {
  check(scenario);
  SweepScene scene;
  const std::string mesh = obj_text(*model.mesh);
  Layout layout = model.layout;
  layout.mesh = {kFingerMesh, dvec3(1), sha256_hex(mesh)};
  scene.files.files = {{kFingerMesh, mesh}, {kLayoutFile, layout_to_json(layout)}};
  const Object object = make_object(scenario, scene.files.files);
  scene.lowest_start_W = {-scenario.before, 0, object.top - scenario.depth};
  scene.distance = scenario.before + scenario.past;
  scene.X_start =
      place_finger(model.skin->mesh(), finger_orientation(model.layout.frame, scenario.tilt_deg), scene.lowest_start_W);
  const auto xml = [&](const std::string& key, const std::string& value) {
    return scene_xml(model, scenario, scene.X_start, object,
                     fmt::format(R"(<config key="{}" value="{}"/>)", key, value));
  };
  scene.files.xml = xml("layout", kLayoutFile);
  scene.hosted_xml = xml("taxels", fmt::format("{}", model.taxel_count()));
  return scene;
}

}  // namespace taxel
