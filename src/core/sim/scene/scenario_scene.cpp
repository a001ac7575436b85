#include "core/sim/scene/scenario_scene.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/document/paper_setting.h"
#include "core/document/scenario/scenario.h"
#include "core/hydro/hydro_body.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repair.h"
#include "core/run/motion/motion.h"
#include "core/sim/scene/inertia.h"
#include "core/sim/scene/loaded_scene.h"

namespace taxel {
namespace {

constexpr const char* kFingerMesh = "finger.obj";
constexpr const char* kLayoutFile = "finger.taxels.json";
constexpr const char* kObjectMesh = "object.obj";
constexpr double kPlateThickness = 0.1;  // fraction of the plate's side
constexpr double kFriction = 0.5;        // Coulomb's coefficient of all objects except the demo's box

std::string text(const dvec3& v) {
  return fmt::format("{} {} {}", v.x, v.y, v.z);
}
std::string text(const dquat& q) {
  return fmt::format("{} {} {} {}", q.w, q.x, q.y, q.z);
}

/// The object as MJCF (asset and geom), with its bounds in the world.
struct Object {
  std::string asset, geom;
  Aabb bounds;
};

/// Returns the attributes that all objects have. `friction` is Coulomb's coefficient.
std::string common_attributes(double friction) {
  return fmt::format(R"(contype="0" conaffinity="0" friction="{} 0.005 0.0001" rgba="0.55 0.6 0.68 1"/>)", friction);
}

Object primitive_object(const char* type, const std::string& size, const Aabb& bounds, double friction) {
  return {"",
          fmt::format(R"(<geom name="{}" type="{}" size="{}" pos="{}" {})", kObjectGeom, type, size,
                      text(bounds.center()), common_attributes(friction)),
          bounds};
}

/// Returns an object with a mesh. `offset` moves the mesh to its place in the world.
Object mesh_object(const TriMesh& mesh, const dvec3& offset, std::vector<SceneFile>& files) {
  files.push_back({kObjectMesh, write_obj(mesh)});
  return {fmt::format("\n    <mesh name=\"{}\" file=\"{}\" inertia=\"shell\"/>", kObjectGeom, kObjectMesh),
          fmt::format(R"(<geom name="{0}" type="mesh" mesh="{0}" pos="{1}" {2})", kObjectGeom, text(offset),
                      common_attributes(kFriction)),
          {mesh.bounds().lo + offset, mesh.bounds().hi + offset}};
}

/// Loads the object's mesh and repairs it, so that it lies where its sound part is. Adds a sentence to `repairs` if it
/// was repaired.
TriMeshPtr load_object(const std::string& file, std::vector<std::string>& repairs) {
  Shape shape;
  shape.type = ShapeType::mesh;
  shape.mesh = load_mesh(file).mesh;
  try {
    if (const RepairedMeshPtr repaired = repair_touched_mesh(shape, {}, TouchedRepair::automatic))
      repairs.push_back(file + ": " + repair_summary(repaired->report));
  } catch (const Error& error) {
    throw Error(file, "", error.message());
  }
  return shape.mesh;
}

/// Returns the bounds of an object without a mesh file: it begins at x = 0 and at z = 0, and y = 0 is its middle.
Aabb bounds_of(const dvec3& extent) {
  return {{0, -0.5 * extent.y, 0}, {extent.x, 0.5 * extent.y, extent.z}};
}

Object make_object(const Scenario& s, ScenarioScene& scene) {
  std::vector<SceneFile>& files = scene.files.files;
  if (s.is<scenarios::Paper>()) return primitive_object("box", text(0.5 * kDemoBox.extent()), kDemoBox, kPaperFriction);
  if (!s.object.empty()) {
    const TriMeshPtr mesh = load_object(s.object, scene.repairs);
    const Aabb& box = mesh->bounds();
    return mesh_object(*mesh, {-box.lo.x, -box.center().y, -box.lo.z}, files);
  }
  const double size = s.box_size;
  switch (s.shape) {
    case ObjectShape::edge: {
      Object edge = mesh_object(make_upright_edge(size, s.edge_radius), dvec3(0), files);
      edge.bounds.hi.z = std::sqrt(2.0) * size - height_of_round(s.edge_radius);  // of the round, not of its strips
      return edge;
    }
    case ObjectShape::plate: {
      const dvec3 extent(size, size, kPlateThickness * size);
      return primitive_object("box", text(0.5 * extent), bounds_of(extent), kFriction);
    }
    case ObjectShape::sphere:
      return primitive_object("sphere", fmt::format("{}", 0.5 * size), bounds_of(dvec3(size)), kFriction);
    default:
      return primitive_object("box", text(dvec3(0.5 * size)), bounds_of(dvec3(size)), kFriction);
  }
}

std::string inertial(const TriMesh& skin, double mass) {
  const Inertia body = solid_inertia(skin, mass);
  const dmat3& I = body.moment;
  return fmt::format(R"(<inertial mass="{}" pos="{}" fullinertia="{} {} {} {} {} {}"/>)", body.mass, text(body.center),
                     I[0][0], I[1][1], I[2][2], I[1][0], I[2][0], I[2][1]);
}

/// MJCF of the mocap body that leads the finger, or nothing if the finger falls. A led finger has no gravity, because
/// the weld would sag.
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

/// Returns the MJCF of the whole scene. `sensor` has the plugin keys that give the layout.
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
      fmt::arg("title", title_of(s.kind())), fmt::arg("timestep", motion.timestep), fmt::arg("top", object.bounds.hi.z),
      fmt::arg("extent", 2.0 * object.bounds.hi.z), fmt::arg("sensor", sensor), fmt::arg("finger", kFingerGeom),
      fmt::arg("object", kObjectGeom), fmt::arg("mesh", kFingerMesh), fmt::arg("object_asset", object.asset),
      fmt::arg("object_geom", object.geom), fmt::arg("lead", lead.body), fmt::arg("weld", lead.weld),
      fmt::arg("gravity", lead.gravity), fmt::arg("pos", text(motion.X_start.p)),
      fmt::arg("quat", text(motion.X_start.q)), fmt::arg("inertial", inertial(model.skin->mesh(), s.finger_mass)));
}

}  // namespace

void check_has_taxels(const SensorModel& model, const std::string& file) {
  if (model.taxel_count() > 0) return;
  throw Error(
      file, "/taxels",
      "has none: a scenario has nothing to read. Place taxels on the mesh with taxelstudio, or use the layout of "
      "a known sensor (taxel presets NAME --out FILE) or a sensor YAML (--layout SENSOR.yaml --mesh MESH)");
}

ScenarioScene build_scenario_scene(const SensorModel& model, const Scenario& scenario) {
  check_has_taxels(model, model.layout.name);
  check_scenario(scenario);
  ScenarioScene scene;
  const std::string mesh = write_obj(*model.mesh);
  Layout layout = layout_on_repaired_mesh(model);
  layout.mesh = {kFingerMesh, dvec3(1), sha256_hex(mesh), layout.mesh.repair};
  scene.files.files = {{kFingerMesh, mesh}, {kLayoutFile, layout_to_json(layout)}};
  const Object object = make_object(scenario, scene);
  scene.motion = make_motion(model.skin->mesh(), model.layout.frame, scenario, object.bounds);
  const auto xml = [&](const std::string& keys) { return scene_xml(model, scenario, scene.motion, object, keys); };
  scene.files.xml = xml(fmt::format(R"(<config key="layout" value="{}"/>)", kLayoutFile));
  scene.hosted_xml = xml(hosted_keys(model));
  return scene;
}

}  // namespace taxel
