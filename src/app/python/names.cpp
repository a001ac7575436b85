// Functions for taxel.attach: names for geoms without a name, as the window and the command line give them.
#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/set.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <string>
#include <vector>

#include "app/python/nouns.h"
#include "core/base/text/geom_labels.h"
#include "core/base/text/sensor_names.h"

namespace nb = nanobind;

namespace taxel::python {
namespace {

std::vector<std::string> labels_of(const std::vector<std::array<std::string, 5>>& geoms) {
  std::vector<GeomParts> parts;
  for (const auto& [name, body, class_name, mesh, type] : geoms) parts.push_back({name, body, class_name, mesh, type});
  return geom_labels(parts);
}

}  // namespace

void add_names(nb::module_& m) {
  m.def(
      "geom_labels", &labels_of, nb::arg("geoms"),
      "Labels of geoms, each given as name, body, class, mesh and type, with empty texts for missing names: the name, "
      "or body and class, mesh or type. All labels differ.");
  m.def(
      "sensor_name", &sensor_name, nb::arg("body"), nb::arg("taken"),
      "Name for a sensor on a geom without a name, and for the geom: that of the body, or the first of BODY_2, BODY_3, "
      "... that is not in `taken`.");
}

}  // namespace taxel::python
