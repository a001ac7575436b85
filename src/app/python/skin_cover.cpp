// Functions for taxel.attach: which geoms of a scene lie within a skin.
#include <fmt/format.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include "app/python/arrays.h"
#include "app/python/handles.h"
#include "app/python/nouns.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"
#include "core/sensor/skin_cover.h"

namespace taxel::python {
namespace {

double share_within(LayoutHandle layout, nb::handle vertices, nb::handle triangles) {
  const std::vector<dvec3> points = read_vectors(vertices, "vertices");
  const std::vector<double> corners = read_numbers(triangles, "triangles", {-1, 3});
  std::vector<ivec3> faces;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k)
      if (!(corners[i + k] >= 0 && corners[i + k] < static_cast<double>(points.size())))
        throw nb::value_error("triangles: must be indices of vertices");
    faces.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
  }
  const nb::gil_scoped_release release;
  const LoadedMesh loaded = load_mesh(with_absolute_mesh(layout).mesh.file, layout.value->mesh.scale);
  return share_within_skin(TriMesh(points, faces), RigidTransform(Pose{}), MeshIndex(loaded.mesh),
                           layout.value->material.thickness);
}

std::pair<Vectors3, Integers3> primitive(const std::string& shape, nb::handle size) {
  const dvec3 s = read_vector(size, "size");
  const auto mesh = std::make_shared<const TriMesh>([&] {
    if (shape == "sphere") return make_drawn_ellipsoid(dvec3(s.x));
    if (shape == "capsule") return make_drawn_capsule(s.x, s.y);
    if (shape == "cylinder") return make_drawn_cylinder(s.x, s.y);
    if (shape == "ellipsoid") return make_drawn_ellipsoid(s);
    if (shape == "box") return make_box(s);
    throw nb::value_error(fmt::format("shape: must be a shape of MuJoCo with three sizes, is \"{}\"", shape).c_str());
  }());
  return {view_of(mesh->vertices(), mesh), view_of(mesh->faces(), mesh)};
}

}  // namespace

void add_skin_cover(nb::module_& m) {
  m.def(
      "share_within_skin", &share_within, nb::arg("layout"), nb::arg("vertices"), nb::arg("triangles"),
      "Share of the area of a surface that lies within the skin of a layout, from 0 to 1. The surface has vertices in "
      "the frame of the layout's mesh file [m], shape (v, 3), and triangles, shape (f, 3). Raises Error.");
  m.def("primitive", &primitive, nb::arg("shape"), nb::arg("size"),
        "Vertices [m] and triangles of MuJoCo's sphere, capsule, cylinder, ellipsoid or box with its three sizes.");
}

}  // namespace taxel::python
