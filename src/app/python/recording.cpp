// Recording: the rows of a run as arrays.
#include <fmt/format.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <memory>

#include "app/python/arrays.h"
#include "app/python/handles.h"
#include "app/python/nouns.h"
#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/run/recording/npz_arrays.h"
#include "core/run/recording/recording.h"
#include "core/run/recording/recording_files.h"

namespace taxel::python {
namespace {

using RecordingPtr = std::shared_ptr<const Recording>;

/// The Python object of a run.
struct RecordingHandle {
  RecordingPtr recording;
  std::string file;         ///< path of readings.npz
  std::string layout_file;  ///< file whose folder is that of relative mesh files
};

/// The Python object of one sensor of a run.
struct SensorHandle {
  RecordingPtr recording;
  std::size_t sensor = 0;
  std::string layout_file;

  [[nodiscard]] const RecordedSensor& description() const { return recording->sensors[sensor]; }
};

/// Returns the numbers that `append_row(numbers, row)` appends for each row.
template <class Row>
std::vector<double> gather(const Recording& recording, const Row& append_row) {
  std::vector<double> numbers;
  for (const RecordedRow& row : recording.rows) append_row(numbers, row);
  return numbers;
}
template <class Row>
std::vector<double> gather(const SensorHandle& s, const Row& append_record) {
  return gather(*s.recording, [&](std::vector<double>& numbers, const RecordedRow& row) {
    append_record(numbers, row.sensors[s.sensor]);
  });
}

Matrix taxel_matrix(const SensorHandle& s, std::vector<double> SensorRecord::*values) {
  return array_of<Matrix>(gather(s,
                                 [values](std::vector<double>& numbers, const SensorRecord& r) {
                                   numbers.insert(numbers.end(), (r.*values).begin(), (r.*values).end());
                                 }),
                          s.description().taxel_ids.size());
}

RecordingHandle read_handle_of_run(const std::filesystem::path& path, const std::filesystem::path& layout_file) {
  const nb::gil_scoped_release release;
  const std::string file = recording_file(path).string();
  return {std::make_shared<const Recording>(read_recording(path)), file,
          layout_file.empty() ? file : layout_file.string()};
}

/// Returns the file of a folder that has these bytes; empty if there is none.
std::filesystem::path find_mesh(const std::filesystem::path& folder, const std::string& sha256) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (!entry.is_regular_file(error) || !is_mesh_file(entry.path())) continue;
    if (sha256_hex(read_file(entry.path())) == sha256) return entry.path();
  }
  return {};
}

/// Returns the layout of a sensor. A run keeps its meshes in its own folder, under other names than the layout's.
LayoutHandle layout_of(const SensorHandle& s) {
  Layout layout = parse_layout(s.description().layout_json, s.layout_file);
  std::error_code error;
  if (std::filesystem::exists(mesh_path(layout, s.layout_file), error))
    return {std::make_shared<const Layout>(std::move(layout)), s.layout_file};
  const std::filesystem::path mesh =
      find_mesh(std::filesystem::absolute(s.layout_file).parent_path(), layout.mesh.sha256);
  if (!mesh.empty()) layout.mesh.file = mesh.filename().string();
  return {std::make_shared<const Layout>(std::move(layout)), s.layout_file};
}

std::vector<SensorHandle> sensors_of(const RecordingHandle& r) {
  std::vector<SensorHandle> sensors;
  for (std::size_t i = 0; i < r.recording->sensors.size(); ++i) sensors.push_back({r.recording, i, r.layout_file});
  return sensors;
}

void add_sensor_columns(nb::class_<SensorHandle>& type) {
  type.def_prop_ro(
          "readings", [](const SensorHandle& s) { return taxel_matrix(s, &SensorRecord::readings); },
          nb::rv_policy::automatic, "Readings in `unit`, shape (rows, taxels).")
      .def_prop_ro(
          "calibrated",
          [](const SensorHandle& s) -> std::optional<Matrix> {
            if (!s.description().calibrated_unit) return std::nullopt;
            return taxel_matrix(s, &SensorRecord::calibrated);
          },
          nb::rv_policy::automatic,
          nb::for_getter(nb::sig("def calibrated(self, /) -> numpy.typing.NDArray[numpy.float64] | typing.Any")),
          "Calibrated values in `calibrated_unit`, shape (rows, taxels); None without a calibration.")
      .def_prop_ro(
          "force",
          [](const SensorHandle& s) {
            return array_of<Vectors3>(
                gather(s, [](std::vector<double>& numbers, const SensorRecord& r) { append(numbers, r.force_W); }), 3);
          },
          nb::rv_policy::automatic, "Contact force on the sensor [N], world frame, shape (rows, 3).")
      .def_prop_ro(
          "elastic_force",
          [](const SensorHandle& s) -> std::optional<Vectors3> {
            const std::vector<double> numbers = gather(s, [](std::vector<double>& all, const SensorRecord& r) {
              if (r.elastic_force_W) append(all, *r.elastic_force_W);
            });
            if (numbers.size() != 3 * s.recording->rows.size()) return std::nullopt;
            return array_of<Vectors3>(numbers, 3);
          },
          nb::rv_policy::automatic,
          nb::for_getter(nb::sig("def elastic_force(self, /) -> numpy.typing.NDArray[numpy.float64] | typing.Any")),
          "Force of the elastic pressure alone [N], without damping and friction, world frame, shape (rows, 3); None "
          "in recordings of older versions.")
      .def_prop_ro(
          "area",
          [](const SensorHandle& s) {
            return array_of(
                gather(s, [](std::vector<double>& numbers, const SensorRecord& r) { numbers.push_back(r.area); }));
          },
          nb::rv_policy::automatic, "Area of the contact surfaces [m^2], shape (rows,).")
      .def_prop_ro(
          "pos",
          [](const SensorHandle& s) {
            return array_of<Vectors3>(
                gather(s, [](std::vector<double>& numbers, const SensorRecord& r) { append(numbers, r.X_WM.p); }), 3);
          },
          nb::rv_policy::automatic, "Position of the mesh file's frame [m], shape (rows, 3).")
      .def_prop_ro(
          "quat",
          [](const SensorHandle& s) {
            return array_of<Vectors4>(
                gather(s, [](std::vector<double>& numbers, const SensorRecord& r) { append(numbers, r.X_WM.q); }), 4);
          },
          nb::rv_policy::automatic, "Orientation of the mesh file's frame, w x y z, shape (rows, 4).");
}

void add_sensor(nb::module_& m) {
  nb::class_<SensorHandle> type(m, "SensorRecording", "One sensor of a run. Each access makes a new array.");
  add_sensor_columns(type);
  type.def_prop_ro(
          "geom", [](const SensorHandle& s) { return s.description().geom; }, "Name of the sensor's geom.")
      .def_prop_ro(
          "ids", [](const SensorHandle& s) { return array_of(s.description().taxel_ids); }, nb::rv_policy::automatic,
          "Ids of the taxels in the order of the readings, shape (taxels,).")
      .def_prop_ro(
          "names", [](const SensorHandle& s) { return s.description().taxel_names; }, "Names of the taxels.")
      .def_prop_ro(
          "unit", [](const SensorHandle& s) { return s.description().reading_unit; }, "Unit of the readings.")
      .def_prop_ro(
          "calibrated_unit", [](const SensorHandle& s) { return s.description().calibrated_unit; },
          "Unit of the calibrated values, or None.")
      .def_prop_ro("layout", layout_of, "The layout of the sensor, with the mesh in the folder of the run.")
      .def("__repr__", [](const SensorHandle& s) {
        return fmt::format("<SensorRecording \"{}\": {} taxels, {}>", s.description().geom,
                           s.description().taxel_ids.size(), s.description().reading_unit);
      });
}

}  // namespace

void add_recording(nb::module_& m) {
  add_sensor(m);
  nb::class_<RecordingHandle>(m, "Recording", "A run, read from its readings.npz. Each access makes a new array.")
      .def_static("read", read_handle_of_run, nb::arg("path"), nb::kw_only(), nb::arg("layout_file") = "",
                  "Reads a folder that `taxel sweep`, `play` or `run` wrote, or its readings.npz. `layout_file` is the "
                  "file in whose folder layouts have their meshes, instead of the folder of the run. Raises Error.")
      .def_prop_ro("sensors", sensors_of, "The sensors of the run.")
      .def_prop_ro(
          "time",
          [](const RecordingHandle& r) {
            return array_of(gather(*r.recording, [](auto& numbers, const auto& row) { numbers.push_back(row.time); }));
          },
          nb::rv_policy::automatic, "Time of each row [s], shape (rows,).")
      .def_prop_ro(
          "travel",
          [](const RecordingHandle& r) {
            return array_of(
                gather(*r.recording, [](auto& numbers, const auto& row) { numbers.push_back(row.travel); }));
          },
          nb::rv_policy::automatic, "Distance that the mocap body has moved [m], shape (rows,).")
      .def_prop_ro(
          "timestep", [](const RecordingHandle& r) { return r.recording->timestep; }, "Time step [s].")
      .def_prop_ro(
          "file", [](const RecordingHandle& r) { return path_text(r.file); }, "Path of readings.npz when it was read.")
      .def("__len__", [](const RecordingHandle& r) { return r.recording->rows.size(); })
      .def("__repr__", [](const RecordingHandle& r) {
        return fmt::format("<Recording: {} rows, {} sensors>", r.recording->rows.size(), r.recording->sensors.size());
      });
}

}  // namespace taxel::python
