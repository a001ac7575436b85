// What the window knows beside the document: plain state that the program owns and every panel gets. What is kept from
// one start to the next stands apart from what passes.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/app/command.h"
#include "app/studio/app/selection.h"
#include "app/studio/features/camera/follow_state.h"
#include "app/studio/features/explain/explain_state.h"
#include "app/studio/features/generate/generate_state.h"
#include "app/studio/features/inspector/layout_problems.h"
#include "app/studio/features/inspector/model_summary.h"
#include "app/studio/features/map/map_state.h"
#include "app/studio/features/measure/measure_state.h"
#include "app/studio/features/menus/palette_state.h"
#include "app/studio/features/mesh/mesh_state.h"
#include "app/studio/features/models/models_state.h"
#include "app/studio/features/perturb/perturb_state.h"
#include "app/studio/features/plot/plot_curves.h"
#include "app/studio/features/probe/probe_state.h"
#include "app/studio/features/profiler/profile_state.h"
#include "app/studio/features/real/real_state.h"
#include "app/studio/features/scenario/path_state.h"
#include "app/studio/features/section/section_panel.h"
#include "app/studio/features/study/study_state.h"
#include "app/studio/features/table/table_state.h"
#include "app/studio/features/taxel/tool_state.h"
#include "core/base/error.h"
#include "core/document/history.h"
#include "core/mesh/topology/mesh_report.h"
#include "core/run/frame.h"
#include "ui/scene/pick/camera.h"
#include "ui/scene/pick/picking.h"
#include "ui/scene/pressed_probe.h"
#include "ui/scene/scene_input.h"
#include "ui/scene/scene_labels.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// Which panels are open; their names are the titles of their windows.
struct PanelsShown {
  bool outliner = true, taxels = true, inspector = true, bars = true, plot = true, section = true, timeline = true;
  bool controls = true;
  bool messages = false, help = false, explain = false, map = false, models = false, study = false;
  bool mesh_report = false, info = false, profiler = false;
};

struct PlotOptions {
  bool relative = true;         ///< divided by the largest reading of the run, as the paper's Figure 4; else kPa
  bool responding_only = true;  ///< only taxels above 5 % of the largest
};

/// Kept in the settings file.
struct SavedState {
  bool dark = true;
  float scale = 1.0f;  ///< of the interface, on top of the screen's own
  Overlays overlays;
  PanelsShown panels;
  PlotOptions plot;
  bool tour_seen = false;
  std::vector<std::string> recent;  ///< newest first
};

/// A line for the user. Errors and warnings stay until closed; notes leave the view after a while.
struct Message {
  Severity severity = Severity::note;
  std::string text;
  int number = 0;       ///< 1, 2, ... in order of arrival
  double shown_at = 0;  ///< interface time [s]
  bool toast = true;    ///< still floating over the view
};

/// One entry of a folder, listed by the program for the file dialog.
struct FolderEntry {
  std::string name;
  bool folder = false;
};

struct FileDialog {
  FileTask task = FileTask::open;
  bool open = false;
  bool wants_focus = false;  ///< the path field gets the keyboard in the next frame
  std::string folder;        ///< absolute
  std::vector<FolderEntry> entries;
  std::string path;    ///< what stands in the field
  std::string filter;  ///< part of a name, any case
  int selected = -1;   ///< index in entries
  std::string error;   ///< why the folder could not be listed, or the file not be written
  std::string exists;  ///< file that is there already: asked for once more, it is replaced

  int width = 2400, height = 1800;  ///< of an exported picture [pixels]
};

/// An open file is not any more what was read. Stays until it is answered.
struct FileNotice {
  std::string file;
  std::string text;
  std::vector<FileOffer> offers;  ///< beside leaving all as it is
};

/// The document as it is edited.
struct Editing {
  ProjectPtr project;      ///< null: there is nothing to edit
  bool compiled = true;    ///< UiInput::model was compiled of it, not of one before
  std::string problem;     ///< why it cannot be compiled, or simulated; empty: it can, or is not yet
  std::string undo, redo;  ///< names of the next steps: "Undo Move taxel 3"
  std::size_t undo_depth = 0, redo_depth = 0;
  bool dirty = false;       ///< not saved as it is
  std::string mesh_sha256;  ///< of the mesh file as it was read; empty: unknown

  std::shared_ptr<const MeshFindings> mesh_findings;  ///< about its mesh; null: not known yet
};

/// A load that runs in the worker, or a scene that the simulation builds.
struct Loading {
  bool active = false;
  std::string what;
  double fraction = 0;
  double seconds = 0;       ///< since it began
  bool can_cancel = false;  ///< MuJoCo's compiler cannot be stopped
};

/// The samples of the document are polished in the worker, while their preview is shown.
struct Polishing {
  bool active = false;
  double fraction = 0;     ///< 0 in pictures that follow a script: those are the same every time
  bool holds_run = false;  ///< whether the run starts as soon as the samples are polished
};

/// A bar as it was drawn in the last frame: the picture as numbers.
struct BarShown {
  int taxel_id = 0;
  double value = 0;        ///< [Pa]
  double height = 0;       ///< [pixels]
  Rect rect;               ///< the filled part
  double top = 0;          ///< pressure at the top of the axis [Pa]
  double axis_height = 0;  ///< of the whole axis [pixels]
};

/// Where the 3-D view stands and what it drew last; compared to know whether to draw again.
struct ViewShown {
  Rect rect;
  int width = 0, height = 0;  ///< of the texture
  SceneInput input;
  Camera camera;
  std::vector<SceneLabel> labels;  ///< of that picture
  FieldNumbers numbers;            ///< of its overlays
  bool drawn = false;
  int draws = 0;
};

/// Where the timeline drew its lanes, and what a drag in them does.
struct Timeline {
  Rect lanes;                               ///< all of them, without their names
  StepRange steps;                          ///< at their left and right edge
  int marks = 0;                            ///< events drawn
  bool scrubs = false;                      ///< a drag moves the cursor
  std::optional<std::uint64_t> loops_from;  ///< a drag marks a range that begins, or ends, here
};

/// What the panel of controls remembers.
struct ControlsState {
  std::vector<std::string> geoms;  ///< chosen, to attach a layout to
  std::string filter;              ///< part of a geom's name, any case
  bool wants_focus = false;        ///< another scene was opened
};

struct Clicks {
  int left = 0, left_double = 0, right = 0, right_double = 0;
};

/// The widgets take only the Ui of it.
struct UiState : Ui {
  SavedState saved;
  double arranged_scale = 0;  ///< of the interface when its panels were arranged; 0: not yet

  Mode mode = Mode::simulate;
  std::array<Camera, 2> cameras;  ///< one per mode
  PressureRange range;
  Selection selection;
  ToolState tool;
  TableState table;
  LayoutProblems problems;  ///< of the layout that is edited
  GenerateState generate;
  PaletteState palette;
  ProbeState probe;
  MeasureState measure;
  MeshState mesh;
  ExplainState explain;
  MapState map;
  ModelsState models;
  PerturbState perturb;
  FollowState follow;
  ProfileState profile;
  ControlsState controls;
  RealState real;
  VideoState video;
  PathState path;
  StudyState study;
  std::optional<ClipPlane> clip;  ///< of the 3-D view
  int tour_step = -1;             ///< of the tour that is shown; -1: none is
  bool full_screen = false;       ///< the window, without frame
  bool asks_unsaved = false;      ///< whether to save, before what is open is left
  std::string recovery;           ///< name of a document that was lost unsaved and can be had back; empty: none
  std::string recovery_detail;    ///< when and where
  std::string title;              ///< of the window
  std::optional<Pick> hovered;    ///< what the resting pointer is on in the 3-D view
  std::vector<Message> messages;
  FileDialog dialog;
  PlotCurves curves;
  SectionState section;
  Timeline timeline;
  ModelSummary summary;  ///< of the layout shown
  std::vector<BarShown> bars;
  ViewShown view;
  Clicks clicks;
  std::vector<Command> commands;  ///< posted in this frame, in order
  bool reset_arrangement = false;
  int toolbar_rows = 1, status_rows = 1;  ///< that they needed in the picture before

  std::vector<FileNotice> notices;  ///< oldest first

  [[nodiscard]] Camera& camera() { return cameras[mode == Mode::layout ? 0 : 1]; }
  [[nodiscard]] const Camera& camera() const { return cameras[mode == Mode::layout ? 0 : 1]; }
  void ask(Command command);
};

/// How fast things go; shown in the status line.
struct Performance {
  double fps = 0;               ///< pictures per second while the picture changes
  double simulation_speed = 0;  ///< multiples of real time
  double step_seconds = 0;      ///< mean wall time of one of the latest simulation steps [s]; 0: unknown
  bool by_clock = true;         ///< false: frames follow a script, and rates mean nothing
};

/// What there is to show: read only for panels.
struct UiInput {
  SimFramePtr frame;                ///< newest of the simulation; null: none runs
  SensorModelPtr model;             ///< compiled layout of the document; null: nothing open
  MeasuredPtr measured;             ///< between the measure's points; null: not yet
  ShownFieldsPtr fields;            ///< receptive fields of what is shown; null: not yet, or none are requested
  PressedProbePtr probe;            ///< pressed on `model`; null: no probe, or not yet
  RealShownPtr real;                ///< a real sensor's recording over the run; null: none
  VideoProgress video;              ///< of the one that is being made
  ComparedPtr compared;             ///< of the selected sensor by other models; null: not asked for, or not yet
  StudyShown study;                 ///< runs of a parameter study
  ExplainedPtr explained;           ///< of the step shown, or one before; null: none is asked for, or not yet
  std::string name;                 ///< of the document
  std::string file;                 ///< where it came from; empty: built in
  bool simulates_document = false;  ///< the running scene was built around `model`
  Editing editing;
  Scenario scenario;
  bool runs_scenario = false;             ///< the running scene is the document's scenario
  bool is_scene = false;                  ///< the document is a MuJoCo scene
  std::vector<SceneAttachment> attached;  ///< layouts on its geoms that its file does not declare
  bool playing = false;                   ///< the simulation, or recorded steps
  int replay = 0;                         ///< direction in which recorded steps are played; 0: they are not
  std::optional<StepRange> loop;
  double speed = 1;
  std::vector<double> peaks;  ///< largest reading of each taxel of the selected sensor since the start [Pa]
  Performance performance;
  Loading loading;
  Polishing polishing;
  std::string version;

  /// What runs is best shown over travel, not over time.
  [[nodiscard]] bool by_travel() const { return runs_scenario && scenario.is<scenarios::Sweep>(); }
  /// Whether there are recorded steps.
  [[nodiscard]] bool has_history() const { return frame && frame->history.steps > 0; }
  /// State of the selected sensor in the newest frame, or null.
  [[nodiscard]] const SensorStep* sensor(const UiState& ui) const {
    if (!frame || ui.selection.sensor < 0 || ui.selection.sensor >= static_cast<int>(frame->sensors.size()))
      return nullptr;
    return &frame->sensors[static_cast<std::size_t>(ui.selection.sensor)];
  }
  /// What readings and contact are of: the probe in LAYOUT, the simulation else. Null: nothing is read.
  [[nodiscard]] const SensorStep* shown_state(const UiState& ui) const {
    if (ui.mode == Mode::layout) return probe && probe->problem.empty() ? &probe->state : nullptr;
    return sensor(ui);
  }
  /// The layout that taxel numbers refer to: the selected sensor's in SIMULATE, the document's in LAYOUT. May be null.
  [[nodiscard]] SensorModelPtr shown_model(const UiState& ui) const {
    if (ui.mode == Mode::simulate && sensor(ui) != nullptr) {
      return frame->scene->sensors[static_cast<std::size_t>(ui.selection.sensor)];
    }
    return model;
  }
  /// The layout that there is to show: in LAYOUT the one that is edited, which may be newer than shown_model(). May be
  /// null.
  [[nodiscard]] const Layout* shown_layout(const UiState& ui) const {
    if (ui.mode == Mode::layout && editing.project) return &editing.project->layout;
    const SensorModelPtr shown = shown_model(ui);
    return shown ? &shown->layout : nullptr;
  }
};

/// Returns whether a layout can be edited, and is displayed.
[[nodiscard]] bool can_edit(const UiState& ui, const UiInput& input);

/// Requests the edit of the field drawn last. If the edit is refused, the field says why.
void ask_edit(UiState& ui, Edit edit);

/// Selects a taxel that was clicked: alone, or with Shift in addition, or no longer if it was selected.
void click_taxel(UiState& ui, int id, bool shift);

/// Opens the file dialog with empty fields.
void begin_dialog(UiState& ui, FileTask task);
/// Opens the dialog for the file to open, and lists its folder.
void open_dialog(UiState& ui);

/// Adds a message for the user; `now` is the interface time [s].
void add_message(UiState& ui, Severity severity, std::string text, double now);

}  // namespace taxel::ui
