// SensorModel: a compiled layout with its mesh, samples and receptive fields.
#include <fmt/format.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "app/python/arrays.h"
#include "app/python/handles.h"
#include "app/python/interruptible.h"
#include "app/python/nouns.h"
#include "core/layout/words.h"
#include "core/sensor/readout/reading.h"
#include "core/sensor/sensor_model.h"

namespace taxel::python {

SensorModelPtr build_interruptibly(LayoutHandle layout, SampleQuality quality) {
  Progress progress;
  SensorBuild how(&progress);
  how.quality = quality;
  return run_interruptibly(progress, [&] {
    const LoadedMesh loaded = load_mesh(with_absolute_mesh(layout).mesh.file, layout.value->mesh.scale, &progress);
    return build_sensor_model(*layout.value, loaded.mesh, loaded.sha256, layout.file, how);
  });
}

namespace {

SampleQuality parse_quality(const std::string& word) {
  if (word == "polished") return SampleQuality::polished;
  if (word == "preview") return SampleQuality::preview;
  throw nb::value_error(fmt::format("quality: must be \"polished\" or \"preview\", is \"{}\"", word).c_str());
}

void build_in_place(SensorModelHandle* place, LayoutHandle layout, const std::string& quality) {
  SensorModelPtr model = build_interruptibly(layout, parse_quality(quality));
  new (place) SensorModelHandle{std::move(model), std::move(layout.file)};
}

/// Returns a view of one member of all samples.
template <class Array, std::size_t N>
Array sample_column(const SensorModelPtr& model, const double* first, const std::size_t (&shape)[N]) {
  return strided_view<Array>(first, model->samples.size(), sizeof(SurfaceSample), shape, model);
}

using Entry = ReceptiveFields::Entry;

void add_samples(nb::class_<SensorModelHandle>& type) {
  type.def_prop_ro(
          "sample_positions",
          [](const SensorModelHandle& h) {
            const auto& samples = h.model->samples;
            return sample_column<Vectors3>(h.model, samples.empty() ? nullptr : &samples[0].position.x,
                                           {samples.size(), 3});
          },
          nb::rv_policy::automatic, "Samples on the skin [m], frame of the mesh file, shape (s, 3).")
      .def_prop_ro(
          "sample_normals",
          [](const SensorModelHandle& h) {
            const auto& samples = h.model->samples;
            return sample_column<Vectors3>(h.model, samples.empty() ? nullptr : &samples[0].normal.x,
                                           {samples.size(), 3});
          },
          nb::rv_policy::automatic, "Unit normals of the samples, shape (s, 3).")
      .def_prop_ro(
          "sample_areas",
          [](const SensorModelHandle& h) {
            const auto& samples = h.model->samples;
            return sample_column<Vector>(h.model, samples.empty() ? nullptr : &samples[0].area, {samples.size()});
          },
          nb::rv_policy::automatic, "Area that each sample represents [m^2], shape (s,).");
}

void add_fields(nb::class_<SensorModelHandle>& type) {
  type.def_prop_ro(
          "field_offsets", [](const SensorModelHandle& h) { return view_of(h.model->fields.first, h.model); },
          nb::rv_policy::automatic,
          "Receptive field of taxel k: entries field_offsets[k] to field_offsets[k + 1] of the arrays below, shape "
          "(n + 1,).")
      .def_prop_ro(
          "field_samples",
          [](const SensorModelHandle& h) {
            const auto& entries = h.model->fields.entries;
            return strided_view<Integers>(entries.empty() ? nullptr : &entries[0].sample, entries.size(), sizeof(Entry),
                                          {entries.size()}, h.model);
          },
          nb::rv_policy::automatic, "Index of the sample of each entry, shape (e,).")
      .def_prop_ro(
          "field_weights",
          [](const SensorModelHandle& h) {
            const auto& entries = h.model->fields.entries;
            return strided_view<Vector>(entries.empty() ? nullptr : &entries[0].weight, entries.size(), sizeof(Entry),
                                        {entries.size()}, h.model);
          },
          nb::rv_policy::automatic, "Weight of each entry [m^2], shape (e,).")
      .def_prop_ro(
          "field_distances",
          [](const SensorModelHandle& h) {
            const auto& entries = h.model->fields.entries;
            return strided_view<Vector>(entries.empty() ? nullptr : &entries[0].distance, entries.size(), sizeof(Entry),
                                        {entries.size()}, h.model);
          },
          nb::rv_policy::automatic, "Distance of each entry's sample from the centre of the taxel [m], shape (e,).");
}

}  // namespace

void add_sensor_model(nb::module_& m) {
  nb::class_<SensorModelHandle> type(m, "SensorModel",
                                     "A layout compiled for reading: mesh, samples, receptive fields and pressure "
                                     "field. Immutable; arrays are read-only views. Building takes about a second, "
                                     "without Python's lock, and Ctrl+C ends it.");
  type.def("__init__", build_in_place, nb::arg("layout"), nb::arg("quality") = "polished",
           "Compiles a layout. `quality` is \"polished\", or \"preview\" for samples in a tenth of the time. Raises "
           "Error for the first broken rule.");
  add_samples(type);
  add_fields(type);
  type.def_prop_ro(
          "layout",
          [](const SensorModelHandle& h) {
            return LayoutHandle{std::shared_ptr<const Layout>(h.model, &h.model->layout), h.file};
          },
          "The layout of the model.")
      .def_prop_ro(
          "vertices", [](const SensorModelHandle& h) { return view_of(h.model->mesh->vertices(), h.model); },
          nb::rv_policy::automatic, "Vertices of the repaired mesh [m], shape (v, 3).")
      .def_prop_ro(
          "faces", [](const SensorModelHandle& h) { return view_of(h.model->mesh->faces(), h.model); },
          nb::rv_policy::automatic, "Vertices of each face, counter-clockwise from outside, shape (f, 3).")
      .def_prop_ro(
          "sampled_area", [](const SensorModelHandle& h) { return h.model->sampled_area; }, "Sampled area [m^2].")
      .def_prop_ro(
          "unit", [](const SensorModelHandle& h) { return reading_unit(h.model->layout.readout.aggregate); },
          "Unit of the readings: Pa, Pa m^2 or N.")
      .def_prop_ro(
          "problems", [](const SensorModelHandle& h) { return h.model->problems; }, "Warnings and notes.")
      .def("__len__", [](const SensorModelHandle& h) { return h.model->taxel_count(); })
      .def("__repr__", [](const SensorModelHandle& h) {
        return fmt::format("<SensorModel \"{}\": {} taxels, {} samples>", h.model->layout.name, h.model->taxel_count(),
                           h.model->samples.size());
      });
}

}  // namespace taxel::python
