// contact(): one contact between two bodies, and the readings of a model in it.
#include <fmt/format.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <memory>
#include <optional>

#include "app/python/arrays.h"
#include "app/python/handles.h"
#include "app/python/nouns.h"
#include "core/hydro/intersect.h"
#include "core/sensor/contact_case/case_objects.h"
#include "core/sensor/contact_case/contact_case.h"
#include "core/sensor/readout/reading.h"

namespace taxel::python {
namespace {

/// A contact with its surface in the world frame.
struct Contact {
  ContactResult result;
  std::vector<dvec3> vertices_W, normals_W;
  std::vector<int> offsets{0};  ///< first vertex of each polygon, and the number of vertices
  std::vector<double> areas;
  std::vector<std::string> warnings;
  std::optional<std::vector<double>> readings;
};
using ContactPtr = std::shared_ptr<const Contact>;

void expand_surface(Contact& contact, const Pose& X_WA) {
  const RigidTransform to_world(X_WA);
  const ContactSurface& surface = contact.result.surface;
  for (const dvec3& vertex : surface.vertices) contact.vertices_W.push_back(to_world(vertex));
  for (const ContactPolygon& polygon : surface.polygons) {
    contact.offsets.push_back(polygon.first + polygon.count);
    contact.normals_W.push_back(to_world.R * polygon.normal);
    contact.areas.push_back(polygon.area);
  }
}

/// Computes the readings of the model, which is body a.
std::vector<double> read_model(const SensorModel& model, const ContactCase& contact_case, const HydroBody& b,
                               const ContactSurface& surface) {
  const ContactSurface* const surfaces[] = {&surface};
  const SurfaceMotion motions[] = {
      {combine(model.body->material, b.material), relative_twist(contact_case.a, contact_case.b)}};
  SensorReading reading;
  read_sensor(model, surfaces, reading, RayPath::fastest, motions);
  return reading.values;
}

/// Computes a case. With `model`, body a of the case has only a pose and velocities.
ContactPtr evaluate(const std::string& text, const std::string& file, const SensorModelPtr& model) {
  const ContactCase contact_case = parse_contact_case(text, file);
  const bool is_bare = !contact_case.a.shape && contact_case.a.layout.empty();
  if (model && !is_bare) throw Error(file, "/a", "must have neither shape nor layout, because the model is body a");
  if (!model && is_bare) throw Error(file, "/a", "must have a shape or a layout");
  MadeBodyPtr shared_a = std::make_shared<const MadeBody>();
  if (!model) shared_a = share_case_body(contact_case, contact_case.a, "a");
  const MadeBody& a = *shared_a;
  const MadeBodyPtr shared_b = share_case_body(contact_case, contact_case.b, "b");
  const MadeBody& b = *shared_b;
  const SensorModelPtr sensor = model ? model : a.model;
  const HydroBody& body_a = model ? *model->body : *a.body;
  auto contact = std::make_shared<Contact>();
  contact->warnings = a.warnings;
  contact->warnings.insert(contact->warnings.end(), b.warnings.begin(), b.warnings.end());
  IntersectWorkspace workspace;
  evaluate_contact(contact_case, body_a, *b.body, contact->result, workspace);
  expand_surface(*contact, contact_case.a.X_WB);
  if (sensor) contact->readings = read_model(*sensor, contact_case, *b.body, contact->result.surface);
  return contact;
}

ContactPtr evaluate_unlocked(const std::string& text, const std::string& file, SensorModelPtr model) {
  const nb::gil_scoped_release release;
  return evaluate(text, file, model);
}

/// A Python object of a contact.
struct ContactHandle {
  ContactPtr contact;
};

void add_surface(nb::class_<ContactHandle>& type) {
  type.def_prop_ro(
          "vertices", [](const ContactHandle& c) { return view_of(c.contact->vertices_W, c.contact); },
          nb::rv_policy::automatic, "Corners of all polygons [m], world frame, shape (v, 3).")
      .def_prop_ro(
          "pressures",
          [](const ContactHandle& c) {
            const auto& pressure = c.contact->result.surface.pressure;
            return strided_view<Vector>(pressure.data(), pressure.size(), sizeof(double), {pressure.size()}, c.contact);
          },
          nb::rv_policy::automatic, "Elastic pressure at each corner [Pa], shape (v,).")
      .def_prop_ro(
          "offsets", [](const ContactHandle& c) { return view_of(c.contact->offsets, c.contact); },
          nb::rv_policy::automatic, "Corners of polygon i: offsets[i] to offsets[i + 1], shape (p + 1,).")
      .def_prop_ro(
          "normals", [](const ContactHandle& c) { return view_of(c.contact->normals_W, c.contact); },
          nb::rv_policy::automatic,
          "Unit normals of the polygons, in the direction of the push on a, world frame, shape (p, 3).")
      .def_prop_ro(
          "areas", [](const ContactHandle& c) { return view_of(c.contact->areas, c.contact); },
          nb::rv_policy::automatic, "Areas of the polygons [m^2], shape (p,).");
}

}  // namespace

void add_contact(nb::module_& m) {
  nb::class_<ContactHandle> type(m, "Contact", "One contact between two bodies, in SI units and the world frame.");
  add_surface(type);
  type.def_prop_ro(
          "force", [](const ContactHandle& c) { return array_of(c.contact->result.wrench_W.force); },
          nb::rv_policy::automatic, "Force on body a [N], shape (3,).")
      .def_prop_ro(
          "torque", [](const ContactHandle& c) { return array_of(c.contact->result.wrench_W.torque); },
          nb::rv_policy::automatic, "Torque on body a about its origin [N m], shape (3,).")
      .def_prop_ro(
          "centroid", [](const ContactHandle& c) { return array_of(c.contact->result.centroid_W); },
          nb::rv_policy::automatic, "Centre of pressure [m], shape (3,); the origin of a without contact.")
      .def_prop_ro(
          "area", [](const ContactHandle& c) { return c.contact->result.surface.area(); }, "Area of the surface [m^2].")
      .def_prop_ro(
          "max_pressure", [](const ContactHandle& c) { return c.contact->result.surface.max_pressure(); },
          "Largest elastic pressure [Pa].")
      .def_prop_ro(
          "readings",
          [](const ContactHandle& c) -> std::optional<Vector> {
            if (!c.contact->readings) return std::nullopt;
            return view_of(*c.contact->readings, c.contact);
          },
          nb::rv_policy::automatic,
          nb::for_getter(nb::sig("def readings(self, /) -> numpy.typing.NDArray[numpy.float64] | typing.Any")),
          "Readings of the sensor's taxels in the unit of its layout, shape (n,); None if neither body is a sensor.")
      .def_prop_ro(
          "warnings", [](const ContactHandle& c) { return c.contact->warnings; }, "Sentences on the two bodies.")
      .def("__repr__", [](const ContactHandle& c) {
        const ContactSurface& surface = c.contact->result.surface;
        return fmt::format("<Contact: {} polygons, {:.6g} m^2, {:.6g} Pa>", surface.polygons.size(), surface.area(),
                           surface.max_pressure());
      });
  m.def(
      "contact",
      [](const std::string& text, const std::filesystem::path& file, const SensorModelHandle* model) {
        return ContactHandle{evaluate_unlocked(text, file.string(), model != nullptr ? model->model : nullptr)};
      },
      nb::arg("text"), nb::arg("file"), nb::arg("model").none() = nb::none(),
      "Computes the contact case of a JSON text. Raises Error.");
}

}  // namespace taxel::python
