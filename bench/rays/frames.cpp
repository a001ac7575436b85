#include "rays/frames.h"

#include "core/hydro/intersect.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/sensor_presets.h"
#include "core/mesh/mesh_io.h"

namespace taxel::bench {
namespace {

constexpr int kFrames = 24;
constexpr double kObjectSize = 0.020;  // half width of the box, radius of the sphere [m]
constexpr double kSphereEdge = 0.0006;

HydroBodyPtr make_object(Object object) {
  Shape shape;
  shape.type = object == Object::box ? ShapeType::box : ShapeType::sphere;
  shape.size = dvec3(kObjectSize);
  shape.resolution = kSphereEdge;
  return make_body(shape, Material{}, "object");
}

/// The pad (-y) faces down.
class Press {
 public:
  Press(const SensorModel& sensor, Object object) : sensor_(sensor), object_(make_object(object)) {}

  /// One object per normal, `depth` into the finger where the finger reaches farthest against that normal, shifted
  /// along the finger's axis.
  [[nodiscard]] std::vector<ContactSurface> frame(const std::vector<dvec3>& normals, double depth, double along,
                                                  const dquat& turn) const {
    const Pose X_WM{turn, dvec3(0)};
    std::vector<ContactSurface> surfaces;
    IntersectWorkspace workspace;
    for (const dvec3& n : normals) {
      dvec3 support(1.0);
      for (const dvec3& v : sensor_.mesh->vertices())
        if (const dvec3 x = turn * v; glm::dot(n, x) < glm::dot(n, support)) support = x;
      support.z = 0.5 * sensor_.mesh->bounds().hi.z + along;
      const Pose X_WB{glm::angleAxis(std::atan2(-n.x, n.y), dvec3(0, 0, 1)), support + (depth - kObjectSize) * n};
      intersect(*sensor_.body, *object_, X_WM, X_WB, surfaces.emplace_back(), workspace);
    }
    return surfaces;
  }

 private:
  const SensorModel& sensor_;
  HydroBodyPtr object_;
};

}  // namespace

double Path::mean_polygons() const {
  double sum = 0;
  for (const auto& frame : frames)
    for (const ContactSurface& surface : frame) sum += static_cast<double>(surface.polygons.size());
  return sum / static_cast<double>(frames.size());
}

std::vector<Path> record_paths(const SensorModel& sensor, Object object) {
  const Press press(sensor, object);
  const dvec3 up(0, 1, 0), axis(0, 0, 1);
  const dquat still(1, 0, 0, 0);
  const double half = 0.25 * kPi;  // of the groove's walls from the upright
  const std::vector<dvec3> groove = {dvec3(std::sin(half), std::cos(half), 0),
                                     dvec3(-std::sin(half), std::cos(half), 0)};
  std::vector<Path> paths = {{"press", {}}, {"slide", {}}, {"roll", {}}, {"wrap", {}}};
  for (int i = 0; i < kFrames; ++i) {
    const double s = (i + 1.0) / kFrames;
    paths[0].frames.push_back(press.frame({up}, 0.0018 * s, 0.002, still));
    paths[1].frames.push_back(press.frame({up}, 0.0015, 0.012 * s - 0.004, still));
    paths[2].frames.push_back(press.frame({up}, 0.0015, 0.002, glm::angleAxis(1.2 * (s - 0.5), axis)));
    paths[3].frames.push_back(press.frame(groove, 0.0018 * s, 0.002, still));
  }
  return paths;
}

std::vector<Path> record_flat_paths(const SensorModel& sensor, Object object) {
  const HydroBodyPtr body = make_object(object);
  const Aabb& bounds = sensor.mesh->bounds();
  const dquat turned = glm::angleAxis(0.3, dvec3(0, 0, 1));
  std::vector<Path> paths = {{"press", {}}, {"slide", {}}};
  IntersectWorkspace workspace;
  for (int i = 0; i < kFrames; ++i) {
    const double s = (i + 1.0) / kFrames, top = bounds.hi.z + kObjectSize;
    const Pose pressed{turned, dvec3(0.0003, 0.0002, top - 0.0015 * s)};
    const Pose slid{turned, dvec3((s - 0.5) * bounds.extent().x, 0.0002, top - 0.001)};
    intersect(*sensor.body, *body, Pose{}, pressed, paths[0].frames.emplace_back(1)[0], workspace);
    intersect(*sensor.body, *body, Pose{}, slid, paths[1].frames.emplace_back(1)[0], workspace);
  }
  return paths;
}

SensorModelPtr preset_sensor(const std::string& name) {
  const SensorPreset preset = make_sensor_preset(name);
  return build_sensor_model(preset.layout, preset.mesh, "", name);
}

SensorModelPtr fingertip_with_rays(int rays) {
  const std::filesystem::path file = TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json";
  Layout layout = read_layout(file);
  const LoadedMesh mesh = load_mesh(mesh_path(layout, file), layout.mesh.scale);
  constexpr double kProbe = 1e6;
  layout.sampling.density = kProbe;
  const auto few = static_cast<double>(build_sensor_model(layout, mesh.mesh, mesh.sha256, file.string())->rays.size());
  layout.sampling.density = kProbe * rays / few;
  return build_sensor_model(layout, mesh.mesh, mesh.sha256, file.string());
}

}  // namespace taxel::bench
