// A recording as an MCAP file of ROS 2 messages (profile "ros2"), for Foxglove, PlotJuggler and other readers.
#pragma once

#include <filesystem>
#include <string>

#include "core/run/recording/recording.h"

namespace taxel {

/// Facts about a run that its recording does not hold. Each may be empty. For a recording that was written earlier they
/// come from the file about the run next to it.
struct RunNotes {
  std::string program;    ///< versions of the program and of MuJoCo
  std::string file_name;  ///< name of a JSON file about the run, such as "scenario.json"
  std::string file_text;  ///< text of this file
};

/// Returns the bytes of a file with these messages for each row. SENSOR is the sensor's geom, in a form that ROS
/// accepts (RosNames), and also the name of the frame of its mesh. Numbers are the recording's, bit for bit; only the
/// times of the messages are rounded to nanoseconds. Equal recordings and notes give equal bytes.
///
/// - /taxel/SENSOR/readings: taxel_msgs/TactileReadings. Also readings_error, with error bars, calibrated, with
///   a calibration, shear_e1 and shear_e2, with shear, and slip, if friction sticks. Left out for a soft geom without
///   taxels.
/// - /taxel/SENSOR/force, in N, and uncovered_force if the readings are forces: geometry_msgs/Vector3Stamped, frame
///   "world".
/// - /taxel/SENSOR/contact: taxel_msgs/TactileContact.
/// - /taxel/SENSOR/pose: geometry_msgs/PoseStamped of the frame of the mesh file, frame "world".
/// - /tf: tf2_msgs/TFMessage of all sensors and objects, and of the mocap body as "mocap" if the run moves one.
///
/// The metadata of each channel name the unit of each field. The metadata records "taxel" and "taxel/SENSOR" have
/// versions, the time step, and the meaning of each sensor. The layouts are attachments SENSOR.taxels.json; the file of
/// the notes is another attachment.
///
/// Throws Error if a time does not fit into a message, or if the file would have too many channels.
std::string recording_to_mcap(const Recording& recording, const RunNotes& notes);

/// Writes the bytes of recording_to_mcap() to a file, completely or not at all. Throws Error naming the file.
void write_mcap(const std::filesystem::path& path, const Recording& recording, const RunNotes& notes);

/// Returns the notes from the text of a file about a run: its name, its text, and the versions of the program and of
/// MuJoCo in it ("versions": {"taxel": "0.1.0", "mujoco": "4.0.1"}). Throws Error(file, JSON pointer, ...) if the text
/// is not such a file.
RunNotes parse_run_notes(const std::string& text, const std::string& name, const std::string& file);

/// Returns the notes of the run in a folder: from scenario.json or sweep.json, the newer one if there are both. They
/// are empty if there is neither. Throws Error naming the file.
RunNotes read_run_notes(const std::filesystem::path& folder);

}  // namespace taxel
