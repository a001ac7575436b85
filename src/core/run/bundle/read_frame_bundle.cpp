#include <fmt/format.h>

#include <limits>

#include "core/base/error.h"
#include "core/layout/file/layout_json.h"
#include "core/run/bundle/frame_bundle.h"
#include "core/run/bundle/touched_bodies.h"
#include "core/run/history/step_history.h"
#include "core/run/history/trace_row.h"
#include "core/sensor/bare_model.h"

namespace taxel {
namespace {

constexpr std::size_t kAny = NpzReader::kAny;

std::vector<TriMeshPtr> read_meshes(const NpzReader& in) {
  std::vector<TriMeshPtr> meshes;
  for (std::size_t i = 0; i < count_of(in, "meshes"); ++i) {
    const std::string prefix = fmt::format("mesh{}/", i), name = prefix + "faces";
    std::vector<dvec3> vertices = vectors_of(in, prefix + "vertices");
    const std::vector<std::int64_t> flat = in.integers(name, {kAny, 3});
    std::vector<ivec3> faces;
    for (std::size_t f = 0; f < flat.size(); f += 3) {
      ivec3 face;
      for (int k = 0; k < 3; ++k)
        face[k] = index_of(in, name, flat[f + static_cast<std::size_t>(k)], 0, vertices.size());
      faces.push_back(face);
    }
    meshes.push_back(std::make_shared<const TriMesh>(std::move(vertices), std::move(faces)));
  }
  return meshes;
}

void read_geoms(const NpzReader& in, const std::vector<TriMeshPtr>& meshes, SimScene& scene, SimFrame& frame) {
  const std::vector<std::string> names = in.texts("geom_names"), bodies = in.texts("geom_bodies");
  const std::size_t n = names.size();
  if (bodies.size() != n) throw Error(in.file(), "geom_bodies", "are not as many as geom_names");
  const std::vector<double> rgba = finite_doubles(in, "geom_rgba", {n, 4}),
                            positions = finite_doubles(in, "geom_pos", {n, 3}),
                            quaternions = unit_quaternions(in, "geom_quat", {n, 4});
  const std::vector<std::int64_t> zeros(n, 0);  // used if the file is of a version without groups
  const std::vector<std::int64_t> plane = in.integers("geom_plane", {n}), sensor = in.integers("geom_sensor", {n}),
                                  mesh = in.integers("geom_mesh", {n}),
                                  group = in.has("geom_group") ? in.integers("geom_group", {n}) : zeros;
  for (std::size_t g = 0; g < n; ++g) {
    SceneGeom& geom = scene.geoms.emplace_back();
    geom.name = names[g];
    geom.body = bodies[g];
    for (std::size_t k = 0; k < 4; ++k) geom.rgba[k] = static_cast<float>(rgba[4 * g + k]);
    geom.plane = plane[g] != 0;
    geom.sensor = index_of(in, "geom_sensor", sensor[g], -1, scene.sensor_geoms.size());
    geom.group = index_of(in, "geom_group", group[g], 0, kSceneGroups);
    const int number = index_of(in, "geom_mesh", mesh[g], -1, meshes.size());
    if (number >= 0) geom.mesh = meshes[static_cast<std::size_t>(number)];
    frame.geom_poses.push_back(pose_of_row(positions, quaternions, g));
  }
}

/// Returns the number of tets that a polygon may name. If the sensor's body is soft, the tets are its own; otherwise
/// they belong to another body and are never looked up.
std::size_t tet_count(const SensorModel& model) {
  const auto* soft = model.body ? std::get_if<SoftBody>(&model.body->geometry) : nullptr;
  return soft != nullptr ? soft->field->tets().size() : std::numeric_limits<int>::max();
}

/// Reads the polygons of one contact surface. `tets` is the result of tet_count().
void read_polygons(const NpzReader& in, const std::string& prefix, std::size_t tets, ContactSurface& surface) {
  const std::vector<std::int64_t> polygons = in.integers(prefix + "polygons", {kAny, 5});
  const std::size_t n = polygons.size() / 5;
  const std::vector<double> planes = finite_doubles(in, prefix + "planes", {n, 11});
  std::vector<double> weights(n, 1.0);  // of back faces that count in part
  if (in.has(prefix + "weights")) weights = finite_doubles(in, prefix + "weights", {n});
  constexpr std::size_t kMaxIndex = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < n; ++i) {
    ContactPolygon& p = surface.polygons.emplace_back();
    const std::int64_t* whole = &polygons[5 * i];
    p.first = index_of(in, prefix + "polygons", whole[0], 0, surface.vertices.size());
    p.count =
        index_of(in, prefix + "polygons", whole[1], 3, surface.vertices.size() - static_cast<std::size_t>(p.first) + 1);
    p.tet = index_of(in, prefix + "polygons", whole[2], -1, tets);
    p.tet_b = index_of(in, prefix + "polygons", whole[3], -1, kMaxIndex);
    p.face = index_of(in, prefix + "polygons", whole[4], -1, kMaxIndex);
    p.normal = vector_at(planes, 11 * i);
    p.area = planes[11 * i + 3];
    p.centroid = vector_at(planes, 11 * i + 4);
    p.pressure = planes[11 * i + 7];
    p.gradient = vector_at(planes, 11 * i + 8);
    p.weight = static_cast<float>(weights[i]);
  }
}

ContactSurface read_surface(const NpzReader& in, const std::string& prefix, std::size_t tets) {
  ContactSurface surface;
  for (const dvec3& v : vectors_of(in, prefix + "vertices")) surface.vertices.push_back(v);
  for (const double p : finite_doubles(in, prefix + "pressure", {surface.vertices.size()}))
    surface.pressure.push_back(p);
  read_polygons(in, prefix, tets, surface);
  // Files of versions that count all faces have no row of back faces.
  const std::vector<double> rejected = finite_doubles(in, prefix + "rejected", {NpzReader::kAny, 3});
  const std::size_t rows = rejected.size() / 3;
  if (rows != kRejections && rows + 1 != kRejections)
    throw Error(in.file(), prefix + "rejected", fmt::format("must have {} rows, has {}", kRejections, rows));
  for (std::size_t r = 0; r < rows; ++r) {
    const double count = rejected[3 * r];
    if (!(count >= 0 && count <= std::numeric_limits<int>::max()))
      throw Error(in.file(), prefix + "rejected", fmt::format("count {} of row {} is out of range", count, r));
    surface.rejected[r] = {static_cast<int>(count), rejected[3 * r + 1], rejected[3 * r + 2]};
  }
  surface.filtered_vertices = vectors_of(in, prefix + "filtered_vertices");
  const std::string name = prefix + "filtered";
  const std::vector<std::int64_t> filtered = in.integers(name, {kAny, 3});
  for (std::size_t f = 0; f < filtered.size(); f += 3) {
    const int reason = index_of(in, name, filtered[f], 0, kRejections);
    const int first = index_of(in, name, filtered[f + 1], 0, surface.filtered_vertices.size() + 1);
    const int n =
        index_of(in, name, filtered[f + 2], 0, surface.filtered_vertices.size() - static_cast<std::size_t>(first) + 1);
    surface.filtered.push_back({static_cast<Rejection>(reason), first, n});
  }
  return surface;
}

std::vector<RayHit> read_hits(const NpzReader& in, const std::string& prefix,
                              const std::vector<ContactSurface>& surfaces, std::size_t rays) {
  const std::vector<std::int64_t> of = in.integers(prefix + "hit_rays", {kAny});
  const std::vector<std::int64_t> where = in.integers(prefix + "hit_surface_polygon", {of.size(), 2});
  const std::vector<double> values = finite_doubles(in, prefix + "hit_depth_pressure", {of.size(), 2});
  std::vector<RayHit> hits(rays);
  for (std::size_t i = 0; i < of.size(); ++i) {
    RayHit& hit = hits[static_cast<std::size_t>(index_of(in, prefix + "hit_rays", of[i], 0, rays))];
    const std::string name = prefix + "hit_surface_polygon";
    hit.surface = index_of(in, name, where[2 * i], 0, surfaces.size());
    hit.polygon =
        index_of(in, name, where[2 * i + 1], 0, surfaces[static_cast<std::size_t>(hit.surface)].polygons.size());
    hit.depth = values[2 * i], hit.pressure = values[2 * i + 1];
  }
  return hits;
}

SensorModelPtr read_model(const NpzReader& in, const std::string& prefix, const std::vector<TriMeshPtr>& meshes,
                          SensorBuild how) {
  const Layout layout = parse_layout(in.text(prefix + "layout"), in.file());
  const int mesh = index_of(in, prefix + "mesh", in.integers(prefix + "mesh", {})[0], 0, meshes.size());
  const TriMeshPtr& surface = meshes[static_cast<std::size_t>(mesh)];
  if (in.has(prefix + "body/name")) return bare_model(layout.name, surface, read_body(in, prefix + "body/", meshes));
  const std::string quality = in.text(prefix + "quality");
  how.quality = quality == to_string(SampleQuality::preview) ? SampleQuality::preview : SampleQuality::polished;
  return build_sensor_model(layout, surface, layout.mesh.sha256, in.file(), how);
}

/// Reads the motions of the surfaces; empty if the file is of a version without them.
std::vector<SurfaceMotion> read_motions(const NpzReader& in, const std::string& name, std::size_t surfaces) {
  std::vector<SurfaceMotion> motions;
  if (!in.has(name)) return motions;
  const std::vector<double> numbers = finite_doubles(in, name, {kAny, 8});
  for (std::size_t i = 0; i < numbers.size(); i += 8)
    motions.push_back({{numbers[i], numbers[i + 1]}, {vector_at(numbers, i + 2), vector_at(numbers, i + 5)}});
  if (!motions.empty() && motions.size() != surfaces)
    throw Error(in.file(), name, fmt::format("has {} rows, there are {} surfaces", motions.size(), surfaces));
  return motions;
}

/// Reads friction that sticks; empty if there is none.
std::vector<StickingFriction> read_sticking(const NpzReader& in, const std::string& name, std::size_t surfaces) {
  constexpr std::size_t kColumns = 12;
  std::vector<StickingFriction> sticking;
  if (!in.has(name + "0")) return sticking;
  for (std::size_t k = 0; k < surfaces; ++k) {
    StickingFriction& friction = sticking.emplace_back();
    const std::vector<double> numbers = finite_doubles(in, fmt::format("{}{}", name, k), {kAny, kColumns});
    for (std::size_t i = 0; i < numbers.size(); i += kColumns) {
      friction.roots.push_back({vector_at(numbers, i), vector_at(numbers, i + 3), numbers[i + 6],
                                vector_at(numbers, i + 7), numbers[i + 10] > 0});
      friction.reach = numbers[i + 11];
    }
  }
  return sticking;
}

/// Reads the shear of the taxels; empty if the file is of a version without shear, or the layout has no shear readings.
std::vector<dvec2> read_shear_rows(const NpzReader& in, const std::string& name, const SensorModel& model) {
  std::vector<dvec2> shear;
  if (!model.layout.readout.shear || !in.has(name)) return shear;
  const std::vector<double> numbers = finite_doubles(in, name, {static_cast<std::size_t>(model.taxel_count()), 2});
  for (std::size_t i = 0; i < numbers.size(); i += 2) shear.emplace_back(numbers[i], numbers[i + 1]);
  return shear;
}

dvec3 one_vector_of(const NpzReader& in, const std::string& name) {
  return vector_at(finite_doubles(in, name, {1, 3}), 0);
}

SensorStep read_sensor(const NpzReader& in, const std::string& prefix, const SensorModelPtr& sensor, double time) {
  const SensorModel& model = *sensor;
  SensorStep state;
  state.model = sensor;
  state.time = time;
  state.X_WM = pose_of_row(finite_doubles(in, prefix + "pos", {3}), unit_quaternions(in, prefix + "quat", {4}), 0);
  state.force_W = one_vector_of(in, prefix + "force");
  state.uncovered_W = one_vector_of(in, prefix + "uncovered");
  state.readings = finite_doubles(in, prefix + "readings", {static_cast<std::size_t>(model.taxel_count())});
  state.shear = read_shear_rows(in, prefix + "shear", model);
  if (in.has(prefix + "slip"))
    state.slip = finite_doubles(in, prefix + "slip", {static_cast<std::size_t>(model.taxel_count())});
  for (std::size_t k = 0; k < count_of(in, prefix + "surfaces"); ++k)
    state.surfaces.push_back(read_surface(in, fmt::format("{}surface{}/", prefix, k), tet_count(model)));
  state.sticking = read_sticking(in, prefix + "sticking", state.surfaces.size());
  state.motions = read_motions(in, prefix + "motions", state.surfaces.size());
  const std::size_t rays = count_of(in, prefix + "rays");
  if (rays != model.rays.size())
    throw Error(in.file(), prefix + "rays",
                fmt::format("has {} rays, this version makes {} of its layout", rays, model.rays.size()));
  state.hits = read_hits(in, prefix, state.surfaces, rays);
  return state;
}

/// Returns a history that has only this step.
void remember(SimFrame& frame) {
  const StepView view = view_of(frame);
  StepHistory history;
  history.record(view, SimState{{}, frame.step, frame.time, frame.travel, false});
  frame.history = {frame.step, frame.step, 1, history.bytes(), 0, history.limits(), history.lanes()};
  frame.trace = std::make_shared<const Trace>(Trace{{trace_row_of(view, SampleQuality::polished)}});
}

}  // namespace

SimFramePtr read_frame_bundle(const std::filesystem::path& path, const SensorBuild& how) {
  return read_frame_bundle(NpzReader(path), how);
}

SimFramePtr read_frame_bundle(const NpzReader& in, const SensorBuild& how) {
  if (!in.has("format") || in.text("format") != "taxel-frame")
    throw Error(in.file(), "is no frame of a simulation (.taxelframe)");
  if (const std::int64_t version = in.integers("version", {})[0]; version != 1)
    throw Error(in.file(), "version", fmt::format("is {}, this program reads version 1", version));
  const std::vector<TriMeshPtr> meshes = read_meshes(in);
  auto scene = std::make_shared<SimScene>();
  auto frame = std::make_shared<SimFrame>();
  scene->title = in.text("title");
  scene->duration = number_of(in, "duration");
  scene->timestep = number_of(in, "timestep");
  scene->path_W = vectors_of(in, "path");
  scene->sensor_geoms = in.texts("sensor_geoms");
  constexpr std::int64_t kMaxStep = std::int64_t{1} << 53;  // times and plots convert a step to a double without loss
  frame->step = static_cast<std::uint64_t>(bounded_integers(in, "step", {}, 0, kMaxStep)[0]);
  frame->time = number_of(in, "time");
  frame->travel = number_of(in, "travel");
  read_geoms(in, meshes, *scene, *frame);
  for (std::size_t s = 0; s < scene->sensor_geoms.size(); ++s) {
    const std::string prefix = fmt::format("sensor{}/", s);
    scene->sensors.push_back(read_model(in, prefix, meshes, how));
    frame->sensors.push_back(read_sensor(in, prefix, scene->sensors.back(), frame->time));
  }
  read_touched(in, meshes, *scene);
  frame->scene = frame->simulated = std::move(scene);
  remember(*frame);
  return frame;
}

}  // namespace taxel
