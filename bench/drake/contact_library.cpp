// The contact kernel behind plain C functions, so that Python can time it in the process that runs Drake. Poses are
// seven numbers, x y z and the quaternion w x y z. A function that fails returns null or a negative number;
// last_error() says why.
#include <algorithm>
#include <chrono>
#include <memory>
#include <string>

#include <hwy/targets.h>

#include "core/base/error.h"
#include "core/hydro/fields/tet_mesh.h"
#include "core/hydro/hydro_body.h"
#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"
#include "core/mesh/mesh_io.h"
#include "core/sensor/sensor_model.h"
#include "fixtures/brute_force_contact.h"

#define TAXEL_EXPORT __attribute__((visibility("default")))

namespace {
using namespace taxel;

thread_local std::string error_text;

struct Body {
  HydroBodyPtr body;
};

/// Memory of one pair, kept from call to call as a simulation keeps it.
struct Pair {
  HydroBodyPtr a, b;
  ContactSurface surface;
  IntersectWorkspace workspace;
};

Pose pose_of(const double* v) {
  return {dquat(v[3], v[4], v[5], v[6]), dvec3(v[0], v[1], v[2])};
}

template <class Make>
Body* guarded(const Make& make) {
  try {
    return new Body{make()};
  } catch (const std::exception& e) {
    error_text = e.what();
    return nullptr;
  }
}

const PressureField* field_of(const HydroBody& body) {
  const auto* soft = std::get_if<SoftBody>(&body.geometry);
  return soft == nullptr ? nullptr : soft->field.get();
}

}  // namespace

extern "C" {

/// Result of one contact, world frame. The force acts on A.
struct TaxelContact {
  double nanoseconds;  ///< time of the fastest repetition
  double polygons, area, max_pressure;
  double force[3];
  double centroid[3];  ///< centroid of the area
  double pressure_centroid[3];
  double back_faces;  ///< number of polygons that oppose the pressure: they do not count, or in part
};

TAXEL_EXPORT const char* taxel_last_error() {
  return error_text.c_str();
}

/// Builds a body from a primitive, or from a file with a mesh or with tets as legacy VTK (with their pressures, or with
/// Drake's field). Modulus 0 means rigid.
TAXEL_EXPORT Body* taxel_shape(int type, const double* size, const char* file, double resolution, int field,
                               double modulus, double thickness) {
  return guarded([&] {
    Shape shape;
    shape.type = static_cast<ShapeType>(type);
    shape.size = dvec3(size[0], size[1], size[2]);
    shape.resolution = resolution;
    if (shape.type == ShapeType::mesh) shape.mesh = load_mesh(file).mesh;
    if (shape.type == ShapeType::tets) shape.tets = std::make_shared<const TetMesh>(load_vtk_tets(file));
    Material material;
    material.field = static_cast<FieldKind>(field);
    material.modulus = modulus;
    material.thickness = thickness;
    return make_body(shape, material, "shape");
  });
}

/// Builds the soft body of a layout.
TAXEL_EXPORT Body* taxel_layout(const char* file) {
  return guarded([&] { return load_sensor_model(file)->body; });
}

TAXEL_EXPORT void taxel_free_body(Body* body) {
  delete body;
}

/// Sets the numbers of vertices and tets of a soft body. Returns false for other bodies.
TAXEL_EXPORT bool taxel_field_size(const Body* body, int* vertex_count, int* tet_count) {
  const PressureField* field = field_of(*body->body);
  if (field == nullptr) return false;
  *vertex_count = static_cast<int>(field->vertices().size());
  *tet_count = static_cast<int>(field->tets().size());
  return true;
}

TAXEL_EXPORT void taxel_field(const Body* body, double* vertices, int* tets, double* pressure) {
  const PressureField& field = *field_of(*body->body);
  for (const dvec3& x : field.vertices()) {
    for (int k = 0; k < 3; ++k) *vertices++ = x[k];
  }
  for (const Tet& tet : field.tets()) {
    for (int k = 0; k < 4; ++k) *tets++ = tet.vertices[k];
  }
  std::copy(field.vertex_pressure().begin(), field.vertex_pressure().end(), pressure);
}

/// Makes a pair. If `all_faces` is true, back faces count too, as they do by brute force.
TAXEL_EXPORT Pair* taxel_pair(const Body* a, const Body* b, bool all_faces) {
  const auto made = [&](const Body* body) {
    HydroBody copy = *body->body;
    if (all_faces) copy.material.faces = FaceRule::all;
    return std::make_shared<const HydroBody>(std::move(copy));
  };
  return new Pair{made(a), made(b), {}, {}};
}

TAXEL_EXPORT void taxel_free_pair(Pair* pair) {
  delete pair;
}

/// Computes the surface of a pair `repeat` times. Returns 0, or -1 if the kernel refuses the pair.
TAXEL_EXPORT int taxel_contact(Pair* pair, const double* pose_a, const double* pose_b, int repeat, TaxelContact* out) {
  const Pose X_WA = pose_of(pose_a), X_WB = pose_of(pose_b);
  *out = {};
  try {
    for (int i = 0; i < repeat; ++i) {
      const auto start = std::chrono::steady_clock::now();
      intersect(*pair->a, *pair->b, X_WA, X_WB, pair->surface, pair->workspace);
      const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
      out->nanoseconds = i == 0 ? time.count() : std::min(out->nanoseconds, time.count());
    }
  } catch (const std::exception& e) {
    error_text = e.what();
    return -1;
  }
  const ContactSurface& surface = pair->surface;
  out->polygons = static_cast<double>(surface.polygons.size());
  out->area = surface.area();
  out->max_pressure = surface.max_pressure();
  out->back_faces = surface.left_out(Rejection::back_face).count;
  dvec3 moment{0};
  for (const ContactPolygon& polygon : surface.polygons) moment += polygon.area * polygon.centroid;
  const auto write = [](const dvec3& v, double* to) { std::copy_n(&v[0], 3, to); };
  if (surface.empty()) return 0;
  write(X_WA.rotate(pressure_wrench(surface).force), out->force);
  write(X_WA * (moment / out->area), out->centroid);
  write(X_WA * center_of_pressure(surface), out->pressure_centroid);
  return 0;
}

/// Computes the surface once by brute force, every tet against every triangle or tet: time, polygons, area and force.
/// Returns -1 unless the pair is a soft body of tets with a rigid mesh or with another soft body of tets.
TAXEL_EXPORT int taxel_brute_force(const Pair* pair, const double* pose_a, const double* pose_b, TaxelContact* out) {
  const Pose X_WA = pose_of(pose_a), X_AB = X_WA.inverse() * pose_of(pose_b);
  const PressureField *field_A = field_of(*pair->a), *field_B = field_of(*pair->b);
  const auto* mesh_B = std::get_if<RigidMesh>(&pair->b->geometry);
  *out = {};
  if (field_A == nullptr || (field_B == nullptr && mesh_B == nullptr)) {
    error_text = "brute force takes a soft body of tets and a rigid mesh or another soft body of tets";
    return -1;
  }
  const auto start = std::chrono::steady_clock::now();
  const BruteForceContact found = field_B != nullptr ? brute_force_contact(*field_A, *field_B, X_AB)
                                                     : brute_force_contact(*field_A, mesh_B->index->mesh(), X_AB);
  out->nanoseconds = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
  out->polygons = found.polygons;
  out->area = found.area;
  const dvec3 force = X_WA.rotate(found.force);
  std::copy_n(&force[0], 3, out->force);
  return 0;
}

/// Makes the kernel use the instruction set of this name ("AVX2", "AVX3", "SSE4", "EMU128"). Returns false if the
/// processor or this build does not have it.
TAXEL_EXPORT bool taxel_use_instruction_set(const char* name) {
  for (std::int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    if (std::string(hwy::TargetName(target)) != name) continue;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return true;
  }
  return false;
}

}  // extern "C"
