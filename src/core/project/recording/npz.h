// A recording as NumPy arrays: an uncompressed zip of .npy files, the same bytes for the same values.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/project/recording/recording.h"

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
  /// The archive's bytes. Throws Error when libzip fails.
  [[nodiscard]] std::string bytes() const;

 private:
  std::vector<std::pair<std::string, std::string>> members_;  ///< name, bytes of the .npy
};

/// Arrays over n rows: time, travel (n), step (n, index into the mocap arrays), object_pos (n, m, 3), object_quat (n,
/// m, 4) of the m geoms named in object_names; per sensor force (n, 3), area, polygons (n), readings (n, taxels),
/// sensor_pos (n, 3), sensor_quat (n, 4), taxel_ids, taxel_names, layout (JSON text), seed, and where the layout has a
/// calibration calibrated (n, taxels), calibrated_unit; with several sensors these are named `<geom>/...`. Over all
/// steps s: mocap_pos (s, 3), mocap_quat (s, 4). timestep; sensor_geoms; units (JSON text). Quaternions are w x y z;
/// poses are of the frame of the mesh file; world frame, SI units.
std::string recording_to_npz(const Recording& recording);

}  // namespace taxel
