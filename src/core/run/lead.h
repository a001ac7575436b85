// Values over time that lead a scene: controls of actuators and poses of mocap bodies, and the files that they are read
// from (tables of controls and of poses, recorded runs). Free of MuJoCo.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/run/controls.h"

namespace taxel {

/// The control of one actuator over time.
struct ControlTrack {
  int actuator = 0;           ///< index in SceneControls::actuators
  std::vector<double> times;  ///< ascending, from the start of the run [s]
  std::vector<double> values;
};

/// The pose of one mocap body over time.
struct MocapTrack {
  int mocap = 0;              ///< index in SceneControls::mocaps
  std::vector<double> times;  ///< ascending, from the start of the run [s]
  std::vector<dvec3> positions_W;
  std::vector<dquat> rotations_WB;  ///< unit quaternions; empty if the body keeps the orientation of the scene
};

/// Everything that leads a scene. Controls and mocap bodies without a track keep their values. Every track has rows.
struct SceneLead {
  std::vector<ControlTrack> controls;
  std::vector<MocapTrack> mocaps;
  std::vector<std::string> notes;  ///< sentences about the files, for the user
};
using SceneLeadPtr = std::shared_ptr<const SceneLead>;

/// Returns the value of a control at a time, linear between two rows. Before the first row it is the first value, after
/// the last row the last one.
double control_at(const ControlTrack& track, double time);

/// Returns the position of a mocap body at a time, linear between two rows, as control_at() does.
dvec3 position_at(const MocapTrack& track, double time);

/// Returns the orientation of a mocap body at a time. Between two rows it turns about one axis at an even speed, the
/// shorter way (slerp; Shoemake, SIGGRAPH 1985). At the time of a row it is that of the row, bit for bit. The track
/// must have orientations.
dquat rotation_at(const MocapTrack& track, double time);

/// Returns the time of the last row of all tracks [s]; 0 without tracks.
double end_of(const SceneLead& lead);

/// Returns the number of steps until the last row is reached and evaluated.
long steps_of(const SceneLead& lead, double timestep);

/// Files that lead a scene. Empty paths are not read.
struct LeadFiles {
  std::string controls;  ///< table of controls
  std::string mocaps;    ///< table of poses of mocap bodies
  std::string run;       ///< folder of a recorded run, or its readings.npz
  [[nodiscard]] bool is_empty() const { return controls.empty() && mocaps.empty() && run.empty(); }
};

/// The start of a scene, and the files that lead it.
struct LeadRequest {
  std::string keyframe;  ///< name or number of the start's keyframe; the initial state if empty
  LeadFiles files;
  [[nodiscard]] bool is_empty() const { return keyframe.empty() && files.is_empty(); }
};

/// Adds a table of controls: a column of times [s], and a column for each led actuator, by its name. A value is in the
/// unit of the actuator; a unit in the head of a column is converted to SI ("wrist [deg]"). Files have the encodings,
/// separators, decimal marks and forms of times of parse_real_recording(). Throws Error naming file, line and column
/// for a table without a header, times or rows, a time that does not ascend, a value that is missing or not a number,
/// and a column that names no actuator. Adds a note if the range of an actuator limits values.
void add_controls(SceneLead& lead, const std::string& text, const SceneControls& scene, const std::string& file);

/// Adds a table of poses in the world: a column of times [s]; for each led mocap body the columns BODY_x, BODY_y and
/// BODY_z [m], and, if its orientation is led, BODY_qw, BODY_qx, BODY_qy and BODY_qz. A scene with one mocap body may
/// have x, y, z, qw, qx, qy, qz. Quaternions are normalised. Throws Error as add_controls() does, and for a column that
/// is missing, a unit that is no length, and a quaternion whose length differs from 1 by more than 1 %.
void add_mocaps(SceneLead& lead, const std::string& text, const SceneControls& scene, const std::string& file);

/// Adds the poses of the first mocap body in a recorded run, one for each step. Throws Error if the run is not
/// readable or has no poses, or if the scene has no mocap body.
void add_run(SceneLead& lead, const std::filesystem::path& run, const SceneControls& scene);

/// Reads all files. Throws the errors of the functions above, and Error if a file is not readable.
SceneLeadPtr read_lead(const LeadFiles& files, const SceneControls& scene);

/// Returns the names in quotes, for a message.
std::string quoted_list(const std::vector<std::string>& names);
/// Returns the end of a message: the question whether one of the names was meant, or nothing if none is near.
std::string meant_name(const std::string& word, const std::vector<std::string>& names);

/// Returns the index of the keyframe with this name or, if no keyframe has the name, with this number. Throws Error
/// that names `file` and lists the keyframes.
int keyframe_named(const std::string& name, const SceneControls& scene, const std::string& file);

}  // namespace taxel
