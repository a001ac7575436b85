// A recording as NumPy arrays: an uncompressed zip of .npy files, the same bytes for the same values.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/run/recording/recording.h"
#include "core/run/recording/zip_archive.h"

namespace taxel {

/// Collects arrays, then makes the archive. Format: NPY 1.0, little endian, C order (NumPy enhancement proposal 1);
/// text is UTF-8 in, UCS-4 (`<U`) inside. Members carry a fixed date, so that two archives of the same arrays are
/// equal.
class NpzWriter {
 public:
  using Shape = std::vector<std::size_t>;
  void add(const std::string& name, const Shape& shape, std::span<const double> values);
  void add(const std::string& name, const Shape& shape, std::span<const std::int64_t> values);
  void add(const std::string& name, const std::vector<std::string>& texts);  ///< one dimension
  void add(const std::string& name, const std::string& text);                ///< no dimension
  /// A member that is no array, under its whole name: NumPy gives its bytes.
  void add_file(const std::string& name, std::string bytes) { members_.emplace_back(name, std::move(bytes)); }
  /// The archive's bytes. Throws Error when libzip fails.
  [[nodiscard]] std::string bytes() const;

 private:
  std::vector<std::pair<std::string, std::string>> members_;  ///< file names and bytes
};

/// The arrays of an archive that NpzWriter or NumPy wrote. Each is unpacked when it is asked for, within the limits of
/// ZipArchive. Every reading function throws Error naming file and array if there is no such array, it is of another
/// type, or its bytes differ from their checksum.
class NpzReader {
 public:
  using Shape = NpzWriter::Shape;
  /// Throws Error if the file cannot be read or is not a zip archive.
  explicit NpzReader(const std::filesystem::path& path) : archive_(path) {}
  explicit NpzReader(ZipArchive archive) : archive_(std::move(archive)) {}
  [[nodiscard]] bool has(const std::string& name) const { return archive_.has(name + ".npy"); }
  [[nodiscard]] Shape shape(const std::string& name) const { return at(name).shape; }
  /// `shape` as it must be; a dimension of any size is kAny.
  static constexpr std::size_t kAny = static_cast<std::size_t>(-1);
  [[nodiscard]] std::vector<double> doubles(const std::string& name, const Shape& shape) const;
  [[nodiscard]] std::vector<std::int64_t> integers(const std::string& name, const Shape& shape) const;
  [[nodiscard]] std::vector<std::string> texts(const std::string& name) const;  ///< of no or one dimension, as UTF-8
  [[nodiscard]] std::string text(const std::string& name) const;                ///< one
  [[nodiscard]] const std::string& file() const { return archive_.file(); }

 private:
  struct Array {
    std::string type;  ///< as NPY spells it: "<f8"
    Shape shape;
    std::string data;
    std::size_t count = 1;
  };
  [[nodiscard]] Array at(const std::string& name) const;
  template <class T>
  [[nodiscard]] std::vector<T> numbers(const std::string& name, const std::string& type, const Shape& shape) const;

  ZipArchive archive_;
};

/// A member that is no array, under its whole name; empty where there is none. Throws Error where the archive cannot be
/// read.
std::string read_archive_member(const std::filesystem::path& path, const std::string& name);

/// Arrays over n rows: time, travel (n), step (n, index into the mocap arrays), object_pos (n, m, 3), object_quat (n,
/// m, 4) of the m geoms named in object_names; per sensor force (n, 3), area, polygons (n), readings (n, taxels),
/// readings_unit, sensor_pos (n, 3), sensor_quat (n, 4), taxel_ids, taxel_names, layout (JSON text), seed, and where
/// the layout has a calibration calibrated (n, taxels), calibrated_unit; with several sensors these are named
/// `<geom>/...`. Over all steps s: mocap_pos (s, 3), mocap_quat (s, 4). timestep; sensor_geoms; units (JSON text).
/// Quaternions are w x y z; poses are of the frame of the mesh file; world frame, SI units.
std::string recording_to_npz(const Recording& recording);

/// What recording_to_npz() wrote: the same values, bit for bit. `path`: the archive, or the folder with a readings.npz.
/// Throws Error naming file and array, also if there are no rows, times or steps do not ascend, a step has no mocap
/// pose, a number is not finite, a quaternion is not of length 1, or a number does not fit.
Recording read_recording(const std::filesystem::path& path);
/// The same of an archive that is open.
Recording read_recording(const NpzReader& npz);

/// The archive that read_recording() reads.
std::filesystem::path recording_file(const std::filesystem::path& path);

}  // namespace taxel
