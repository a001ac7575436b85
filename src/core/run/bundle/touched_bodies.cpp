#include "core/run/bundle/touched_bodies.h"

#include <array>

#include "core/hydro/kernel/depth_field.h"
#include "core/hydro/kernel/law_pass.h"
#include "core/layout/words.h"

namespace taxel {
namespace {

using Integers = std::vector<std::int64_t>;

/// Words for the kinds of geometry, in the order of the alternatives of HydroBody::geometry.
constexpr std::array<const char*, 4> kKinds{"rigid_half_space", "soft_half_space", "soft", "rigid_mesh"};
/// Words for the shapes, in the order of ShapeType.
constexpr std::array<const char*, 8> kShapes{"plane",    "sphere", "capsule", "ellipsoid",
                                             "cylinder", "box",    "mesh",    "tets"};

template <std::size_t N>
std::size_t place_of(const NpzReader& in, const std::string& name, const std::string& word,
                     const std::array<const char*, N>& words) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) throw Error(in.file(), name, fmt::format("\"{}\" is not known", word));
  return static_cast<std::size_t>(found - words.begin());
}

TriMeshPtr mesh_at(const NpzReader& in, const std::string& name, std::int64_t number,
                   const std::vector<TriMeshPtr>& meshes) {
  return meshes[static_cast<std::size_t>(index_of(in, name, number, 0, meshes.size()))];
}

/// Reads the field beyond the tets; null if there is none or the file is of a version without it.
DepthFieldPtr read_depth(const NpzReader& in, const std::string& prefix, const std::vector<TriMeshPtr>& meshes) {
  if (!in.has(prefix + "skin")) return nullptr;
  const std::vector<double> depth = finite_doubles(in, prefix + "depth", {2});
  if (!(depth[0] > 0) || !(depth[1] > 0)) throw Error(in.file(), prefix + "depth", "must be greater than 0");
  return std::make_shared<const DepthField>(mesh_at(in, prefix + "skin", in.integers(prefix + "skin", {})[0], meshes),
                                            depth[0], depth[1]);
}

SoftBody read_field(const NpzReader& in, const std::string& prefix, const std::vector<TriMeshPtr>& meshes) {
  std::vector<dvec3> vertices = vectors_of(in, prefix + "vertices");
  const Integers flat = in.integers(prefix + "tets", {NpzReader::kAny, 4});
  std::vector<ivec4> tets(flat.size() / 4);
  for (std::size_t i = 0; i < flat.size(); ++i)
    tets[i / 4][static_cast<int>(i % 4)] = index_of(in, prefix + "tets", flat[i], 0, vertices.size());
  FieldReport report;
  report.core = in.integers(prefix + "core", {})[0] != 0;
  std::vector<double> pressure = finite_doubles(in, prefix + "pressure", {vertices.size()});
  try {
    return SoftBody(std::make_shared<const PressureField>(std::move(vertices), std::move(tets), std::move(pressure),
                                                          std::move(report)),
                    read_depth(in, prefix, meshes));
  } catch (const Error& error) {
    throw Error(in.file(), prefix + "tets", error.message());
  }
}

/// Writes the bodies that one sensor touches. `number(body)` returns the index of a body among all bodies of the file.
template <class Number>
void write_rows(const std::vector<TouchedBody>& touched, const std::string& prefix, const Number& number,
                BundledMeshes& meshes, NpzWriter& out) {
  Integers who, shape_meshes;
  std::vector<std::string> names, shapes;
  std::vector<double> pos, quat, sizes;
  for (const TouchedBody& one : touched) {
    const bool has_body = one.body != nullptr;
    who.insert(who.end(), {has_body && one.sensor < 0 ? number(one.body) : -1, one.geom, one.sensor,
                           one.mirrored ? 1 : 0, has_body ? 1 : 0});
    names.push_back(one.name);
    append(pos, quat, one.X_WB);
    shapes.emplace_back(one.shape ? kShapes[static_cast<std::size_t>(one.shape->type)] : "");
    append(sizes, one.shape ? one.shape->size : dvec3(0));
    shape_meshes.push_back(one.shape && one.shape->mesh ? meshes.number(one.shape->mesh) : -1);
  }
  const std::size_t n = touched.size();
  out.add(prefix + "touched", {n, 5}, std::span<const std::int64_t>(who));
  out.add(prefix + "touched_names", names);
  out.add(prefix + "touched_pos", {n, 3}, std::span<const double>(pos));
  out.add(prefix + "touched_quat", {n, 4}, std::span<const double>(quat));
  out.add(prefix + "touched_shapes", shapes);
  out.add(prefix + "touched_sizes", {n, 3}, std::span<const double>(sizes));
  out.add(prefix + "touched_meshes", {n}, std::span<const std::int64_t>(shape_meshes));
}

std::vector<TouchedBody> read_rows(const NpzReader& in, const std::string& prefix,
                                   const std::vector<HydroBodyPtr>& bodies, const std::vector<TriMeshPtr>& meshes,
                                   const SimScene& scene) {
  const std::string name = prefix + "touched";
  const Integers who = in.integers(name, {NpzReader::kAny, 5});
  const std::size_t n = who.size() / 5;
  const std::vector<std::string> names = in.texts(name + "_names"), shapes = in.texts(name + "_shapes");
  if (names.size() != n || shapes.size() != n) throw Error(in.file(), name, "has not as many rows as names and shapes");
  const std::vector<double> pos = finite_doubles(in, name + "_pos", {n, 3}),
                            quat = unit_quaternions(in, name + "_quat", {n, 4}),
                            sizes = finite_doubles(in, name + "_sizes", {n, 3});
  const Integers shape_meshes = in.integers(name + "_meshes", {n});
  std::vector<TouchedBody> touched(n);
  for (std::size_t k = 0; k < n; ++k) {
    TouchedBody& one = touched[k];
    const std::int64_t* row = &who[5 * k];
    const int body = index_of(in, name, row[0], -1, bodies.size());
    one.geom = index_of(in, name, row[1], -1, scene.geoms.size());
    one.sensor = index_of(in, name, row[2], -1, scene.sensors.size());
    one.mirrored = row[3] != 0;
    if (body >= 0) one.body = bodies[static_cast<std::size_t>(body)];
    if (row[4] != 0 && one.sensor >= 0) one.body = scene.sensors[static_cast<std::size_t>(one.sensor)]->body;
    one.X_WB = pose_of_row(pos, quat, k);
    one.name = names[k];
    if (shapes[k].empty()) continue;
    Shape shape;
    shape.type = static_cast<ShapeType>(place_of(in, name + "_shapes", shapes[k], kShapes));
    shape.size = vector_at(sizes, 3 * k);
    if (shape_meshes[k] >= 0) shape.mesh = mesh_at(in, name + "_meshes", shape_meshes[k], meshes);
    one.shape = std::make_shared<const Shape>(std::move(shape));
  }
  return touched;
}

}  // namespace

void write_body(const HydroBody& body, const std::string& prefix, BundledMeshes& meshes, NpzWriter& out) {
  const Material& m = body.material;
  out.add(prefix + "name", body.name);
  out.add(prefix + "kind", std::string(kKinds[body.geometry.index()]));
  out.add(prefix + "field", std::string(to_word(m.field)));
  if (m.faces != FaceRule::along_gradient) out.add(prefix + "faces", std::string(to_word(m.faces)));
  if (!m.law.is_linear()) {
    const std::vector<double> law = numbers_of(m.law);
    out.add(prefix + "law", {law.size()}, std::span<const double>(law));
  }
  out.add(prefix + "material", {4}, std::vector{m.modulus, m.thickness, m.dissipation, m.friction});
  if (const auto* space = std::get_if<SoftHalfSpace>(&body.geometry))
    out.add(prefix + "half_space", {2}, std::vector{space->stiffness, space->thickness});
  if (const auto* rigid = std::get_if<RigidMesh>(&body.geometry))
    add_number(out, prefix + "mesh", meshes.number(rigid->index->mesh_ptr()));
  const auto* soft = std::get_if<SoftBody>(&body.geometry);
  if (soft == nullptr) return;
  const PressureField& field = *soft->field;
  add_vectors(out, prefix + "vertices", field.vertices());
  Integers tets;
  for (const Tet& tet : field.tets())
    for (int i = 0; i < 4; ++i) tets.push_back(tet.vertices[i]);
  out.add(prefix + "tets", {field.tets().size(), 4}, std::span<const std::int64_t>(tets));
  out.add(prefix + "pressure", {field.vertices().size()}, std::span<const double>(field.vertex_pressure()));
  add_number(out, prefix + "core", std::int64_t{field.report().core ? 1 : 0});
  if (!soft->depth) return;
  add_number(out, prefix + "skin", meshes.number(soft->depth->skin()));
  out.add(prefix + "depth", {2}, std::vector{soft->depth->thickness(), soft->depth->stiffness()});
}

namespace {

PressureLaw read_law_of(const NpzReader& in, const std::string& name) {
  try {
    return law_of(finite_doubles(in, name, {NpzReader::kAny}));
  } catch (const Error& error) {
    if (!error.file().empty()) throw;
    throw Error(in.file(), name, error.message());
  }
}

}  // namespace

HydroBodyPtr read_body(const NpzReader& in, const std::string& prefix, const std::vector<TriMeshPtr>& meshes) {
  auto body = std::make_shared<HydroBody>();
  body->name = in.text(prefix + "name");
  const std::vector<double> material = finite_doubles(in, prefix + "material", {4});
  const std::optional<FieldKind> field = from_word<FieldKind>(in.text(prefix + "field"));
  if (!field) throw Error(in.file(), prefix + "field", "is none that is known");
  body->material = {*field, material[0], material[1], material[2], material[3]};
  if (in.has(prefix + "faces")) {
    const std::optional<FaceRule> faces = from_word<FaceRule>(in.text(prefix + "faces"));
    if (!faces) throw Error(in.file(), prefix + "faces", "is none that is known");
    body->material.faces = *faces;
  }
  if (in.has(prefix + "law")) body->material.law = read_law_of(in, prefix + "law");
  if (body->material.compliant()) body->law_levels = law_levels(body->material.law, kLawLevels);
  const std::size_t kind = place_of(in, prefix + "kind", in.text(prefix + "kind"), kKinds);
  if (kind == 1) {
    const std::vector<double> space = finite_doubles(in, prefix + "half_space", {2});
    body->geometry = SoftHalfSpace{space[0], space[1]};
  } else if (kind == 2) {
    body->geometry = read_field(in, prefix, meshes);
  } else if (kind == 3) {
    const std::string name = prefix + "mesh";
    const TriMeshPtr mesh = mesh_at(in, name, in.integers(name, {})[0], meshes);
    body->geometry = RigidMesh(std::make_shared<const MeshIndex>(mesh));
  }
  return body;
}

void write_touched(const SimScene& scene, BundledMeshes& meshes, NpzWriter& out) {
  if (scene.touched.size() != scene.sensors.size()) return;  // the scene is of a file without these arrays
  std::vector<HydroBodyPtr> bodies;
  const auto number = [&](const HydroBodyPtr& body) {
    const auto found = std::find(bodies.begin(), bodies.end(), body);
    const std::int64_t at = found - bodies.begin();
    if (found == bodies.end()) bodies.push_back(body);
    return at;
  };
  for (std::size_t s = 0; s < scene.touched.size(); ++s)
    write_rows(scene.touched[s], fmt::format("sensor{}/", s), number, meshes, out);
  add_number(out, "bodies", static_cast<std::int64_t>(bodies.size()));
  for (std::size_t i = 0; i < bodies.size(); ++i) write_body(*bodies[i], fmt::format("body{}/", i), meshes, out);
}

void read_touched(const NpzReader& in, const std::vector<TriMeshPtr>& meshes, SimScene& scene) {
  if (!in.has("bodies")) return;
  std::vector<HydroBodyPtr> bodies;
  for (std::size_t i = 0; i < count_of(in, "bodies"); ++i)
    bodies.push_back(read_body(in, fmt::format("body{}/", i), meshes));
  for (std::size_t s = 0; s < scene.sensors.size(); ++s)
    scene.touched.push_back(read_rows(in, fmt::format("sensor{}/", s), bodies, meshes, scene));
}

}  // namespace taxel
