// What a viewer needs of one simulation step, free of MuJoCo: everything drawn in one frame comes from one SimFrame.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/scenario/scenario.h"
#include "core/mesh/tri_mesh.h"
#include "core/run/history/breakpoints.h"
#include "core/run/history/lanes.h"
#include "core/run/scene_controls.h"
#include "core/run/scene_marks.h"
#include "core/run/step_cost.h"
#include "core/run/trace.h"
#include "core/sensor/sensor_step.h"

namespace taxel {

/// A geom as drawn, frame G. Meshes and primitives alike come as triangles; planes as a large square with `plane` set.
struct SceneGeom {
  std::string name;
  std::string body;
  int body_index = 0;  ///< in SceneControls::bodies
  TriMeshPtr mesh;
  std::array<float, 4> rgba{0.6f, 0.6f, 0.6f, 1.0f};
  bool plane = false;
  int sensor = -1;  ///< index of the sensor whose skin this is (drawn from its SensorModel instead), or -1
  int group = 0;    ///< MuJoCo's, 0 to 5: what viewers show together
};

/// A body that a sensor touches.
struct TouchedBody {
  HydroBodyPtr body;                   ///< null: a sensor that cannot be touched
  int geom = -1;                       ///< that it is, in SimScene::geoms; its frame is G
  int sensor = -1;                     ///< that it is instead, in SimScene::sensors; its frame is that sensor's M
  bool mirrored = false;               ///< that sensor computes the pair's surface
  Pose X_WB;                           ///< of one that is neither, and does not move
  std::string name;                    ///< of its geom
  std::shared_ptr<const Shape> shape;  ///< of that, in the frame of the body; null for a sensor
};

/// The parts of a scene that do not change while it runs.
struct SimScene {
  std::string title;
  std::vector<std::string> files;  ///< on disk, that it was made of beside its own: included, assets, layouts
  std::vector<SceneGeom> geoms;
  std::vector<SensorModelPtr> sensors;
  std::vector<std::string> sensor_geoms;          ///< geom name of each sensor
  std::vector<std::vector<TouchedBody>> touched;  ///< by sensor; none in a saved step of a version that left them out
  std::vector<dvec3> path_W;         ///< where the finger's lowest point is led: drawn as a red line; may be empty
  dvec3 lead_M{0};                   ///< that point, in the frame of the finger's mesh file
  std::vector<WayPoint> way_points;  ///< of a scenario: where the parts of its motion meet; a drop has none
  double duration = 0;               ///< scenario length [s]; 0: endless
  double timestep = 0;               ///< [s]
  SceneControls controls;
  SceneMarks marks;
};

/// The latest steps, any of which can be shown again.
struct HistoryState {
  std::uint64_t first = 0, last = 0;  ///< steps that are kept
  std::size_t steps = 0;              ///< how many those are
  std::size_t bytes = 0;              ///< memory that they take
  double step_seconds = 0;            ///< mean wall time that recording one of the latest steps took [s]
  StepHistoryLimits limits;
  std::shared_ptr<const HistoryLanes> lanes;  ///< all of them, up to the newest or a little before; never null
};

/// The step before the one that a frame shows, as it was recorded.
struct StepBefore {
  std::shared_ptr<const SimScene> scene;
  std::uint64_t step = 0;
  double time = 0;  ///< [s]
  std::vector<SensorStep> sensors;
};

/// A step of the history, as it was recorded.
struct RecordedStep {
  std::shared_ptr<const SimScene> scene;
  std::uint64_t step = 0;
  double time = 0, travel = 0;  ///< [s], [m]
  std::vector<Pose> geom_poses;
  std::vector<SensorStep> sensors;
};

/// What a RecallCommand asked for: those that are kept still.
struct RecalledSteps {
  std::uint64_t number = 0;  ///< of the command
  std::vector<RecordedStep> steps;
};

/// The scene was written to a file, or could not be.
struct SavedScene {
  std::uint64_t number = 0;  ///< counts
  std::string file, error;   ///< error empty: it was
};

/// Every step that is made is kept, whatever the history holds.
struct RecordingState {
  bool on = false;
  std::size_t steps = 0, bytes = 0;  ///< so far; the memory that they take
  double seconds = 0;                ///< simulated
};

/// A recording was written, or could not be: then it is kept until it is, or another one begins.
struct WrittenRecording {
  std::uint64_t number = 0;  ///< counts
  std::string file, error;   ///< error empty: it was
  std::size_t rows = 0;
  std::string note;   ///< what the user should know of it; may be empty
  bool kept = false;  ///< WriteRecordingCommand writes it elsewhere
};

struct SimFrame {
  std::shared_ptr<const SimScene> scene;
  std::uint64_t step = 0;
  double time = 0;    ///< of the state that was evaluated [s]
  double travel = 0;  ///< of the mocap body [m]
  bool playing = false;
  bool finished = false;         ///< the scenario is over
  double speed = 1.0;            ///< wanted, in multiples of real time
  double measured_speed = 0;     ///< reached lately
  std::vector<Pose> geom_poses;  ///< X_WG parallel to scene->geoms
  std::vector<SensorStep> sensors;
  ControlValues controls;                 ///< of scene->controls
  std::optional<PerturbShown> perturbed;  ///< none while a step of the past is shown
  std::vector<HeldPoints> held;
  MarkPoses mark_poses;  ///< of scene->marks
  StepFacts facts;
  std::shared_ptr<const Trace> trace;  ///< copied when a row is added, at most 30 times a second
  std::vector<std::string> warnings;   ///< all that the sensors have to say about the scene, as Simulator::warnings()
  double step_seconds = 0;             ///< mean wall time of one of the latest steps [s]; 0: none was made
  std::vector<StepCost> costs;         ///< of the latest steps that were made, oldest first
  bool recorded = false;               ///< a step of the past is shown; the newest is history.last
  std::shared_ptr<const SimScene> simulated;  ///< of the newest step: another than `scene` where its layout changed
  HistoryState history;
  /// Where it is asked for (FollowStepBeforeCommand), the simulation does not run by itself, and it is kept; else null.
  std::shared_ptr<const StepBefore> before;
  std::shared_ptr<const RecalledSteps> recalled;  ///< last; null: none were asked for
  Breakpoints breakpoints;
  std::optional<Stop> stop;        ///< the breakpoint that was met, until the simulation goes on
  std::uint64_t runs = 0;          ///< times that the simulation began at its start
  std::uint64_t commands = 0;      ///< executed so far
  std::uint64_t loads = 0;         ///< scenes asked for so far, whether built or refused
  std::uint64_t replacements = 0;  ///< likewise models to replace
  SavedScene saved;                ///< last
  RecordingState recording;
  WrittenRecording written;  ///< last
  bool failed = false;       ///< `error` is the simulation's own: it goes on only from an earlier step, or the start
  std::string error;         ///< why the simulation stopped, or the last scene or model was refused; empty: fine
};
using SimFramePtr = std::shared_ptr<const SimFrame>;

}  // namespace taxel
