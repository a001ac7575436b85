#include "core/sensor/contact_case/contact_case.h"

#include <fmt/format.h>

#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/fields/tet_mesh.h"
#include "core/hydro/hydro_body.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repair.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace fs = std::filesystem;

fs::path beside_case(const ContactCase& contact_case, const std::string& file) {
  const fs::path path(file);
  return path.is_absolute() ? path : fs::path(contact_case.file).parent_path() / path;
}

dquat unit_quaternion(double w, double x, double y, double z) {
  const double squared = w * w + x * x + y * y + z * z;
  const double length = std::abs(squared - 1.0) > 1e-12 ? std::sqrt(squared) : 1.0;
  return {w / length, x / length, y / length, z / length};
}

namespace {

/// Loads the mesh, tets or height field of a body's shape into `shape`. Repairs a mesh, and adds repairs
/// and problems to `warnings`.
void load_shape(const ContactCase& contact_case, const CaseBody& body, const std::string& name, Shape& shape,
                std::vector<std::string>& warnings) {
  const CaseShape& from = *body.shape;
  const std::string pointer = "/" + name + "/shape/file: ";
  if (from.height_field) {
    shape.mesh = std::make_shared<const TriMesh>(make_height_field(*from.height_field));
    shape.rigid_only = "a height field";
  } else if (shape.type == ShapeType::mesh) {
    LoadedMesh loaded = load_mesh(beside_case(contact_case, from.file), from.scale);
    shape.mesh = loaded.mesh;
    shape.face_numbers = std::move(loaded.file_face_of);
    for (const std::string& note : loaded.notes) warnings.push_back(pointer + note);
    const RepairedMeshPtr repaired = repair_touched_mesh(shape, body.material, from.repair);
    if (repaired != nullptr)
      for (const Problem& p : repair_problems(repaired->report, from.file)) warnings.push_back(pointer + p.message);
    if (repaired != nullptr && repaired->report.has_sheets) return;  // these are open, and need no inside
    for (const Problem& p : check_mesh(*shape.mesh, from.file)) {
      if (p.severity != Severity::note) warnings.push_back(pointer + p.message + (p.fix.empty() ? "" : "; " + p.fix));
    }
  } else if (shape.type == ShapeType::tets) {
    shape.tets = std::make_shared<const TetMesh>(load_vtk_tets(beside_case(contact_case, from.file), from.scale));
  }
}

}  // namespace

const FieldReport* MadeBody::field_report() const {
  const auto* soft = std::get_if<SoftBody>(&body->geometry);
  return soft != nullptr ? &soft->field->report() : nullptr;
}

MadeBody make_case_body(const ContactCase& contact_case, const CaseBody& body, const std::string& name) {
  MadeBody made;
  if (!body.layout.empty()) {
    made.model = load_sensor_model(beside_case(contact_case, body.layout));
    made.body = made.model->body;
    for (const Problem& problem : made.model->problems) {
      if (problem.severity != Severity::note) made.warnings.push_back(problem.pointer + ": " + problem.message);
    }
    return made;
  }
  if (!body.shape) throw Error(contact_case.file, "/" + name, "needs a shape or a layout");
  Shape shape;
  shape.type = body.shape->type;
  shape.size = body.shape->size;
  shape.resolution = body.shape->resolution;
  try {
    load_shape(contact_case, body, name, shape, made.warnings);
    made.body = make_body(shape, body.material, name);
    made.shape = std::move(shape);
  } catch (const Error& e) {
    if (!e.file().empty()) throw;  // the error is about another file, which it names
    throw Error(contact_case.file, "/" + name, e.message());
  }
  if (const FieldReport* report = made.field_report()) {
    for (const Problem& p : field_problems(*report, contact_case.file, "/" + name)) {
      if (p.severity != Severity::note) made.warnings.push_back(p.pointer + ": " + p.message);
    }
  }
  return made;
}

Twist relative_twist(const CaseBody& a, const CaseBody& b) {
  // Velocity of the point of B at A's origin: v_B + omega_B x (p_A - p_B)
  const dvec3 of_B = b.V_WB.linear + glm::cross(b.V_WB.angular, a.X_WB.p - b.X_WB.p);
  const dmat3 R_AW = glm::transpose(a.X_WB.rotation());
  return {R_AW * (a.V_WB.linear - of_B), R_AW * (a.V_WB.angular - b.V_WB.angular)};
}

void evaluate_contact(const ContactCase& contact_case, const HydroBody& a, const HydroBody& b, ContactResult& out,
                      IntersectWorkspace& workspace) {
  const Pose& X_WA = contact_case.a.X_WB;
  intersect(a, b, X_WA, contact_case.b.X_WB, out.surface, workspace);
  if (out.surface.empty()) {
    out.wrench_W = {};
    out.centroid_W = X_WA.p;
    return;
  }
  const Twist V_BA = relative_twist(contact_case.a, contact_case.b);
  const bool at_rest = V_BA.linear == dvec3(0) && V_BA.angular == dvec3(0);  // then neither friction nor damping acts
  const Wrench wrench =
      at_rest ? pressure_wrench(out.surface) : traction(out.surface, combine(a.material, b.material), V_BA).wrench;
  out.wrench_W = {X_WA.rotate(wrench.force), X_WA.rotate(wrench.torque)};
  out.centroid_W = X_WA * center_of_pressure(out.surface);
  if (!is_finite(out.wrench_W.force) || !is_finite(out.wrench_W.torque) || !is_finite(out.centroid_W))
    throw Error(contact_case.file, "the contact force is not finite: a velocity, dissipation or size is too large");
}

}  // namespace taxel
