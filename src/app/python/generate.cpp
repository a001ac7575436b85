// generate(): a layout by a pattern of taxels on a mesh.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/python/arrays.h"
#include "app/python/handles.h"
#include "app/python/nouns.h"
#include "core/layout/generators/generated_layout.h"

namespace taxel::python {
namespace {
namespace nb = nanobind;

std::optional<dvec3> optional_vector(nb::handle value, const char* name) {
  return value.is_none() ? std::nullopt : std::optional(read_vector(value, name));
}

nb::tuple generate(const std::string& mesh, const std::string& pattern, const PatternTexts& values,
                   const std::string& region, nb::handle pad, nb::handle distal, nb::handle at, nb::handle scale,
                   const std::string& table, const std::string& image) {
  GenerateRequest request{pattern,
                          values,
                          region,
                          optional_vector(pad, "pad"),
                          optional_vector(distal, "distal"),
                          optional_vector(at, "at"),
                          table,
                          image,
                          optional_vector(scale, "scale")};
  GeneratedLayout made;
  {
    const nb::gil_scoped_release without_lock;
    made = generate_layout(mesh, request);
  }
  LayoutHandle handle{std::make_shared<const Layout>(std::move(made.layout)), ""};
  handle.value = std::make_shared<const Layout>(with_absolute_mesh(handle));
  return nb::make_tuple(handle, made.left_out, made.notes);
}

}  // namespace

void add_generate(nb::module_& m) {
  m.def("generate", &generate, nb::arg("mesh"), nb::arg("pattern"), nb::arg("values"), nb::arg("region"),
        nb::arg("pad").none(), nb::arg("distal").none(), nb::arg("at").none(), nb::arg("scale").none(),
        nb::arg("table"), nb::arg("image"), "See taxel.generate().");
}

}  // namespace taxel::python
