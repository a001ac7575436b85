#include "core/hydro/hydro_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <tuple>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/fields/round_mesh.h"
#include "core/hydro/kernel/depth_field.h"
#include "core/hydro/kernel/index/field_index.h"
#include "core/hydro/kernel/index/wide_tree.h"
#include "core/hydro/kernel/law_match.h"
#include "core/hydro/kernel/law_pass.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

const char* to_string(ShapeType type) {
  switch (type) {
    case ShapeType::plane:
      return "plane";
    case ShapeType::sphere:
      return "sphere";
    case ShapeType::capsule:
      return "capsule";
    case ShapeType::ellipsoid:
      return "ellipsoid";
    case ShapeType::cylinder:
      return "cylinder";
    case ShapeType::box:
      return "box";
    case ShapeType::mesh:
      return "mesh";
    case ShapeType::tets:
      return "tets";
  }
  return "shape";
}

int size_count(ShapeType type) {
  switch (type) {
    case ShapeType::sphere:
      return 1;
    case ShapeType::capsule:
    case ShapeType::cylinder:
      return 2;
    case ShapeType::ellipsoid:
    case ShapeType::box:
      return 3;
    default:
      return 0;
  }
}

/// Area of the surface of a round shape [m^2]; 0 for others. That of an ellipsoid is within 10 % (the mean of the areas
/// of the ellipses of each two axes, times four).
double round_area(const Shape& shape) {
  const double r = shape.size[0], half = shape.size[1];
  const dvec3& e = shape.size;
  switch (shape.type) {
    case ShapeType::sphere:
      return 4 * kPi * r * r;
    case ShapeType::capsule:
      return 4 * kPi * r * (r + half);
    case ShapeType::cylinder:
      return 2 * kPi * r * (r + 2 * half);
    case ShapeType::ellipsoid:
      return 4 * kPi / 3 * (e.x * e.y + e.y * e.z + e.z * e.x);
    default:
      return 0;
  }
}

/// Throws Error if the tessellation would have too many triangles: a regular one of edge h has the area sqrt(3)/4 h^2.
void check_triangles(const Shape& shape, double most) {
  const double edge = tessellation_edge(shape), triangles = round_area(shape) / (0.25 * std::sqrt(3.0) * edge * edge);
  if (triangles > most)
    throw Error(
        fmt::format("a {} would have about {:.2g} triangles with edges of {:g} m, at most {:.0e} are made: "
                    "resolution must be at least {:.2g} m",
                    to_string(shape.type), triangles, edge, most, edge * std::sqrt(triangles / most)));
}

void check_shape(const Shape& shape, const Material& material) {
  for (int i = 0; i < size_count(shape.type); ++i) {
    if (!(shape.size[i] > 0) || !std::isfinite(shape.size[i]))
      throw Error(fmt::format("size {} of a {} must be positive, not {}", i, to_string(shape.type), shape.size[i]));
  }
  if (!(shape.resolution >= 0) || !std::isfinite(shape.resolution))
    throw Error(fmt::format("resolution must be 0 or more, not {}", shape.resolution));
  check_triangles(shape, material.compliant() ? kMaxSoftTriangles : kMaxRigidTriangles);
  const auto check_not_negative = [](double value, const char* what) {
    if (!(value >= 0) || !std::isfinite(value)) throw Error(fmt::format("{} must be 0 or more, not {}", what, value));
  };
  check_not_negative(material.modulus, "modulus");
  if (material.modulus > kMaxModulus)
    throw Error(fmt::format("modulus must be at most {:g} Pa, is {}", kMaxModulus, material.modulus));
  check_not_negative(material.thickness, "thickness");
  check_not_negative(material.dissipation, "dissipation");
  check_not_negative(material.friction, "friction");
  if (const std::string problem = law_problem(material.law); !problem.empty()) throw Error("law: " + problem);
  if (shape.type == ShapeType::tets && shape.tets == nullptr) throw Error("a body of tets needs a tetrahedral mesh");
  if (shape.rigid_only != nullptr && material.compliant())
    throw Error(fmt::format("{} can only be rigid: its modulus must be 0, is {}", shape.rigid_only, material.modulus));
  if (shape.type == ShapeType::mesh && (shape.mesh == nullptr || shape.mesh->face_count() == 0))
    throw Error("a mesh body needs a mesh with triangles");
}

/// The surface of any bounded shape; round ones tessellated.
TriMeshPtr surface_mesh(const Shape& shape) {
  const double r = shape.size[0], half = shape.size[1], edge = tessellation_edge(shape);
  const auto share = [](TriMesh mesh) { return std::make_shared<const TriMesh>(std::move(mesh)); };
  switch (shape.type) {
    case ShapeType::sphere:
      return share(make_round_sphere(r, edge));
    case ShapeType::capsule:
      return share(make_round_capsule(r, half, edge));
    case ShapeType::cylinder:
      return share(make_round_cylinder(r, half, edge));
    case ShapeType::ellipsoid:
      return share(make_round_ellipsoid(shape.size, edge));
    case ShapeType::box:
      return share(make_box(shape.size));
    case ShapeType::tets:
      return share(boundary_of(*shape.tets));
    default:
      return shape.mesh;
  }
}

/// A pad's thickness where none is given: an eighth of the smallest extent.
double pad_thickness(const TriMesh& mesh, const Material& material) {
  if (material.thickness > 0) return material.thickness;
  const dvec3 e = mesh.bounds().extent();
  return 0.125 * std::min({e.x, e.y, e.z});
}

/// A mesh and the user's numbers of its faces.
struct Skin {
  TriMeshPtr mesh;
  std::vector<int> face_numbers;
};

/// Only the outer shells can be touched: cavities inside get no field.
Skin skin_of(const Shape& shape) {
  Skin skin{surface_mesh(shape), shape.face_numbers};
  const std::vector<int> outer = outer_shells(*skin.mesh);
  if (static_cast<int>(outer.size()) == skin.mesh->shell_count()) return skin;
  std::vector<int> face_of;
  skin.mesh = std::make_shared<const TriMesh>(extract_shells(*skin.mesh, outer, &face_of));
  if (!shape.face_numbers.empty()) {
    for (int& f : face_of) f = shape.face_numbers[static_cast<std::size_t>(f)];
  }
  skin.face_numbers = std::move(face_of);
  return skin;
}

PressureFieldPtr make_medial_field(const Shape& shape, double modulus) {
  const double r = shape.size[0], half = shape.size[1], edge = tessellation_edge(shape);
  switch (shape.type) {
    case ShapeType::sphere:
      return make_sphere_field(r, modulus, edge);
    case ShapeType::capsule:
      return make_capsule_field(r, half, modulus, edge);
    case ShapeType::cylinder:
      return make_cylinder_field(r, half, modulus, edge);
    case ShapeType::ellipsoid:
      return make_ellipsoid_field(shape.size, modulus, edge);
    default:
      return make_box_field(shape.size, modulus);
  }
}

SoftBody make_field(const Shape& shape, const Material& material) {
  const bool is_mesh = shape.type == ShapeType::mesh;
  const bool is_tets = shape.type == ShapeType::tets;
  if (material.field == FieldKind::tets) {
    if (!is_tets)
      throw Error(fmt::format("field tets is for a shape of type tets, not for a {}", to_string(shape.type)));
    return SoftBody(make_tet_field(*shape.tets, material.modulus, material.thickness));
  }
  if (material.field == FieldKind::star) return SoftBody(make_star_field(skin_of(shape).mesh, material.modulus));
  if (material.field == FieldKind::pad && (is_mesh || is_tets || material.thickness > 0)) {
    const Skin skin = skin_of(shape);
    const double thickness = pad_thickness(*skin.mesh, material);
    return SoftBody(
        make_pad_field(skin.mesh, material.modulus, thickness, skin.face_numbers, PadLayering::automatic, shape.refine),
        std::make_shared<const DepthField>(skin.mesh, thickness, material.modulus / thickness));
  }
  if (is_mesh || is_tets)
    throw Error(fmt::format("field medial_axis is for primitives, not for a {}", to_string(shape.type)));
  return SoftBody(make_medial_field(shape, material.modulus));
}

HydroBody make(const Shape& shape, const Material& material) {
  check_shape(shape, material);
  HydroBody body;
  body.material = material;
  if (material.compliant()) body.law_levels = law_levels(material.law, kLawLevels);
  if (shape.type == ShapeType::plane) {
    if (!material.compliant()) {
      body.geometry = RigidHalfSpace{};
    } else {
      if (!(material.thickness > 0)) throw Error("a soft plane needs a thickness > 0");
      body.geometry = SoftHalfSpace{material.modulus / material.thickness, material.thickness};
    }
  } else if (material.compliant()) {
    body.geometry = make_field(shape, material);
  } else {
    const TriMeshPtr mesh = surface_mesh(shape);
    constexpr double kRounding = 1e-12;  // both sides of a sheet enclose no volume but this
    if (mesh->closed() && mesh->volume() < -kRounding * mesh->area() * mesh->bounds().diagonal())
      throw Error("the mesh is inside out: its triangles face inward");
    body.geometry = RigidMesh{std::make_shared<const MeshIndex>(mesh)};
  }
  return body;
}

}  // namespace

SoftBody::SoftBody(PressureFieldPtr f, std::shared_ptr<const DepthField> d)
    : field(std::move(f)),
      depth(std::move(d)),
      index(std::make_shared<const FieldIndex>(field, depth ? depth->skin().get() : nullptr)),
      matched(std::make_shared<MatchedFields>()) {}

RigidMesh::RigidMesh(std::shared_ptr<const MeshIndex> i)
    : index(std::move(i)), tree(std::make_shared<const FacetTree>(index->mesh())) {}

double tessellation_edge(const Shape& shape) {
  if (shape.resolution > 0) return shape.resolution;
  double extent = 2.0 * shape.size[0];
  if (shape.type == ShapeType::cylinder) extent = 2.0 * std::min(shape.size[0], shape.size[1]);
  if (shape.type == ShapeType::ellipsoid) extent = 2.0 * std::min({shape.size.x, shape.size.y, shape.size.z});
  return 0.1 * extent;
}

HydroBodyPtr make_body(const Shape& shape, const Material& material, const std::string& name) {
  try {
    HydroBody body = make(shape, material);
    body.name = name;
    return std::make_shared<const HydroBody>(std::move(body));
  } catch (const Error& error) {
    throw Error(error.file(), name, error.message());
  }
}

namespace {

using Key = std::tuple<ShapeType, std::array<double, 3>, double, FieldKind, FaceRule, std::array<double, 4>,
                       std::vector<double>>;

Key key_of(const Shape& shape, const Material& m) {
  return {shape.type, {shape.size.x, shape.size.y, shape.size.z},          shape.resolution, m.field,
          m.faces,    {m.modulus, m.thickness, m.dissipation, m.friction}, numbers_of(m.law)};
}

/// A body under a name of its own, which keeps alive the one that others find.
struct Named {
  HydroBody body;
  HydroBodyPtr first;
};

HydroBodyPtr under_name(HydroBodyPtr first, const std::string& name) {
  auto named = std::make_shared<Named>(*first, first);
  named->body.name = name;
  return {named, &named->body};
}

class BodyCache {
 public:
  HydroBodyPtr find_or_make(const Shape& shape, const Material& material, const std::string& name) {
    const Key key = key_of(shape, material);
    const std::lock_guard lock(mutex_);
    if (const auto found = bodies_.find(key); found != bodies_.end()) {
      if (HydroBodyPtr first = found->second.lock()) return under_name(std::move(first), name);
    }
    HydroBodyPtr made = make_body(shape, material, name);
    std::erase_if(bodies_, [](const auto& entry) { return entry.second.expired(); });
    bodies_[key] = made;
    return under_name(std::move(made), name);
  }

 private:
  std::mutex mutex_;
  std::map<Key, std::weak_ptr<const HydroBody>> bodies_;
};

}  // namespace

HydroBodyPtr share_body(const Shape& shape, const Material& material, const std::string& name) {
  const bool primitive = shape.type != ShapeType::mesh && shape.type != ShapeType::tets;
  if (!primitive) return make_body(shape, material, name);
  static BodyCache cache;
  return cache.find_or_make(shape, material, name);
}

namespace {

Aabb bounds_of(const std::vector<dvec3>& points) {
  Aabb box;
  for (const dvec3& x : points) box.include(x);
  return box;
}

}  // namespace

dvec3 inner_point(const HydroBody& body) {
  if (const auto* soft = std::get_if<SoftBody>(&body.geometry)) return bounds_of(soft->field->vertices()).center();
  const auto* rigid = std::get_if<RigidMesh>(&body.geometry);
  if (rigid == nullptr) return dvec3(0);
  const dvec3 middle = rigid->index->mesh().bounds().center();
  if (rigid->index->signed_distance(middle) <= 0) return middle;
  const std::vector<dvec3>& vertices = rigid->index->mesh().vertices();
  return *std::min_element(vertices.begin(), vertices.end(), [&](const dvec3& a, const dvec3& b) {
    return glm::distance(a, middle) < glm::distance(b, middle);
  });
}

BehindSkin behind_skin(const HydroBody& body, const dvec3& x) {
  if (const auto* space = std::get_if<SoftHalfSpace>(&body.geometry)) return {-x.z, space->thickness};
  const auto* soft = std::get_if<SoftBody>(&body.geometry);
  if (soft == nullptr || soft->depth == nullptr) return {};
  return {soft->depth->at(x).depth, soft->depth->thickness()};
}

RepairedMeshPtr repair_touched_mesh(Shape& shape, const Material& material, TouchedRepair repair) {
  const bool refused = shape.mesh == nullptr || shape.mesh->face_count() == 0 || shape.rigid_only != nullptr;
  if (shape.type != ShapeType::mesh || refused || repair == TouchedRepair::off) return nullptr;  // make_body() says why
  RepairRecipe recipe;
  if (!material.compliant() || repair == TouchedRepair::exact) recipe.level = RepairLevel::exact;
  recipe.has_two_sided_sheets = !material.compliant();
  RepairedMeshPtr repaired;
  try {
    repaired = repair_mesh(shape.mesh, recipe, material.thickness);
  } catch (const Error& error) {
    if (recipe.level != RepairLevel::exact) throw;
    throw Error("", error.where(),
                "the mesh has no inside that exact repairs find (" + error.message() +
                    "); write a closed one with taxel mesh FILE --repair wrap --out F.stl");
  }
  if (repaired->mesh == shape.mesh) return nullptr;
  std::vector<int> numbers = repaired->loaded_face_of;
  if (!shape.face_numbers.empty())
    for (int& face : numbers) face = face < 0 ? -1 : shape.face_numbers[static_cast<std::size_t>(face)];
  shape.mesh = repaired->mesh;
  shape.face_numbers = std::move(numbers);
  return repaired;
}

}  // namespace taxel
