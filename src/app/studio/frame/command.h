// Commands: values that say what keys, menus, panels and tools can have done. CarryOut and Studio carry them out.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/document/edit.h"
#include "core/document/history.h"
#include "core/run/command.h"
#include "core/run/marks.h"
#include "ui/widgets/field_state.h"

namespace taxel::ui {

struct Overlays;
struct App;
struct Feature;
enum class Tool;

enum class Mode { layout, simulate };

enum class FileTask {
  open,
  save_project,
  export_layout,
  export_taxels,
  export_samples,
  export_sheet,
  export_picture,
  export_plot,  ///< readings over travel or time
  export_frame,
  export_recording,  ///< the recorded steps
  keep_recording,    ///< one that could not be written where it was to be
  export_video,
  import_recording,  ///< the table of a real sensor
  read_points,
  attach_layout,
  compare_layout,     ///< a second layout for the run
  export_comparison,  ///< the readings of both layouts
  save_scene,
  save_study,  ///< the displayed study, as a data set
  open_study   ///< a data set in the panel of studies
};

// Commands about the interface alone: CarryOut. They act at once. Many post a command to the program, made from the
// selection or from the step that is displayed.

struct ShowOpenDialog {};
/// Begins a gesture on the selected taxels or the selected waypoint; `copies`: on copies of the taxels.
struct BeginGesture {
  Tool tool{};
  bool copies = false;
  bool operator==(const BeginGesture&) const = default;
};
/// Restricts the running gesture to an axis, or frees it if it is restricted to that axis.
struct ConstrainGesture {
  int axis = 0;  ///< 0 x, 1 y, 2 z
  bool operator==(const ConstrainGesture&) const = default;
};
struct AcceptGesture {};
struct CancelTool {};
/// Starts a tool, or leaves it if it is the active one.
struct ToggleTool {
  Tool tool{};
  bool operator==(const ToggleTool&) const = default;
};
struct ToggleProbe {};
/// Changes to LAYOUT and starts the probe.
struct ProbeInLayout {};
struct ToggleMeasure {};
struct ToggleGenerate {};
struct DeleteSelected {};
struct ProjectSelectedBack {};
struct RenameSelected {};
struct MoveInOrder {
  bool earlier = false;
  bool operator==(const MoveInOrder&) const = default;
};
struct MirrorSelected {};
struct HideSelected {};
/// Hides all taxels but the selected ones, or shows all if just those are shown.
struct ShowOnlySelected {};
struct SelectAll {};
struct SelectNone {};
struct InvertSelection {};
struct SelectParentBody {};
/// Leaves the innermost activity: tool, popup, selection, camera of the scene.
struct Escape {};
/// Gives the keyboard to a panel.
struct EnterPanel {
  const char* title = nullptr;
  bool operator==(const EnterPanel&) const = default;
};
struct OpenPalette {};
/// Calls a function of a noun, which is about the interface alone.
struct Call {
  void (*function)(App& app) = nullptr;
  bool operator==(const Call&) const = default;
};

struct ToggleOverlay {
  bool Overlays::*overlay = nullptr;
  bool operator==(const ToggleOverlay&) const = default;
};
struct ToggleGroup {
  GroupsShown Overlays::*groups = nullptr;  ///< geoms or sites
  std::size_t group = 0;
  bool operator==(const ToggleGroup&) const = default;
};
struct TogglePanel {
  const Feature* panel = nullptr;
  bool operator==(const TogglePanel&) const = default;
};
struct CycleFrames {};
struct CycleLabels {};
struct ToggleClipPlane {};
struct FlipClipPlane {};
struct ToggleRangeLock {};
struct ToggleReadingRangeLock {};
struct LinkRanges {};
struct ToggleTheme {};
struct ToggleFullScreen {};
/// Asks for files by the desktop's own dialog, or by the window's.
struct ToggleDesktopDialog {};
struct ScaleInterface {
  int steps = 0;  ///< by which it grows; 0: back to normal size
  bool operator==(const ScaleInterface&) const = default;
};
struct ResetArrangement {};
/// Lets the panel under the pointer fill the window, or restores all panels.
struct MaximisePanel {};
struct FrameCamera {
  bool selection = false;  ///< only the selected taxels, otherwise everything
  bool operator==(const FrameCamera&) const = default;
};
struct AlignCamera {};
/// Looks from the end of an axis: 0..5 for +x, -x, +y, -y, +z, -z.
struct TakeStandardView {
  int axis = 0;
  bool operator==(const TakeStandardView&) const = default;
};
struct ToggleOrthographic {};
/// Looks through the next or the previous camera of the scene.
struct StepCamera {
  int direction = 1;  ///< 1 or -1
  bool operator==(const StepCamera&) const = default;
};

/// Displays the next or the previous recorded event.
struct GoToEvent {
  int direction = 1;  ///< 1 or -1
  bool operator==(const GoToEvent&) const = default;
};
struct GoToNewestStep {};
struct TogglePlayBackwards {};
struct ToggleLoop {};
struct ToggleBreakOnJump {};
struct ExplainReading {};
struct ToggleRecording {};
struct ToggleRecordPath {};
/// Changes the speed of the simulation by a factor of 2.
struct ChangeSpeed {
  bool faster = false;
  bool operator==(const ChangeSpeed&) const = default;
};

// Commands to the program: the overloads of Studio. They are carried out after the interface was laid out, in order.

/// Remedies for an open file that another program has changed.
enum class FileOffer {
  reload,       ///< read the document again, as an edit
  use_mesh,     ///< the mesh of the file as it is now
  project_back  ///< use the mesh, and bring the taxels back to its surface
};

struct OpenFile {
  std::string path;
  std::string mesh = {};  ///< file, for a layout of another program without a mesh
};
/// Opens the layout and the scenario of an episode of a data set and runs it.
struct OpenEpisode {
  std::string folder;  ///< folder of the data set
  std::int64_t episode = 0;
  bool operator==(const OpenEpisode&) const = default;
};
/// Writes the displayed study as a data set. An empty path asks for the folder.
struct SaveStudy {
  std::string path = {};
  bool operator==(const SaveStudy&) const = default;
};
/// Shows the runs of a data set in the panel of studies. An empty path asks for its meta/info.json.
struct OpenStudy {
  std::string path = {};
  bool operator==(const OpenStudy&) const = default;
};
/// Opens an example that travels inside the program: the name of a row of studio::examples().
struct OpenExample {
  std::string name;
  bool operator==(const OpenExample&) const = default;
};
struct OpenFingertipSweep {};
/// Opens the paper's artifact: the fingertip with few samples, whose readings jump. Its run pauses at the first jump.
struct OpenJumpingTaxel {};
/// Opens a new layout without taxels, on the fingertip's mesh.
struct NewLayout {};
/// Writes the example files, unless they are there, and opens the file dialog in their folder.
struct OpenExamples {};
struct CloseDocument {};
struct ListFolder {
  std::string path;
};
struct CancelLoading {};  ///< or polishing, whichever runs
struct PolishSamples {};  ///< polishes the document's samples if a preview's are shown
struct SendCommand {
  SimCommand command;
};
struct RunScenario {
  Scenario scenario;
};
/// Plays if the simulation pauses when the command is carried out, otherwise pauses: earlier commands count.
struct PlayOrPause {};
struct StepOnce {};
struct StepBack {};
/// Displays a recorded step; the simulation pauses.
struct ScrubTo {
  std::uint64_t step = 0;
};
/// Plays recorded steps, from the displayed one: 1 forwards, -1 backwards.
struct ReplayHistory {
  int direction = -1;
};
struct SetLoop {
  std::optional<StepRange> range;  ///< empty if nothing is looped
};
struct SetBreakpoints {
  Breakpoints breakpoints;
};
struct SetHistoryLimits {
  StepHistoryLimits limits;
};
/// Records every simulated step until recording ends; then the recording is written.
struct SetRecording {
  bool on = false;
};
/// Reads a table of a real sensor and asks for its columns, which are guessed. An empty path asks for the file.
struct ReadRealRecording {
  std::string path;
};
enum class RealTask {
  look,          ///< at the table again, by the mapping of the dialog
  overlay,       ///< the recording, as the dialog says
  save_mapping,  ///< next to the table
  align,
  fit,
  apply,  ///< the gains, as the layout's calibration
  remove
};
struct ActOnReal {
  RealTask task = RealTask::align;
};
struct ShiftReal {
  double seconds = 0;
};
/// Compares the run with a second layout, or with the paper's released model. An empty path asks for the layout.
struct CompareLayout {
  std::string path = {};
  bool paper = false;
  bool operator==(const CompareLayout&) const = default;
};
struct CancelVideo {};
/// Makes a film for a talk: the camera turns once around the contact during the recorded run.
struct MakeFilm {};
struct ResetSimulation {};
struct SetSpeed {
  double factor = 1;
};
struct SetMode {
  Mode mode = Mode::simulate;
  bool operator==(const SetMode&) const = default;
};
struct ReloadFile {};
struct SetMeshUnit {
  double metres = 1;  ///< length of one unit of the mesh file
};
struct EditProject {
  Edit edit;
  taxel::Gesture gesture;
  std::optional<FieldInput> from = {};  ///< field that shows the reason if the edit is refused
};
struct CancelGesture {
  std::uint64_t number = 0;
};
struct EndGesture {};
struct UndoStep {};
struct RedoStep {};
/// Undoes or redoes steps until the project has this revision.
struct GoToEdit {
  std::uint64_t revision = 0;
};
struct CopyTaxels {};  ///< the selected ones, as JSON
struct PasteTaxels {};
/// An empty path saves the document where it is, or asks for a file. `replace`: another file there may be lost.
struct SaveProject {
  std::string path = {};
  bool replace = false;
};
struct SaveAs {};  ///< asks for the file of the project, or of the scene if a scene is open
struct ExportFile {
  FileTask task = FileTask::export_layout;
  std::string path = {};  ///< empty if the file is to be asked for
  bool replace = false;
  int width = 0, height = 0;  ///< size of an image [pixels]
  bool operator==(const ExportFile&) const = default;
};
/// Attaches a layout to geoms of the open scene and compiles the scene again; its file stays as it is. An empty path
/// asks for the layout.
struct AttachLayout {
  std::vector<std::string> geoms;
  std::string path;
};
struct DetachLayout {
  std::string geom;
};
/// Saves the open scene with all its sensors declared. An empty path asks for the file.
struct SaveScene {
  std::string path = {};
  bool replace = false;
};
struct DialogClosed {};  ///< without a file
enum class UnsavedAnswer { save, discard, cancel };
struct AnswerUnsaved {
  UnsavedAnswer answer = UnsavedAnswer::cancel;
};
struct AnswerRecovery {
  bool recover = false;  ///< otherwise the lost document is deleted
};
struct AnswerNotice {
  std::string file;
  std::optional<FileOffer> taken;  ///< empty if all stays as it is
};
struct ReadPoints {  ///< a table or an image for the Generate panel
  std::string path;
};
struct TakeScreenshot {};
struct Quit {};

/// Any command. It is copied, moved and destroyed in command.cpp only: the code for all alternatives, in every file
/// that makes one, takes most of the file's compile time.
struct Command
    : std::variant<ShowOpenDialog, BeginGesture, ConstrainGesture, AcceptGesture, CancelTool, ToggleTool, ToggleProbe,
                   ProbeInLayout, ToggleMeasure, ToggleGenerate, DeleteSelected, ProjectSelectedBack, RenameSelected,
                   MoveInOrder, MirrorSelected, HideSelected, ShowOnlySelected, SelectAll, SelectNone, InvertSelection,
                   SelectParentBody, Escape, EnterPanel, OpenPalette, Call, ToggleOverlay, ToggleGroup, TogglePanel,
                   CycleFrames, CycleLabels, ToggleClipPlane, FlipClipPlane, ToggleRangeLock, ToggleReadingRangeLock,
                   LinkRanges, ToggleTheme, ToggleFullScreen, ToggleDesktopDialog, ScaleInterface, ResetArrangement,
                   MaximisePanel, FrameCamera, AlignCamera, TakeStandardView, ToggleOrthographic, StepCamera, GoToEvent,
                   GoToNewestStep, TogglePlayBackwards, ToggleLoop, ToggleBreakOnJump, ExplainReading, ToggleRecording,
                   ToggleRecordPath, ChangeSpeed, OpenFile, OpenEpisode, SaveStudy, OpenStudy, OpenExample, NewLayout,
                   OpenExamples, CloseDocument, ListFolder, CancelLoading, PolishSamples, SendCommand, RunScenario,
                   PlayOrPause, StepOnce, StepBack, ScrubTo, ReplayHistory, SetLoop, SetBreakpoints, SetHistoryLimits,
                   SetRecording, ReadRealRecording, ActOnReal, ShiftReal, CompareLayout, CancelVideo, MakeFilm,
                   ResetSimulation, SetSpeed, SetMode, ReloadFile, SetMeshUnit, EditProject, CancelGesture, EndGesture,
                   UndoStep, RedoStep, GoToEdit, CopyTaxels, PasteTaxels, SaveProject, SaveAs, ExportFile, AttachLayout,
                   DetachLayout, SaveScene, DialogClosed, AnswerUnsaved, AnswerRecovery, AnswerNotice, ReadPoints,
                   TakeScreenshot, Quit> {
  using variant::variant;
  Command(const Command&);
  Command& operator=(const Command&);
  Command(Command&&) noexcept;
  Command& operator=(Command&&) noexcept;
  ~Command();
};

}  // namespace taxel::ui
