// Reads the files that lead a scene: tables of controls and of poses, and recorded runs.
#pragma once

#include <filesystem>
#include <string>

#include "core/run/controls.h"
#include "core/run/lead/scene_lead.h"

namespace taxel {

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

/// Returns the index of the keyframe with this name or, if no keyframe has the name, with this number. Throws Error
/// that names `file` and lists the keyframes.
int keyframe_named(const std::string& name, const SceneControls& scene, const std::string& file);

}  // namespace taxel
