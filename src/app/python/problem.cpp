// Errors of the core as Python exceptions, and problems as values.
#include <fmt/format.h>
#include <nanobind/stl/string.h>

#include "app/python/arrays.h"
#include "app/python/nouns.h"
#include "core/base/error.h"
#include "core/base/text/message.h"

namespace taxel::python {
namespace {

namespace nb = nanobind;

/// Raises taxel.Error, a class in Python, with the three parts of an Error. Paths may be no UTF-8.
void raise_error(const Error& error) {
  const nb::object type = nb::module_::import_("taxel.errors").attr("Error");
  const nb::object value = type(path_text(error.file()), shown_part(error.where()), shown_part(error.message()));
  PyErr_SetObject(type.ptr(), value.ptr());
}

/// Returns the text of a member, which may quote a file, for Python.
auto shown(std::string Problem::*text) {
  return [text](const Problem& problem) { return shown_part(problem.*text); };
}

void translate(const std::exception_ptr& pointer, void*) {
  try {
    std::rethrow_exception(pointer);
  } catch (const Error& error) {
    raise_error(error);
  }
}

}  // namespace

void add_problem(nb::module_& m) {
  nb::register_exception_translator(translate);
  nb::class_<Problem>(m, "Problem", "One broken rule of a layout, as `Layout.check` lists it.")
      .def_prop_ro(
          "file", [](const Problem& p) { return path_text(p.file); }, "Name of the layout's file; may be empty.")
      .def_prop_ro("pointer", shown(&Problem::pointer),
                   "JSON pointer such as /taxels/3/radius; empty for the whole file.")
      .def_prop_ro(
          "severity", [](const Problem& p) { return to_string(p.severity); }, "\"error\", \"warning\" or \"note\".")
      .def_ro("code", &Problem::code, "Stable word of the rule, such as radius_not_positive.")
      .def_prop_ro("message", shown(&Problem::message), "One sentence with the value that breaks the rule.")
      .def_prop_ro("fix", shown(&Problem::fix), "The remedy; may be empty.")
      .def("__repr__", [](const Problem& p) {
        return fmt::format("<Problem {}: {}: {}>", to_string(p.severity), shown_part(p.pointer), shown_part(p.message));
      });
}

}  // namespace taxel::python
