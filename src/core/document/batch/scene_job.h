// A job that runs a user's own scene: its file, the sensors that are attached to it, its start, and the values that
// lead it. Plain values, free of MuJoCo.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// A layout on a geom or a body of the scene, as `taxel run --layout` attaches it.
struct JobAttachment {
  std::string layout;  ///< layout file
  std::string geom;    ///< name of the geom; empty for a body, or for the geom that the layout names
  std::string body;    ///< body whose only mesh gets the layout, instead of `geom`
  std::string others;  ///< names of the touched geoms, separated by spaces; empty for all
  bool keeps_sisters = false;
  bool operator==(const JobAttachment&) const = default;
};

/// The displacement of a body with a free joint, or of a mocap body, from the start of the scene.
struct BodyMove {
  std::string body;
  dvec3 shift_W{0};     ///< [m]
  dvec3 turn_W_deg{0};  ///< turns about the axes of the world through the body's origin, x first [degrees]
  bool operator==(const BodyMove&) const = default;
};

/// Another shape of a geom. Values that are not set stay those of the scene.
struct GeomChange {
  std::string geom;
  std::string type;          ///< sphere, capsule, ellipsoid, cylinder or box; empty to keep the type
  std::vector<double> size;  ///< numbers as in MJCF; empty to keep the size
  std::optional<double> mass, friction;
  bool operator==(const GeomChange&) const = default;
};

/// A table of controls within the job: values over time for each led actuator.
struct ControlTable {
  std::vector<double> times;  ///< ascending [s]
  std::map<std::string, std::vector<double>> values;
  bool operator==(const ControlTable&) const = default;
};

/// One run of a scene. Files have absolute paths.
struct SceneJob {
  std::string file;
  std::vector<JobAttachment> attach;
  std::string keyframe;           ///< name or number of the start's keyframe; the initial state if empty
  std::vector<BodyMove> moves;    ///< one for each moved body
  std::vector<GeomChange> geoms;  ///< one for each changed geom
  std::string controls;           ///< table of controls, a file; excludes `table`
  std::optional<ControlTable> table;
  std::string mocap;              ///< table of poses of mocap bodies; excludes `replay`
  std::string replay;             ///< recorded run whose poses of the first mocap body are repeated
  std::string policy;             ///< name of the policy that sets the controls; excludes a table of controls
  double seconds = 0;             ///< length of the run; 0 until the last row of the tables
  double record_interval = 0.01;  ///< time between two rows [s]
  bool operator==(const SceneJob&) const = default;
};

/// Parses a scene: an object with the keys of docs/many_runs.md, or the name of a file. Relative paths begin in
/// `folder`. Throws Error("", JSON pointer, ...).
SceneJob parse_scene_job(const std::string& text, const std::filesystem::path& folder);

/// Returns one line of JSON, which parse_scene_job() reads.
std::string scene_job_to_json(const SceneJob& scene);

/// Returns the files that a scene names besides its own, with their JSON pointers, so that they can be replaced.
std::vector<std::pair<std::string, std::string*>> files_of(SceneJob& scene);

/// The facts of a scene that a list needs.
struct SceneFacts {
  std::vector<std::string> files;  ///< all files that the scene is made of, with its own, by absolute paths
};

/// Loads a scene with its sensors, and checks all names and values of a job against it. Throws Error with a JSON
/// pointer relative to the scene.
using SceneReader = std::function<SceneFacts(const SceneJob& scene)>;

}  // namespace taxel
