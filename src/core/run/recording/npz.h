// Reading and writing of a recording as NumPy arrays.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/archive/npz.h"
#include "core/run/recording/recording.h"

namespace taxel {

/// Returns the bytes of an archive with these arrays, in SI units and the world frame. Quaternions are w x y z; poses
/// are those of the frame of the mesh file. n is the number of rows, m of objects, s of steps.
///
/// - Rows: time, travel (n); step (n, index into the mocap arrays).
/// - Objects: object_names (m); object_pos (n, m, 3), object_quat (n, m, 4).
/// - Each sensor: force (n, 3); area, polygons (n); readings (n, taxels); readings_unit; sensor_pos (n, 3),
///   sensor_quat (n, 4); taxel_ids, taxel_names; layout (JSON text); seed. With a calibration: calibrated (n, taxels),
///   calibrated_unit. If friction sticks: slip (n, taxels). If there are several sensors, these names begin with
///   `<geom>/`.
/// - Steps: mocap_pos (s, 3), mocap_quat (s, 4).
/// - The run: timestep; sensor_geoms; units (JSON text).
std::string recording_to_npz(const Recording& recording);

/// Reads a recording that recording_to_npz() wrote, with the same values bit for bit. `path` is the archive, or a
/// folder with a readings.npz. Throws Error naming file and array if an array is missing or not valid, there are no
/// rows, times or steps do not ascend, a step has no mocap pose, a number is not finite or does not fit, or the length
/// of a quaternion is not 1.
Recording read_recording(const std::filesystem::path& path);
/// Reads a recording whose mocap body has poses to replay. Throws Error also if no mocap body moved in the run.
Recording read_moved_recording(const std::filesystem::path& path);
/// Reads a recording from an open archive.
Recording read_recording(const NpzReader& npz);

/// Returns the path of the archive that read_recording() reads.
std::filesystem::path recording_file(const std::filesystem::path& path);

}  // namespace taxel
