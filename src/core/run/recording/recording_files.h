// A recording as the text or the bytes of files: tables, an archive of NumPy arrays, and TactileState messages.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/archive/npz.h"
#include "core/run/recording/recording.h"

namespace taxel {

/// Returns a table `time,travel,force_x,force_y,force_z,area,polygons,taxel_<id>...` in SI units: one header line and
/// one line for each row. With error bars, columns `taxel_<id>_error...` follow, in the unit of the readings. Every
/// number is in the shortest form that reads back exactly. If there are several sensors, the names of all columns
/// except time and travel begin with `<geom>/`, sensor after sensor.
std::string recording_to_csv(const Recording& recording);

/// Returns a table `time,travel,taxel_<id>...` of the calibrated values of the sensors that have a calibration; empty
/// if no sensor has one.
std::string calibrated_to_csv(const Recording& recording);

/// Returns a table `time,travel,taxel_<id>_e1,taxel_<id>_e2...` of the sensors whose layouts have shear readings, in
/// the unit of their readings; empty if no layout has them.
std::string shear_to_csv(const Recording& recording);

/// Returns a table `time,travel,taxel_<id>...` of the share of each taxel's field that slips, from 0 to 1, of the
/// sensors whose friction sticks; empty if there are none.
std::string slip_to_csv(const Recording& recording);

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

/// Returns ROS messages, without ROS, as JSON Lines, one message for each row. The fields are those of
/// tactile_msgs/TactileState (github.com/ubi-agni/tactile_toolbox: std_msgs/Header header, sensor_msgs/ChannelFloat32[]
/// sensors):
/// {"header": {"seq": 0, "stamp": {"secs": 1, "nsecs": 250000000}, "frame_id": "world"},
///  "sensors": [{"name": "finger", "values": [...]}]}
/// Each sensor is a channel, named by its geom. Its values are in the order of its taxels: calibrated values if its
/// layout has a calibration, otherwise readings, rounded to the single precision of the message. `seq` counts rows.
/// Throws Error if a time is negative or too large for a stamp, or if a value is not finite.
std::string tactile_states(const Recording& recording);

}  // namespace taxel
