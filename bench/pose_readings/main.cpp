// Readings of many poses in one call (read_poses()), compared in the same run with mj_forward on a kept model whose
// plugin reads the same poses. The fingertip with twelve taxels; a rigid ball of radius 4 mm with edges of 2, 1 or 0.4
// mm, and a rigid box of half size 4 mm, which press its taxels along their normals. One ball presses a fingertip with
// a stiffening pressure law. Processor time of one thread; the rounds alternate, and each figure is a median.
//
//   bench_pose_readings [ROUNDS]
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>

#include "core/base/random_pose.h"
#include "core/sensor/contact_case/pose_readings.h"
#include "core/sensor/readout/reading.h"
#include "fixtures/sensor_scene.h"

namespace {
using namespace taxel;

constexpr double kSize = 0.004;  ///< radius of the ball, half size of the box [m]

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Returns a rotation that takes the z axis to the unit vector n, which must not be its opposite.
dquat z_onto(const dvec3& n) {
  const dvec3 axis = glm::cross(dvec3(0, 0, 1), n);
  return glm::normalize(dquat(1 + n.z, axis.x, axis.y, axis.z));
}

/// Returns 240 poses at this depth: over each taxel, moved by up to 2 mm along the skin. The object's z axis is the
/// taxel's normal.
std::vector<Pose> presses(const SensorModel& model, double depth) {
  std::vector<Pose> poses;
  for (int i = 0; i < 240; ++i) {
    const Taxel& taxel = model.layout.taxels[static_cast<std::size_t>(i) % model.layout.taxels.size()];
    const dvec3 moved = taxel.center + random_pose(3, i, 0.002).p;
    const SurfacePoint s = model.skin->closest_point(moved);
    poses.push_back({z_onto(taxel.normal), s.position + (kSize - depth) * taxel.normal});
  }
  return poses;
}

/// An object that presses the fingertip.
struct Presser {
  const char* name;
  ShapeType type;
  double edge;            ///< length of the edges of its tessellation [m]
  double stiffening = 0;  ///< k of the fingertip's pressure law, 0 for the linear one
};

/// The scene of the fingertip and an object on a mocap body, without gravity.
std::string scene_of(const Presser& object) {
  const std::string geom =
      fmt::format("type=\"{0}\" size=\"{1} {1} {1}\"", object.type == ShapeType::sphere ? "sphere" : "box", kSize);
  const std::string materials = fmt::format(R"({{"object": {{"resolution": {}}}}})", object.edge);
  return "<mujoco><option gravity=\"0 0 0\"/><asset><mesh name=\"tip\" file=\"tip.obj\"/></asset><worldbody>"
         "<geom name=\"tip\" type=\"mesh\" mesh=\"tip\" contype=\"0\" conaffinity=\"0\"/>"
         "<body mocap=\"true\"><geom name=\"object\" " +
         geom + " contype=\"0\" conaffinity=\"0\"/></body></worldbody>" +
         test::sensor_extension("tip", test::key("others", "object") + test::key("materials", materials)) + "</mujoco>";
}

struct Row {
  double polygons = 0, call = 0, forward = 0;  ///< polygons, and microseconds, for each pose
  double smallest = 0, largest = 0;            ///< times of the call in all rounds [us]
  double difference = 0;                       ///< largest difference of readings, as a part of the largest one
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Row measure(test::SensorScene& scene, const HydroBody& object, double depth, int rounds) {
  const SensorModel& model = *scene.sensor().model();
  const std::vector<Pose> poses = presses(model, depth);
  Row row;
  IntersectWorkspace workspace;
  ContactSurface surface;
  for (const Pose& X : poses) {
    intersect(*model.body, object, Pose{}, X, surface, workspace);
    row.polygons += static_cast<double>(surface.polygons.size()) / static_cast<double>(poses.size());
  }
  // The fingertip's mesh frame in the world, where MuJoCo has re-centred the mesh.
  mj_forward(scene.model.get(), scene.data.get());
  const Pose X_WM = scene.sensor().sensed().X_WM;
  std::vector<double> call, forward, sensed;
  PoseReadings readings;
  const double scale = 1e6 / static_cast<double>(poses.size());
  for (int round = 0; round < rounds; ++round) {
    double begin = processor_seconds();
    readings = read_poses(model, object, poses, {1});
    call.push_back(scale * (processor_seconds() - begin));
    sensed.clear();
    begin = processor_seconds();
    for (const Pose& X_MO : poses) {
      const Pose X = X_WM * X_MO;
      const double p[] = {X.p.x, X.p.y, X.p.z}, q[] = {X.q.w, X.q.x, X.q.y, X.q.z};
      std::copy(p, p + 3, scene.data->mocap_pos);
      std::copy(q, q + 4, scene.data->mocap_quat);
      mj_forward(scene.model.get(), scene.data.get());
      sensed.insert(sensed.end(), scene.data->sensordata, scene.data->sensordata + model.taxel_count());
    }
    forward.push_back(scale * (processor_seconds() - begin));
  }
  const double peak = *std::max_element(readings.readings.begin(), readings.readings.end());
  for (std::size_t i = 0; i < sensed.size(); ++i)
    row.difference = std::max(row.difference, std::abs(sensed[i] - readings.readings[i]) / peak);
  row.call = median(call);
  row.forward = median(forward);
  row.smallest = *std::min_element(call.begin(), call.end());
  row.largest = *std::max_element(call.begin(), call.end());
  return row;
}

void run(int rounds) {
  fmt::print(
      "| object | depth [mm] | polygons | us a pose (smallest to largest) | readings a second | goal [us] | mj_forward "
      "[us] | ratio | difference |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Presser& presser :
       {Presser{"ball, edges of 2 mm", ShapeType::sphere, 0.002},
        Presser{"ball, edges of 1 mm", ShapeType::sphere, 0.001},
        Presser{"ball, edges of 0.4 mm", ShapeType::sphere, 0.0004}, Presser{"box", ShapeType::box, 0.001},
        Presser{"ball, edges of 1 mm, law e/(1 - 0.78 e)", ShapeType::sphere, 0.001, 0.78}}) {
    test::SensorScene scene;
    SensorSource source = read_sensor_source(TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json");
    save_mesh(scene.folder / "tip.obj", *source.mesh.mesh);
    source.layout.mesh.file = "tip.obj";
    source.layout.mesh.sha256.clear();
    if (presser.stiffening > 0) source.layout.material.law = {LawKind::stiffening, presser.stiffening, {}};
    write_layout(scene.folder / "tip.taxels.json", source.layout);
    scene.compile(scene_of(presser));
    if (scene.model == nullptr) throw Error(scene.error);
    const HydroBodyPtr object = make_body({presser.type, dvec3(kSize), nullptr, presser.edge}, {}, presser.name);
    for (const double depth : {0.0005, 0.001, 0.0015}) {
      const Row row = measure(scene, *object, depth, rounds);
      fmt::print("| {} | {} | {:.0f} | {:.1f} ({:.1f} to {:.1f}) | {:.0f} | {:.1f} | {:.1f} | {:.2f} | {:.1g} |\n",
                 presser.name, 1000 * depth, row.polygons, row.call, row.smallest, row.largest, 1e6 / row.call,
                 10 + 0.25 * row.polygons, row.forward, row.forward / row.call, row.difference);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(argc > 1 ? std::max(1, std::atoi(argv[1])) : 15);
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "bench_pose_readings: {}\n", e.what());
    return 1;
  }
}
