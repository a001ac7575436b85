// The document and the run as they are displayed in this frame. Panels and tools only read them.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/studio/frame/viewer.h"
#include "core/document/history.h"
#include "core/mesh/topology/mesh_check.h"
#include "core/run/frame.h"
#include "core/run/step.h"

namespace taxel::ui {

/// The error bars of the readings of all sensors of a scene in one step, as the window measured them; see
/// core/sim/compare/error_bars.h.
struct MeasuredErrors {
  StepId id;                              ///< measured step
  std::vector<std::vector<double>> bars;  ///< bars of each sensor, in SI units; empty for a sensor without bars
  std::vector<std::string> missing;       ///< why a sensor has no bars; empty if it has
  std::string problem;                    ///< why no sensor has bars; empty if they were measured
};
using MeasuredErrorsPtr = std::shared_ptr<const MeasuredErrors>;

/// The document as it is edited.
struct Editing {
  ProjectPtr project;      ///< edited project, or null
  bool compiled = true;    ///< DocumentView::model was compiled from `project`, not from an earlier project
  std::string problem;     ///< why it cannot be compiled or simulated; empty if it can, or is being compiled
  std::string undo, redo;  ///< names of the next steps: "Undo Move taxel 3"
  std::size_t undo_depth = 0, redo_depth = 0;
  /// All steps of the history, oldest first; null if there is no project. The present step has the index `undo_depth`.
  std::shared_ptr<const std::vector<HistoryStep>> steps;
  std::uint64_t saved_revision = 0;  ///< revision of the step that is saved, or 0
  bool dirty = false;                ///< whether there are unsaved edits
  std::string mesh_sha256;           ///< hash of the mesh file as it was read; empty if unknown

  std::shared_ptr<const MeshFindings> mesh_findings;  ///< findings about its mesh; null while unknown
};

/// A load that runs in a worker, or a scene that the simulation builds.
struct Loading {
  bool active = false;
  std::string what;
  double fraction = 0;
  double seconds = 0;       ///< time since the load began
  bool can_cancel = false;  ///< MuJoCo's compiler cannot be stopped
  std::string step;         ///< step that is under way, as in "Filling holes"; or empty
};

/// The samples of the document are polished in a worker, while their preview is displayed.
struct Polishing {
  bool active = false;
  double fraction = 0;     ///< 0 in script mode, whose frames do not depend on time
  bool holds_run = false;  ///< whether the run starts as soon as the samples are polished
};

/// Rates of the program, for the status line.
struct Performance {
  double fps = 0;               ///< frames per second while frames change
  double simulation_speed = 0;  ///< multiples of real time
  double step_seconds = 0;      ///< mean wall time of one of the latest simulation steps [s], or 0 if unknown
  bool is_real_time = true;     ///< false in script mode, in which rates mean nothing
  bool is_resting = false;      ///< nothing moves, so that a rate of frames means nothing
};

/// The edited layout of an open scene.
struct SceneLayout {
  std::string file;                ///< absolute path of its file, which may not have been written yet
  std::vector<std::string> geoms;  ///< geoms that have the layout, or get it as soon as it has a taxel; at least one
  bool is_written = false;         ///< whether the file holds the layout, as it was read or saved last
  bool is_text = false;            ///< whether the scene's file has the layout itself as text
};

struct DocumentView {
  SensorModelPtr model;                     ///< compiled layout of the document, or null if nothing is open
  MeasuredPtr measured;                     ///< distance between the points of the measure tool, or null
  ShownFieldsPtr fields;                    ///< requested receptive fields of the displayed layout, or null
  PressedProbePtr probe;                    ///< probe pressed on `model`, or null
  std::string name;                         ///< name of the document
  std::string file;                         ///< file of the document; empty if it is built in
  bool is_scene = false;                    ///< whether the document is a MuJoCo scene
  std::optional<SceneLayout> scene_layout;  ///< layout of the scene that `editing` edits; empty if none is edited
  Editing editing;
  Loading loading;
  Polishing polishing;
};

struct RunView {
  SimFramePtr frame;                      ///< newest frame of the simulation, or null if none runs
  bool simulates_document = false;        ///< whether the running scene was built around DocumentView::model
  Scenario scenario;                      ///< scenario of the run
  bool runs_scenario = false;             ///< whether the running scene is the document's scenario
  std::vector<SceneAttachment> attached;  ///< layouts on geoms that the file does not declare, or edited ones
  bool playing = false;                   ///< whether the simulation runs, or recorded steps are played
  int replay = 0;                         ///< direction in which recorded steps are played, or 0
  std::optional<StepRange> loop;
  double speed = 1;
  std::vector<double> peaks;         ///< largest reading of each taxel of the selected sensor since the start [Pa]
  std::vector<double> all_peaks;     ///< largest readings of all sensors, one sensor after the other
  std::vector<double> sensor_peaks;  ///< largest reading of each sensor since the start, in SI units
  MeasuredErrorsPtr errors;          ///< newest error bars, or null while they are off or not yet measured
  Performance performance;

  /// Returns the bars of a sensor in SI units, empty if there are none: those of the displayed step, or while the run
  /// plays of a moment before.
  [[nodiscard]] std::span<const double> error_bars(int sensor) const;
  /// Whether the run is best shown over travel, not over time.
  [[nodiscard]] bool by_travel() const { return runs_scenario && scenario.is<scenarios::Sweep>(); }
  /// Whether there are recorded steps.
  [[nodiscard]] bool has_history() const { return frame && frame->history.steps > 0; }
};

/// Everything that is displayed of the document and of the run. The program fills it before each frame.
struct Shown {
  DocumentView document;
  RunView run;
  std::string version;   ///< version of the program
  std::string versions;  ///< the same with the commit and the version of MuJoCo

  /// Returns the text of a panel that has nothing to display: nothing is open, or it is being loaded.
  [[nodiscard]] const char* empty_text() const;
  /// Whether the view shows the running scene: in SIMULATE, and in LAYOUT while no layout of a scene is edited.
  [[nodiscard]] bool shows_scene(const Viewer& viewer) const;
  /// Whether the layout that taxel numbers refer to is the edited one.
  [[nodiscard]] bool shows_edited(const Viewer& viewer) const;
  /// Returns the state of the selected sensor in the newest frame, or null.
  [[nodiscard]] const SensorStep* sensor(const Viewer& viewer) const;
  /// Returns the step that readings and contact are displayed of: the probe's in LAYOUT, otherwise the simulation's.
  /// Null if nothing is read.
  [[nodiscard]] const SensorStep* state(const Viewer& viewer) const;
  /// Returns the layout that taxel numbers refer to: the selected sensor's if the view shows the scene, otherwise the
  /// document's. May be null.
  [[nodiscard]] SensorModelPtr model(const Viewer& viewer) const;
  /// Returns the layout to display: if it is edited, the edited one, which may be newer than model(). May be null.
  [[nodiscard]] const Layout* layout(const Viewer& viewer) const;
};

/// Returns the index of the sensor on a geom, or -1 if there is none.
[[nodiscard]] int sensor_on(const SimScene& scene, const std::string& geom);

/// Returns whether a layout can be edited, and is displayed.
[[nodiscard]] bool can_edit(const Viewer& viewer, const Shown& shown);

}  // namespace taxel::ui
