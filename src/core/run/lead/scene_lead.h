// Values over time that lead a scene: controls of actuators and poses of mocap bodies. Free of MuJoCo.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/math.h"

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

}  // namespace taxel
