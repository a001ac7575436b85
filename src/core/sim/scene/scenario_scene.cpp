#include "core/sim/scene/scenario_scene.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/layout/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/project/scenario_json.h"
#include "core/sim/scene/inertia.h"

namespace taxel {
namespace {

constexpr const char* kFingerMesh = "finger.obj";
constexpr const char* kLayoutFile = "finger.taxels.json";
constexpr const char* kObjectMesh = "object.obj";
constexpr double kPlateThickness = 0.1;  // of its sides

std::string text(const dvec3& v) {
  return fmt::format("{} {} {}", v.x, v.y, v.z);
}
std::string text(const dquat& q) {
  return fmt::format("{} {} {} {}", q.w, q.x, q.y, q.z);
}

/// The object as MJCF (asset, geom), with its bounds, which begin at x = 0 and z = 0 and have y = 0 in the middle.
struct Object {
  std::string asset, geom;
  Aabb bounds;
};
Object make_object(const Scenario& s, std::vector<SceneFile>& files) {
  const std::string common = R"(contype="0" conaffinity="0" friction="0.5 0.005 0.0001" rgba="0.55 0.6 0.68 1"/>)";
  const auto placed = [](const dvec3& extent) {
    return Aabb{{0, -0.5 * extent.y, 0}, {extent.x, 0.5 * extent.y, extent.z}};
  };
  if (s.object.empty()) {
    const bool sphere = s.shape == ObjectShape::sphere;
    dvec3 extent(s.box_size);
    if (s.shape == ObjectShape::plate) extent.z = kPlateThickness * s.box_size;
    const Aabb bounds = placed(extent);
    const std::string size = sphere ? fmt::format("{}", 0.5 * s.box_size) : text(0.5 * extent);
    return {"",
            fmt::format(R"(<geom name="{}" type="{}" size="{}" pos="{}" {})", kObjectGeom, sphere ? "sphere" : "box",
                        size, text(bounds.center()), common),
            bounds};
  }
  const TriMeshPtr mesh = load_mesh(s.object).mesh;
  const Aabb& box = mesh->bounds();
  files.push_back({kObjectMesh, obj_text(*mesh)});
  return {fmt::format("\n    <mesh name=\"{}\" file=\"{}\" inertia=\"shell\"/>", kObjectGeom, kObjectMesh),
          fmt::format(R"(<geom name="{0}" type="mesh" mesh="{0}" pos="{1}" {2})", kObjectGeom,
                      text(dvec3(-box.lo.x, -box.center().y, -box.lo.z)), common),
          placed(box.extent())};
}

std::string inertial(const TriMesh& skin, double mass) {
  const Inertia body = solid_inertia(skin, mass);
  const dmat3& I = body.moment;
  return fmt::format(R"(<inertial mass="{}" pos="{}" fullinertia="{} {} {} {} {} {}"/>)", body.mass, text(body.center),
                     I[0][0], I[1][1], I[2][2], I[1][0], I[2][0], I[2][1]);
}

/// What leads the finger, on which no gravity acts then: the weld would sag. Or nothing: it falls.
struct Lead {
  std::string body, weld, gravity;
};
Lead make_lead(const Motion& motion) {
  if (!motion.pose) return {};
  return {fmt::format("\n    <body name=\"mocap\" mocap=\"true\" pos=\"{}\" quat=\"{}\"/>", text(motion.X_start.p),
                      text(motion.X_start.q)),
          R"(
  <equality>
    <weld name="hold" body1="mocap" body2="finger" solref="0.002 1"/>
  </equality>)",
          R"( gravcomp="1")"};
}

std::string title_of(ScenarioKind kind) {
  return "fingertip " + std::string(to_word(kind));
}

/// `sensor` is the key that says where the layout comes from.
std::string scene_xml(const SensorModel& model, const Scenario& s, const Motion& motion, const Object& object,
                      const std::string& sensor) {
  const Lead lead = make_lead(motion);
  return fmt::format(
      R"(<mujoco model="{title}">
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
    {object_geom}{lead}
    <body name="finger" pos="{pos}" quat="{quat}"{gravity}>
      <freejoint/>
      {inertial}
      <geom name="{finger}" type="mesh" mesh="{finger}" contype="0" conaffinity="0" rgba="0.86 0.7 0.6 1"/>
    </body>
  </worldbody>{weld}
  <sensor>
    <plugin name="taxels" plugin="taxel.sensor" instance="finger"/>
  </sensor>
</mujoco>
)",
      fmt::arg("title", title_of(s.kind)), fmt::arg("timestep", motion.timestep), fmt::arg("top", object.bounds.hi.z),
      fmt::arg("extent", 2.0 * object.bounds.hi.z), fmt::arg("sensor", sensor), fmt::arg("finger", kFingerGeom),
      fmt::arg("object", kObjectGeom), fmt::arg("mesh", kFingerMesh), fmt::arg("object_asset", object.asset),
      fmt::arg("object_geom", object.geom), fmt::arg("lead", lead.body), fmt::arg("weld", lead.weld),
      fmt::arg("gravity", lead.gravity), fmt::arg("pos", text(motion.X_start.p)),
      fmt::arg("quat", text(motion.X_start.q)), fmt::arg("inertial", inertial(model.skin->mesh(), s.finger_mass)));
}

}  // namespace

ScenarioScene build_scenario_scene(const SensorModel& model, const Scenario& scenario) {
  check_scenario(scenario);
  ScenarioScene scene;
  const std::string mesh = obj_text(*model.mesh);
  Layout layout = layout_on_repaired_mesh(model);
  layout.mesh = {kFingerMesh, dvec3(1), sha256_hex(mesh), layout.mesh.repair};
  scene.files.files = {{kFingerMesh, mesh}, {kLayoutFile, layout_to_json(layout)}};
  const Object object = make_object(scenario, scene.files.files);
  scene.motion = make_motion(model.skin->mesh(), model.layout.frame, scenario, object.bounds);
  const auto xml = [&](const std::string& key, const std::string& value) {
    return scene_xml(model, scenario, scene.motion, object,
                     fmt::format(R"(<config key="{}" value="{}"/>)", key, value));
  };
  scene.files.xml = xml("layout", kLayoutFile);
  scene.hosted_xml = xml("taxels", fmt::format("{}", model.taxel_count()));
  return scene;
}

}  // namespace taxel
