#include "ui/scene/finger_scene.h"

#include "core/hydro/intersect.h"
#include "core/mesh/make/primitives.h"
#include "core/sensor/readout/reading.h"
#include "ui/scene/scene_parts.h"

namespace taxel::test {
namespace {

constexpr double kBoxHalf = 0.025;

/// Returns the rotation that turns `distal` of the finger (+z) 45 degrees downward and its pad (-y) towards the box
/// below.
dquat finger_tilt() {
  const double a = glm::radians(45.0);
  const dvec3 distal(std::cos(a), 0, -std::sin(a)), pad(-std::sin(a), 0, -std::cos(a));
  return glm::quat_cast(dmat3(glm::cross(-pad, distal), -pad, distal));
}

}  // namespace

SensorModelPtr finger_model(int samples) {
  const auto mesh = std::make_shared<const TriMesh>(make_fingertip());
  const MeshIndex index(mesh);
  Layout layout;
  layout.name = "test finger";
  layout.mesh.file = "finger.obj";
  layout.sampling.density = samples / mesh->area();
  const Aabb& box = mesh->bounds();
  const auto add = [&](double x, double y, double z) {  // from the finger's axis towards the skin
    const dvec3 axis(0, box.center().y, std::min(z, 0.62) * box.hi.z);
    const Ray out{axis, glm::normalize(dvec3(x, y, z > 0.62 ? 1.0 : 0.0)), 1.0};
    const auto hit = index.cast(out);
    Taxel taxel;
    taxel.id = static_cast<int>(layout.taxels.size()) + 1;
    taxel.center = axis + hit->t * out.direction;
    taxel.normal = mesh->face_normals()[static_cast<std::size_t>(hit->face)];
    layout.taxels.push_back(taxel);
  };
  for (const double side : {-1.0, 1.0}) {
    add(side * 0.4, -1, 0.2);
    add(side * 0.4, -1, 0.4);
    add(side * 0.4, -1, 0.6);
    add(side * 0.4, -1.2, 0.9);
    add(side, -0.1, 0.3);
    add(side, -0.1, 0.6);
  }
  return build_sensor_model(layout, mesh, "", "finger.taxels.json");
}

SimFramePtr finger_frame(const SensorModelPtr& model, double travel) {
  auto scene = std::make_shared<SimScene>();
  const auto box = std::make_shared<const TriMesh>(make_box(dvec3(kBoxHalf)));
  scene->title = "test sweep";
  const auto add_geom = [&](const char* name, const TriMeshPtr& mesh, const std::array<float, 4>& rgba, int sensor) {
    SceneGeom& geom = scene->geoms.emplace_back();
    geom.name = geom.body = name;
    geom.mesh = mesh;
    geom.rgba = rgba;
    geom.sensor = sensor;
  };
  add_geom("box", box, {0.55f, 0.57f, 0.60f, 1}, -1);
  add_geom("finger", model->mesh, {0.8f, 0.7f, 0.6f, 1}, 0);
  scene->sensors = {model};
  scene->sensor_geoms = {"finger"};

  auto frame = std::make_shared<SimFrame>();
  const Pose X_WB{dquat(1, 0, 0, 0), dvec3(0, 0, -kBoxHalf)};
  Pose X_WM{finger_tilt(), dvec3(0)};
  double lowest = 0;
  dvec3 lowest_point(0);
  for (const dvec3& v : model->mesh->vertices()) {
    const dvec3 p = X_WM * v;
    if (p.z < lowest) {
      lowest = p.z;
      lowest_point = p;
    }
  }
  const double depth = 0.0015;
  scene->path_W = {dvec3(-kBoxHalf - 0.012, 0, -depth), dvec3(-kBoxHalf + 0.012, 0, -depth)};
  X_WM.p = dvec3(-kBoxHalf + travel, 0, -depth) - lowest_point;

  SensorStep state;
  state.X_WM = X_WM;
  state.surfaces.resize(1);
  const HydroBody rigid{RigidMesh{std::make_shared<const MeshIndex>(box)}, {}, "box"};
  IntersectWorkspace workspace;
  intersect(*model->body, rigid, X_WM, X_WB, state.surfaces[0], workspace);
  SensorReading reading;
  const ContactSurface* surface = &state.surfaces[0];
  read_sensor(*model, std::span<const ContactSurface* const>(&surface, 1), reading);
  state.hits = reading.hits.all();
  state.readings = reading.values;
  for (const ContactPolygon& polygon : surface->polygons) {
    state.force_W += X_WM.rotate(polygon.pressure * polygon.area * polygon.normal);
  }
  frame->scene = scene;
  frame->travel = travel;
  frame->geom_poses = {X_WB, X_WM};
  frame->sensors = {state};
  return frame;
}

ui::SceneInput finger_input(const SimFramePtr& frame) {
  ui::SceneInput input;
  input.frame = frame;
  double highest = 0;
  for (const ContactSurface& surface : frame->sensors[0].surfaces) highest = std::max(highest, surface.max_pressure());
  input.range.hi = highest > 0 ? highest : 1;
  return input;
}

ui::Camera finger_camera() {
  ui::Camera camera;
  camera.target = {-0.022, 0, 0.004};
  camera.azimuth_deg = -120;
  camera.elevation_deg = 24;
  camera.distance = 0.075;
  return camera;
}

}  // namespace taxel::test
