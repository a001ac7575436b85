#include "app/python/layout_edits.h"

#include <fmt/format.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <charconv>
#include <string_view>

#include "app/python/arrays.h"
#include "core/document/apply_edit.h"

namespace taxel::python {
namespace {

/// Returns the JSON pointer of a place such as "taxel 3: radius", which apply_edit() names by the id of the taxel.
/// Returns other places, and taxels that are not in the layout, as they are.
std::string pointer_of(const Layout& layout, const std::string& place) {
  constexpr std::string_view kTaxel = "taxel ";
  if (!place.starts_with(kTaxel)) return place;
  int id = 0;
  const char* const last = place.data() + place.size();
  const auto [end, error] = std::from_chars(place.data() + kTaxel.size(), last, id);
  if (error != std::errc() || find_taxel(layout, id) == nullptr) return place;
  std::string field(end, last);
  if (field.starts_with(": ")) field.replace(0, 2, "/");
  return fmt::format("/taxels/{}{}", taxel_index(layout, id), field);
}

void edit(LayoutHandle& layout, const Edit& change) {
  try {
    layout.value = std::make_shared<const Layout>(apply_edit({*layout.value, {}, {}, {}, {}}, change).layout);
  } catch (const Error& e) {
    throw Error(e.file().empty() ? layout.file : e.file(), pointer_of(*layout.value, e.where()), e.message());
  }
}

std::vector<int> ids_of(const LayoutHandle& layout) {
  std::vector<int> ids;
  for (const Taxel& taxel : layout.value->taxels) ids.push_back(taxel.id);
  return ids;
}

void check_count(const char* name, std::size_t found, std::size_t expected) {
  if (found == expected) return;
  throw nb::value_error(fmt::format("{}: must have {} values, has {}", name, expected, found).c_str());
}

/// The new values of some taxels; a null object leaves the values unchanged.
struct NewValues {
  nb::object centers, normals, radii, names;
};

/// Returns one change for each id.
std::vector<TaxelChange> changes_of(const std::vector<int>& ids, const NewValues& values) {
  std::vector<TaxelChange> changes(ids.size());
  const auto count = static_cast<std::int64_t>(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) changes[i].id = ids[i];
  if (!values.centers.is_none()) {
    const std::vector<dvec3> centers = read_vectors(values.centers, "centers", count);
    for (std::size_t i = 0; i < ids.size(); ++i) changes[i].center = centers[i];
  }
  if (!values.normals.is_none()) {
    const std::vector<dvec3> normals = read_vectors(values.normals, "normals", count);
    for (std::size_t i = 0; i < ids.size(); ++i) changes[i].normal = normals[i];
  }
  if (!values.radii.is_none()) {
    const std::vector<double> radii = read_numbers(values.radii, "radii", {count});
    for (std::size_t i = 0; i < ids.size(); ++i) changes[i].radius = radii[i];
  }
  if (!values.names.is_none()) {
    const auto names = nb::cast<std::vector<std::string>>(values.names);
    check_count("names", names.size(), ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) changes[i].name = names[i];
  }
  return changes;
}

void set_taxels(LayoutHandle& layout, nb::handle ids, nb::object centers, nb::object normals, nb::object radii,
                nb::object names) {
  edit(layout, SetTaxels{changes_of(read_integers(ids, "ids"), {centers, normals, radii, names}), false});
}

Integers add_taxels(LayoutHandle& layout, nb::handle centers, nb::handle normals, nb::handle radii,
                    const std::vector<std::string>& names) {
  const std::vector<dvec3> places = read_vectors(centers, "centers");
  const auto count = static_cast<std::int64_t>(places.size());
  const std::vector<dvec3> directions = read_vectors(normals, "normals", count);
  const std::vector<double> sizes = read_numbers(radii, "radii", {count});
  if (!names.empty()) check_count("names", names.size(), places.size());
  const std::vector<int> ids = unused_ids(*layout.value, places.size());
  AddTaxels added;
  for (std::size_t i = 0; i < places.size(); ++i)
    added.taxels.push_back({ids[i], names.empty() ? "" : names[i], places[i], directions[i], sizes[i], {}});
  edit(layout, added);
  return array_of(ids);
}

void mirror_taxels(LayoutHandle& layout, nb::handle ids, nb::handle normal, nb::handle point) {
  edit(layout, MirrorTaxels{read_integers(ids, "ids"), {read_vector(point, "point"), read_vector(normal, "normal")}});
}

}  // namespace

void set_name(LayoutHandle& layout, const std::string& name) {
  edit(layout, SetName{name});
}

void set_names(LayoutHandle& layout, const std::vector<std::string>& names) {
  edit(layout, SetTaxels{changes_of(ids_of(layout), {nb::none(), nb::none(), nb::none(), nb::cast(names)}), false});
}

void set_centers(LayoutHandle& layout, nb::handle centers) {
  edit(layout, SetTaxels{changes_of(ids_of(layout), {nb::borrow(centers), nb::none(), nb::none(), nb::none()}), false});
}

void set_normals(LayoutHandle& layout, nb::handle normals) {
  edit(layout, SetTaxels{changes_of(ids_of(layout), {nb::none(), nb::borrow(normals), nb::none(), nb::none()}), false});
}

void set_radii(LayoutHandle& layout, nb::handle radii) {
  edit(layout, SetTaxels{changes_of(ids_of(layout), {nb::none(), nb::none(), nb::borrow(radii), nb::none()}), false});
}

void add_edits(nb::class_<LayoutHandle>& type) {
  type.def(
          "set_taxels", set_taxels, nb::arg("ids"), nb::kw_only(), nb::arg("centers") = nb::none(),
          nb::arg("normals") = nb::none(), nb::arg("radii") = nb::none(), nb::arg("names") = nb::none(),
          nb::sig("def set_taxels(self, ids: numpy.typing.ArrayLike, *, centers: numpy.typing.ArrayLike | None = None, "
                  "normals: numpy.typing.ArrayLike | None = None, radii: numpy.typing.ArrayLike | None = None, "
                  "names: typing.Sequence[str] | None = None) -> None"),
          "Changes some taxels: centers (n, 3) [m], normals (n, 3), radii (n,) [m] for n ids. Raises Error.")
      .def("add_taxels", add_taxels, nb::arg("centers"), nb::arg("normals"), nb::arg("radii") = 0.006,
           nb::arg("names") = std::vector<std::string>{},
           nb::sig("def add_taxels(self, centers: numpy.typing.ArrayLike, normals: numpy.typing.ArrayLike, "
                   "radii: numpy.typing.ArrayLike = 0.006, names: typing.Sequence[str] = ()) -> "
                   "numpy.typing.NDArray[numpy.int32]"),
           "Adds taxels at the end: centers (n, 3) [m], normals (n, 3), radii (n,) or one [m]. Returns their ids (n,). "
           "Raises Error.")
      .def(
          "delete_taxels",
          [](LayoutHandle& layout, nb::handle ids) { edit(layout, DeleteTaxels{read_integers(ids, "ids")}); },
          nb::arg("ids"), nb::sig("def delete_taxels(self, ids: numpy.typing.ArrayLike) -> None"),
          "Deletes the taxels with these ids. Raises Error for an unknown id.")
      .def(
          "reorder_taxels",
          [](LayoutHandle& layout, nb::handle ids) { edit(layout, ReorderTaxels{read_integers(ids, "ids")}); },
          nb::arg("ids"), nb::sig("def reorder_taxels(self, ids: numpy.typing.ArrayLike) -> None"),
          "Changes the order of the taxels and of the readings. Lists all ids. Raises Error.")
      .def("mirror_taxels", mirror_taxels, nb::arg("ids"), nb::arg("normal"),
           nb::arg("point") = nb::make_tuple(0.0, 0.0, 0.0),
           nb::sig("def mirror_taxels(self, ids: numpy.typing.ArrayLike, normal: numpy.typing.ArrayLike, "
                   "point: numpy.typing.ArrayLike = (0, 0, 0)) -> None"),
           "Adds the mirror images of taxels across the plane through `point` (3,) [m] at right angles to `normal` "
           "(3,). Raises Error.");
}

}  // namespace taxel::python
