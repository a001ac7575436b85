// Object, PoseReadings and SensorModel.read(): one model at many poses of one object.
#include <fmt/format.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <memory>
#include <optional>

#include "app/python/arrays.h"
#include "app/python/handles.h"
#include "app/python/interruptible.h"
#include "app/python/nouns.h"
#include "core/base/error.h"
#include "core/layout/words.h"
#include "core/sensor/contact_case/case_objects.h"
#include "core/sensor/contact_case/pose_readings.h"

namespace taxel::python {
namespace {

/// A touched object as Python holds it.
struct ObjectHandle {
  MadeBodyPtr made;
};

/// The result of SensorModel.read() as Python holds it.
struct PoseReadingsHandle {
  std::shared_ptr<const PoseReadings> rows;
  std::string unit;
};

/// Returns the text of a path-like object, or nothing for other objects.
std::optional<std::string> path_of(nb::handle object) {
  if (!nb::isinstance<nb::str>(object) && !nb::hasattr(object, "__fspath__")) return std::nullopt;
  return nb::cast<std::string>(nb::module_::import_("os").attr("fspath")(object));
}

MadeBodyPtr prepare_object(nb::handle body) {
  const std::optional<std::string> file = path_of(body);
  const std::string text =
      file ? *file : nb::cast<std::string>(nb::module_::import_("taxel.json_text").attr("dump")(body));
  const nb::gil_scoped_release release;
  if (!file) {
    const ContactCase contact_case = parse_case_object(text);
    return share_case_body(contact_case, contact_case.b, "object");
  }
  const ContactCase contact_case = read_contact_case(*file);
  const std::string name = object_of_case(contact_case);
  return share_case_body(contact_case, name == "a" ? contact_case.a : contact_case.b, name);
}

/// Returns the alternative of an enum that a word names. Throws ValueError naming the argument.
template <class Enum>
std::optional<Enum> chosen(const std::optional<std::string>& word, const char* argument) {
  if (!word) return std::nullopt;
  const std::optional<Enum> value = from_word<Enum>(*word);
  if (!value)
    throw nb::value_error(fmt::format("{}: must be one of {}, is \"{}\"", argument, word_list<Enum>(), *word).c_str());
  return value;
}

PoseReadingsHandle read(const SensorModelHandle& handle, const ObjectHandle& object, nb::handle poses,
                        const std::optional<std::string>& method, const std::optional<std::string>& aggregate,
                        int threads) {
  ReadoutChoice choice;
  choice.method = chosen<ReadingMethod>(method, "method");
  choice.aggregate = chosen<Aggregate>(aggregate, "aggregate");
  if (threads < 0) throw nb::value_error(fmt::format("threads: must not be negative, is {}", threads).c_str());
  const std::vector<Pose> path = poses_from_rows(read_numbers(poses, "poses", {-1, 7}));
  const SensorModelPtr model = handle.model;
  const MadeBodyPtr made = object.made;
  Progress progress;
  PoseReadingsHandle out;
  out.rows = run_interruptibly(progress, [&] {
    const SensorModelPtr chosen_model = choice.is_empty() ? model : with_readout(*model, choice);
    out.unit = reading_unit(chosen_model->layout.readout.aggregate);
    return std::make_shared<const PoseReadings>(read_poses(*chosen_model, *made->body, path, {threads, &progress}));
  });
  return out;
}

/// Returns a view of rows of `columns` numbers.
Matrix rows_of(const std::vector<double>& numbers, std::size_t rows, std::size_t columns, const Owner& owner) {
  return strided_view<Matrix>(numbers.data(), rows, columns * sizeof(double), {rows, columns}, owner);
}

void add_object(nb::module_& m) {
  nb::class_<ObjectHandle>(m, "Object",
                           "An object that sensors touch, prepared once: tessellation, repair, trees and, if the "
                           "object is soft, its pressure field. Immutable, and without a pose.")
      .def(
          "__init__", [](ObjectHandle* place, nb::handle body) { new (place) ObjectHandle{prepare_object(body)}; },
          nb::arg("body"),
          "`body` is a body of a contact case, such as {\"shape\": {\"type\": \"sphere\", \"size\": [0.004]}}: keys "
          "shape, material and resolution; lengths in metres, moduli in Pa, a mesh file relative to the working "
          "folder. "
          "Or it is the file of a contact case, whose shape is taken. Pose and velocities have no effect. "
          "An equal body of an earlier call is used again. Raises Error.")
      .def_prop_ro(
          "soft", [](const ObjectHandle& o) { return o.made->body->soft(); },
          "True if the object has a modulus greater than 0.")
      .def_prop_ro(
          "warnings", [](const ObjectHandle& o) { return o.made->warnings; }, "Sentences on repairs and problems.")
      .def("__repr__",
           [](const ObjectHandle& o) { return fmt::format("<Object: {}>", o.made->body->soft() ? "soft" : "rigid"); });
}

void add_rows(nb::module_& m) {
  nb::class_<PoseReadingsHandle>(m, "PoseReadings",
                                 "The result of SensorModel.read(), one row for each pose. Arrays are read-only.")
      .def_prop_ro(
          "readings",
          [](const PoseReadingsHandle& h) {
            return rows_of(h.rows->readings, h.rows->pose_count(), static_cast<std::size_t>(h.rows->taxels), h.rows);
          },
          nb::rv_policy::automatic, "Readings in `unit`, taxels in layout order, shape (poses, taxels).")
      .def_prop_ro(
          "wrench",
          [](const PoseReadingsHandle& h) { return rows_of(h.rows->wrenches, h.rows->pose_count(), 6, h.rows); },
          nb::rv_policy::automatic,
          "Force x, y, z [N] and torque x, y, z [N m] on the layout, about the origin and in the frame of its mesh "
          "file, shape (poses, 6).")
      .def_prop_ro(
          "area", [](const PoseReadingsHandle& h) { return view_of(h.rows->areas, h.rows); }, nb::rv_policy::automatic,
          "Area of the contact surfaces [m^2], shape (poses,); 0 without contact.")
      .def_prop_ro(
          "unit", [](const PoseReadingsHandle& h) { return h.unit; }, "Unit of the readings: Pa, Pa m^2 or N.")
      .def("__len__", [](const PoseReadingsHandle& h) { return h.rows->pose_count(); })
      .def("__repr__", [](const PoseReadingsHandle& h) {
        return fmt::format("<PoseReadings: {} poses, {} taxels>", h.rows->pose_count(), h.rows->taxels);
      });
}

void add_read(nb::module_& m) {
  auto type = nb::borrow<nb::class_<SensorModelHandle>>(m.attr("SensorModel"));
  type.def("read", read, nb::arg("object"), nb::arg("poses"), nb::kw_only(), nb::arg("method").none() = nb::none(),
           nb::arg("aggregate").none() = nb::none(), nb::arg("threads") = 0,
           "Reads the model at many poses of an Object, each a contact at rest, without a simulation. `poses` has the "
           "shape (n, 7): position x, y, z [m] and unit quaternion w, x, y, z of the object in the frame M of the "
           "layout's mesh file. `method` (\"samples\" or \"exact\") and `aggregate` replace those of the layout. "
           "`threads` limits the threads, 0 for all cores; the bits do not depend on it, and each row has those of "
           "`taxel read`. Python's lock is released, and Ctrl+C ends the call. Returns PoseReadings. Raises ValueError "
           "for another shape, a number that is not finite or an unknown word, and Error for a quaternion whose length "
           "is not 1 (to 0.001), and if layout and object are both rigid.");
}

}  // namespace

void add_pose_readings(nb::module_& m) {
  add_object(m);
  add_rows(m);
  add_read(m);
}

}  // namespace taxel::python
