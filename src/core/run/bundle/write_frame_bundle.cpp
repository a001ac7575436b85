#include <fmt/format.h>

#include <algorithm>

#include "core/layout/file/layout_json.h"
#include "core/run/bundle/frame_bundle.h"
#include "core/run/bundle/touched_bodies.h"

namespace taxel {
namespace {

using Integers = std::vector<std::int64_t>;
using Doubles = std::vector<double>;

void write_geoms(const SimFrame& frame, BundledMeshes& meshes, NpzWriter& out) {
  const std::vector<SceneGeom>& geoms = frame.scene->geoms;
  std::vector<std::string> names, bodies;
  Doubles rgba, positions, quaternions;
  Integers plane, sensor, group, mesh;
  for (std::size_t g = 0; g < geoms.size(); ++g) {
    names.push_back(geoms[g].name);
    bodies.push_back(geoms[g].body);
    for (const float level : geoms[g].rgba) rgba.push_back(static_cast<double>(level));
    plane.push_back(geoms[g].plane ? 1 : 0);
    sensor.push_back(geoms[g].sensor);
    group.push_back(geoms[g].group);
    mesh.push_back(geoms[g].mesh ? meshes.number(geoms[g].mesh) : -1);
    append(positions, quaternions, frame.geom_poses[g]);
  }
  out.add("geom_names", names);
  out.add("geom_bodies", bodies);
  out.add("geom_rgba", {geoms.size(), 4}, std::span<const double>(rgba));
  out.add("geom_plane", {geoms.size()}, std::span<const std::int64_t>(plane));
  out.add("geom_sensor", {geoms.size()}, std::span<const std::int64_t>(sensor));
  out.add("geom_group", {geoms.size()}, std::span<const std::int64_t>(group));
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

}  // namespace taxel
