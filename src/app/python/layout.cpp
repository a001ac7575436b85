// Layout: a taxel layout with its arrays, files, checks and edits.

#include <fmt/format.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <charconv>
#include <string>
#include <string_view>
#include <vector>

#include "app/python/arrays.h"
#include "app/python/handles.h"
#include "app/python/nouns.h"
#include "core/document/edit.h"
#include "core/document/project.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/formats/layout_format.h"
#include "core/layout/generators/mirror.h"
#include "core/layout/words.h"
#include "core/sensor/layout_source.h"

namespace taxel::python {
namespace {

// All functions throw Error for a broken rule, and TypeError or ValueError for an array of another kind or shape.

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

LayoutHandle mirrored(const LayoutHandle& layout, const std::string& axis) {
  if (axis != "x" && axis != "y" && axis != "z")
    throw Error("", "axis", fmt::format("must be \"x\", \"y\" or \"z\", is \"{}\"", axis));
  return {std::make_shared<const Layout>(mirrored_layout(*layout.value, axis[0] - 'x')), layout.file};
}

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

/// Adds the methods that edit taxels.
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
           "(3,). Raises Error.")
      .def(
          "mirrored", mirrored, nb::arg("axis") = "x", nb::sig("def mirrored(self, axis: str = \"x\") -> Layout"),
          "Returns the layout of the mirrored mesh, such as that of the other hand: taxels, frame and the scale of the "
          "mesh change their sign along `axis` (\"x\", \"y\" or \"z\"); ids and order stay. Raises Error.");
}

}  // namespace

Layout with_absolute_mesh(const LayoutHandle& layout) {
  Layout copy = *layout.value;
  copy.mesh.file = std::filesystem::absolute(mesh_path(copy, layout.file)).lexically_normal().string();
  return copy;
}

namespace {

/// A Layout from Python and the notes on its import.
LayoutHandle read_handle(const std::filesystem::path& file, const std::string& mesh, const std::string& sensor) {
  const nb::gil_scoped_release release;
  SkinChoice choice;
  choice.mesh = mesh;
  choice.sensor = sensor;
  if (is_own_layout(file) && mesh.empty() && sensor.empty())
    return {std::make_shared<const Layout>(read_layout(file)), file.string()};
  ImportedSource read = read_any_source(file, choice);
  LayoutHandle handle{std::make_shared<const Layout>(std::move(read.source.layout)), file.string()};
  handle.value = std::make_shared<const Layout>(with_absolute_mesh(handle));
  return handle;
}

LayoutHandle parse_handle(const std::string& text, const std::filesystem::path& file) {
  return {std::make_shared<const Layout>(parse_layout(text, file.string())), file.string()};
}

std::vector<std::string> write_handle(LayoutHandle& layout, const std::filesystem::path& file) {
  const LayoutFormat* format = layout_format_of(file);
  if (format == nullptr || format->write == nullptr)
    throw Error(file.string(), "no layout is written with this extension; use .taxels.json");
  // A relative mesh stays relative in the folder of the layout's own file.
  const bool is_same_folder = layout.file.empty() || std::filesystem::absolute(file).parent_path() ==
                                                         std::filesystem::absolute(layout.file).parent_path();
  return write_layout_as(*format, file, is_same_folder ? *layout.value : with_absolute_mesh(layout));
}

/// `layout` is a copy, which edits of the Python object by other threads do not change.
Problems check_handle(LayoutHandle layout, bool with_mesh) {
  const nb::gil_scoped_release release;
  return with_mesh ? check_layout_file(*layout.value, layout.file) : check_layout_values(*layout.value, layout.file);
}

/// Returns a view of one member of all taxels.
template <class Array, class Member>
Array column(const LayoutHandle& layout, Member Taxel::*member) {
  using Number = typename Array::Scalar;
  const std::vector<Taxel>& taxels = layout.value->taxels;
  const auto* first = taxels.empty() ? nullptr : reinterpret_cast<const std::byte*>(&(taxels.front().*member));
  const auto* numbers = reinterpret_cast<const std::remove_const_t<Number>*>(first);
  if constexpr (std::is_same_v<Member, dvec3>)
    return strided_view<Array>(numbers, taxels.size(), sizeof(Taxel), {taxels.size(), 3}, layout.value);
  else
    return strided_view<Array>(numbers, taxels.size(), sizeof(Taxel), {taxels.size()}, layout.value);
}

std::vector<std::string> names_of(const LayoutHandle& layout) {
  std::vector<std::string> names;
  for (const Taxel& taxel : layout.value->taxels) names.push_back(taxel.name);
  return names;
}

/// Returns the text of the JSON of a Python value.
std::string json_of(nb::handle value) {
  return nb::cast<std::string>(nb::module_::import_("taxel.json_text").attr("dump")(value));
}

void add_files(nb::class_<LayoutHandle>& type) {
  type.def_static("read", read_handle, nb::arg("file"), nb::kw_only(), nb::arg("mesh") = "", nb::arg("sensor") = "",
                  "Reads a layout of any format. `mesh` is the mesh file of a format without one, `sensor` the name of "
                  "one of several sensors in the file. Raises Error.")
      .def_static(
          "parse", parse_handle, nb::arg("text"), nb::arg("file") = "",
          "Parses the JSON text of a layout. The folder of `file` is that of a relative mesh file. Raises Error.")
      .def("write", write_handle, nb::arg("file"),
           "Writes the layout in the format of the file's extension. Returns one sentence for each value that the "
           "format cannot hold. Raises Error.")
      .def(
          "to_json", [](const LayoutHandle& l) { return layout_to_json(*l.value); },
          "Returns the text of the layout's file.")
      .def(
          "absolute",
          [](const LayoutHandle& l) {
            return LayoutHandle{std::make_shared<const Layout>(with_absolute_mesh(l)), l.file};
          },
          "Returns a copy whose mesh file has an absolute path.")
      .def(
          "copy", [](const LayoutHandle& l) { return l; }, "Returns an independent copy.")
      .def("check", check_handle, nb::arg("mesh") = true,
           "Returns all broken rules. With `mesh`, the mesh is loaded and the sensor compiled, too, which takes a "
           "second.");
}

void add_values(nb::class_<LayoutHandle>& type) {
  type.def(
          "value",
          [](const LayoutHandle& l, const std::string& pointer) {
            return nb::module_::import_("json").attr("loads")(value_of(l, pointer));
          },
          nb::arg("pointer"), nb::sig("def value(self, pointer: str) -> typing.Any"),
          "Returns one value of the layout's file by its JSON pointer, such as /material/modulus [Pa]. Raises Error.")
      .def(
          "set_value",
          [](LayoutHandle& l, const std::string& pointer, nb::handle value) {
            l.value = std::make_shared<const Layout>(with_value(l, pointer, json_of(value)));
          },
          nb::arg("pointer"), nb::arg("value"), nb::sig("def set_value(self, pointer: str, value: typing.Any) -> None"),
          "Sets one value by its JSON pointer, in the unit of the file (docs/layout_format.md). Raises Error.");
}

void add_columns(nb::class_<LayoutHandle>& type) {
  type.def_prop_ro(
          "ids", [](const LayoutHandle& l) { return column<Integers>(l, &Taxel::id); }, nb::rv_policy::automatic,
          "Ids of the taxels in the order of the readings, shape (n,).")
      .def_prop_rw("names", names_of, set_names, "Names of the taxels.")
      .def_prop_rw(
          "centers", [](const LayoutHandle& l) { return column<Vectors3>(l, &Taxel::center); }, set_centers,
          nb::for_setter(nb::sig("def centers(self, value: numpy.typing.ArrayLike, /) -> None")),
          nb::rv_policy::automatic,
          "Centres of the taxels [m] in the frame of the mesh file, shape (n, 3). A read-only view of this state of "
          "the layout; assign to change all.")
      .def_prop_rw(
          "normals", [](const LayoutHandle& l) { return column<Vectors3>(l, &Taxel::normal); }, set_normals,
          nb::for_setter(nb::sig("def normals(self, value: numpy.typing.ArrayLike, /) -> None")),
          nb::rv_policy::automatic, "Outward normals of any length, shape (n, 3). A view like `centers`.")
      .def_prop_rw(
          "radii", [](const LayoutHandle& l) { return column<Vector>(l, &Taxel::radius); }, set_radii,
          nb::for_setter(nb::sig("def radii(self, value: numpy.typing.ArrayLike, /) -> None")),
          nb::rv_policy::automatic,
          "Radii of the receptive fields [m], shape (n,). A view like `centers`; one number sets all.");
}

}  // namespace

void add_layout(nb::module_& m) {
  nb::class_<LayoutHandle> type(
      m, "Layout",
      "Taxels on a mesh, with sampling, readout and material: a `*.taxels.json` file.\n\n"
      "Lengths in metres in the frame of the mesh file. Edits check the rules of the file and "
      "raise Error without changing the layout. Arrays are read-only views of the state in "
      "which they were taken.");
  add_files(type);
  add_values(type);
  add_columns(type);
  add_edits(type);
  type.def_prop_ro(
          "file", [](const LayoutHandle& l) { return path_text(l.file); }, "File of the layout, or an empty text.")
      .def_prop_rw(
          "name", [](const LayoutHandle& l) { return l.value->name; }, set_name, "Name of the sensor.")
      .def_prop_ro(
          "mesh_file", [](const LayoutHandle& l) { return path_text(mesh_path(*l.value, l.file).string()); },
          "Path of the mesh file.")
      .def_prop_ro(
          "unit", [](const LayoutHandle& l) { return reading_unit(l.value->readout.aggregate); },
          "Unit of the readings: Pa, Pa m^2 or N.")
      .def("__len__", [](const LayoutHandle& l) { return l.value->taxels.size(); })
      .def("__eq__", [](const LayoutHandle& a, const LayoutHandle& b) { return *a.value == *b.value; })
      .def("__eq__", [](const LayoutHandle&, nb::handle) { return false; })
      .def("__copy__", [](const LayoutHandle& l) { return l; })
      .def("__deepcopy__", [](const LayoutHandle& l, nb::handle) { return l; })
      .def("__getstate__",
           [](const LayoutHandle& l) { return std::pair(layout_to_json(with_absolute_mesh(l)), l.file); })
      .def("__setstate__",
           [](LayoutHandle& l, const std::pair<std::string, std::string>& state) {
             new (&l) LayoutHandle(parse_handle(state.first, state.second));
           })
      .def("__repr__", [](const LayoutHandle& l) {
        return fmt::format("<Layout \"{}\": {} taxels on {}>", l.value->name, l.value->taxels.size(),
                           l.value->mesh.file);
      });
}

}  // namespace taxel::python
