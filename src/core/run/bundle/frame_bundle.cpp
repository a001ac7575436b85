#include "core/run/bundle/frame_bundle.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/text/sensor_names.h"
#include "core/layout/file/layout_json.h"
#include "core/run/bundle/touched_bodies.h"
#include "core/run/history/step_history.h"
#include "core/run/step.h"
#include "core/sensor/sensor_model.h"

namespace taxel {
namespace {

using Integers = std::vector<std::int64_t>;
using Doubles = std::vector<double>;

void write_geoms(const SimFrame& frame, BundledMeshes& meshes, NpzWriter& out) {
  const std::vector<SceneGeom>& geoms = frame.scene->geoms;
  std::vector<std::string> names, bodies;
  Doubles rgba, positions, quaternions;
  Integers plane, sensor, group, covered, mesh;
  for (std::size_t g = 0; g < geoms.size(); ++g) {
    names.push_back(geoms[g].name);
    bodies.push_back(geoms[g].body);
    for (const float level : geoms[g].rgba) rgba.push_back(static_cast<double>(level));
    plane.push_back(geoms[g].plane ? 1 : 0);
    sensor.push_back(geoms[g].sensor);
    group.push_back(geoms[g].group);
    covered.push_back(geoms[g].covered_by);
    mesh.push_back(geoms[g].mesh ? meshes.number(geoms[g].mesh) : -1);
    append(positions, quaternions, frame.geom_poses[g]);
  }
  out.add("geom_names", names);
  out.add("geom_bodies", bodies);
  out.add("geom_rgba", {geoms.size(), 4}, std::span<const double>(rgba));
  out.add("geom_plane", {geoms.size()}, std::span<const std::int64_t>(plane));
  out.add("geom_sensor", {geoms.size()}, std::span<const std::int64_t>(sensor));
  out.add("geom_group", {geoms.size()}, std::span<const std::int64_t>(group));
  out.add("geom_covered", {geoms.size()}, std::span<const std::int64_t>(covered));
  out.add("geom_mesh", {geoms.size()}, std::span<const std::int64_t>(mesh));
  out.add("geom_pos", {geoms.size(), 3}, std::span<const double>(positions));
  out.add("geom_quat", {geoms.size(), 4}, std::span<const double>(quaternions));
}

void write_surface(const ContactSurface& surface, const std::string& prefix, NpzWriter& out) {
  Integers polygons, filtered;
  Doubles planes, rejected, weights;
  for (const ContactPolygon& p : surface.polygons) {
    polygons.insert(polygons.end(), {p.first, p.count, p.tet, p.tet_b, p.face});
    append(planes, p.normal);
    planes.push_back(p.area);
    append(planes, p.centroid);
    planes.push_back(p.pressure);
    append(planes, p.gradient);
  }
  for (const RejectedPolygons& r : surface.rejected)
    rejected.insert(rejected.end(), {static_cast<double>(r.count), r.area, r.force});
  const bool any_weight = std::any_of(surface.polygons.begin(), surface.polygons.end(),
                                      [](const ContactPolygon& p) { return p.weight != 1; });
  if (any_weight) {
    for (const ContactPolygon& p : surface.polygons) weights.push_back(static_cast<double>(p.weight));
    out.add(prefix + "weights", {weights.size()}, std::span<const double>(weights));
  }
  for (const FilteredPolygon& f : surface.filtered)
    filtered.insert(filtered.end(), {static_cast<std::int64_t>(f.reason), f.first, f.count});
  add_vectors(out, prefix + "vertices", surface.vertices);
  out.add(prefix + "pressure", {surface.pressure.size()}, std::span<const double>(surface.pressure));
  out.add(prefix + "polygons", {surface.polygons.size(), 5}, std::span<const std::int64_t>(polygons));
  out.add(prefix + "planes", {surface.polygons.size(), 11}, std::span<const double>(planes));
  out.add(prefix + "rejected", {kRejections, 3}, std::span<const double>(rejected));
  out.add(prefix + "filtered", {surface.filtered.size(), 3}, std::span<const std::int64_t>(filtered));
  add_vectors(out, prefix + "filtered_vertices", surface.filtered_vertices);
}

void write_hits(const std::vector<RayHit>& hits, const std::string& prefix, NpzWriter& out) {
  Integers rays, where;
  Doubles values;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!hits[i].hit()) continue;
    rays.push_back(static_cast<std::int64_t>(i));
    where.insert(where.end(), {hits[i].surface, hits[i].polygon});
    values.insert(values.end(), {hits[i].depth, hits[i].pressure});
  }
  add_number(out, prefix + "rays", static_cast<std::int64_t>(hits.size()));
  out.add(prefix + "hit_rays", {rays.size()}, std::span<const std::int64_t>(rays));
  out.add(prefix + "hit_surface_polygon", {rays.size(), 2}, std::span<const std::int64_t>(where));
  out.add(prefix + "hit_depth_pressure", {rays.size(), 2}, std::span<const double>(values));
}

void write_sticking(const std::vector<StickingFriction>& sticking, const std::string& prefix, NpzWriter& out) {
  for (std::size_t k = 0; k < sticking.size(); ++k) {
    Doubles roots;
    for (const StickingFriction::Root& root : sticking[k].roots) {
      append(roots, root.place);
      append(roots, root.normal);
      roots.push_back(root.area);
      append(roots, root.traction);
      roots.insert(roots.end(), {root.slips ? 1.0 : 0.0, sticking[k].reach});
    }
    out.add(fmt::format("{}sticking{}", prefix, k), {sticking[k].roots.size(), 12}, std::span<const double>(roots));
  }
}

void write_sensor(const SensorStep& state, const SensorModel& model, const std::string& prefix, BundledMeshes& meshes,
                  NpzWriter& out) {
  out.add(prefix + "layout", layout_to_json(layout_on_repaired_mesh(model)));
  add_number(out, prefix + "mesh", meshes.number(model.mesh));
  out.add(prefix + "quality", to_string(model.quality));
  if (model.taxel_count() == 0) write_body(*model.body, prefix + "body/", meshes, out);
  Doubles position, quaternion;
  append(position, quaternion, state.X_WM);
  out.add(prefix + "pos", {3}, std::span<const double>(position));
  out.add(prefix + "quat", {4}, std::span<const double>(quaternion));
  add_vectors(out, prefix + "force", std::vector{state.force_W});
  add_vectors(out, prefix + "uncovered", std::vector{state.uncovered_W});
  out.add(prefix + "readings", {state.readings.size()}, std::span<const double>(state.readings));
  Doubles shear;
  for (const dvec2& s : state.shear) append(shear, s);
  if (!shear.empty()) out.add(prefix + "shear", {state.shear.size(), 2}, std::span<const double>(shear));
  if (!state.slip.empty()) out.add(prefix + "slip", {state.slip.size()}, std::span<const double>(state.slip));
  write_sticking(state.sticking, prefix, out);
  write_hits(state.hits, prefix, out);
  Doubles motions;
  for (const SurfaceMotion& motion : state.motions) {
    motions.insert(motions.end(), {motion.properties.dissipation, motion.properties.friction});
    append(motions, motion.V.linear);
    append(motions, motion.V.angular);
  }
  out.add(prefix + "motions", {state.motions.size(), 8}, std::span<const double>(motions));
  add_number(out, prefix + "surfaces", static_cast<std::int64_t>(state.surfaces.size()));
  for (std::size_t k = 0; k < state.surfaces.size(); ++k)
    write_surface(state.surfaces[k], fmt::format("{}surface{}/", prefix, k), out);
}

}  // namespace

std::string frame_to_bundle(const SimFrame& frame, const BundledFiles& files) {
  NpzWriter out;
  out.add("format", std::string("taxel-frame"));
  add_number(out, "version", std::int64_t{1});
  out.add("title", frame.scene->title);
  add_number(out, "step", static_cast<std::int64_t>(frame.step));
  add_number(out, "time", frame.time);
  add_number(out, "travel", frame.travel);
  add_number(out, "timestep", frame.scene->timestep);
  add_number(out, "duration", frame.scene->duration);
  BundledMeshes meshes;
  write_geoms(frame, meshes, out);
  add_vectors(out, "path", frame.scene->path_W);
  out.add("sensor_geoms", frame.scene->sensor_geoms);
  for (std::size_t s = 0; s < frame.sensors.size(); ++s)
    write_sensor(frame.sensors[s], *frame.scene->sensors[s], fmt::format("sensor{}/", s), meshes, out);
  write_touched(*frame.scene, meshes, out);
  meshes.write(out);
  for (const auto& [name, bytes] : files) out.add_file(name, bytes);
  return out.bytes();
}

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
  // Used if the file is of a version without groups, or without covered geoms.
  const std::vector<std::int64_t> zeros(n, 0), none(n, -1);
  const std::vector<std::int64_t> plane = in.integers("geom_plane", {n}), sensor = in.integers("geom_sensor", {n}),
                                  mesh = in.integers("geom_mesh", {n}),
                                  group = in.has("geom_group") ? in.integers("geom_group", {n}) : zeros,
                                  covered = in.has("geom_covered") ? in.integers("geom_covered", {n}) : none;
  for (std::size_t g = 0; g < n; ++g) {
    SceneGeom& geom = scene.geoms.emplace_back();
    geom.name = names[g];
    geom.body = bodies[g];
    for (std::size_t k = 0; k < 4; ++k) geom.rgba[k] = static_cast<float>(rgba[4 * g + k]);
    geom.plane = plane[g] != 0;
    geom.sensor = index_of(in, "geom_sensor", sensor[g], -1, scene.sensor_geoms.size());
    geom.group = index_of(in, "geom_group", group[g], 0, kSceneGroups);
    geom.covered_by = index_of(in, "geom_covered", covered[g], -1, scene.sensor_geoms.size());
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
  scene->sensor_labels = short_sensor_names(scene->sensor_geoms);
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
