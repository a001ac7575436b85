// material(): the modulus of a pad from a data sheet, and the known elastomers.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <optional>

#include "app/python/nouns.h"
#include "core/base/error.h"
#include "core/hydro/material/elastomers.h"
#include "core/hydro/material/pad_modulus.h"

namespace taxel::python {
namespace {
namespace nb = nanobind;

nb::dict elastomers_by_word() {
  nb::dict all;
  for (const Elastomer& one : elastomers()) {
    nb::dict item;
    item["title"] = one.title;
    item["youngs"] = one.youngs;
    item["poisson"] = one.poisson;
    item["density"] = one.density;
    item["source"] = one.source;
    item["unverified"] = one.unverified;
    all[one.word.c_str()] = item;
  }
  return all;
}

nb::dict material(double youngs, double poisson, double thickness, bool bonded, std::optional<double> contact_radius,
                  bool cylinder) {
  const ElasticLayer layer{youngs, poisson, thickness, bonded ? LayerBase::bonded : LayerBase::sliding};
  PadModulus result;
  try {
    const nb::gil_scoped_release without_lock;
    result = pad_modulus(layer, contact_radius, cylinder ? PressedBody::cylinder : PressedBody::ball);
  } catch (const Error& e) {
    throw Error("material", e.where(), e.message());
  }
  nb::dict values;
  values["modulus"] = result.modulus;
  values["thickness"] = thickness;
  values["thin_layer_modulus"] = result.thin_layer;
  values["holds_from"] = result.holds ? std::optional(result.holds->low) : std::nullopt;
  values["holds_to"] = result.holds ? std::optional(result.holds->high) : std::nullopt;
  values["poisson_limit"] = result.poisson_limit;
  return values;
}

}  // namespace

void add_material(nb::module_& m) {
  m.def("elastomers", &elastomers_by_word, "Known elastomers with the sources of their numbers.");
  m.def("material", &material, nb::arg("youngs"), nb::arg("poisson"), nb::arg("thickness"), nb::arg("bonded"),
        nb::arg("contact_radius").none(), nb::arg("cylinder"), "See taxel.material().");
}

}  // namespace taxel::python
