// What panels ask of the program; carried out after the frame, in order.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/document/edit.h"
#include "core/document/history.h"
#include "core/run/command.h"
#include "ui/widgets/field_state.h"

namespace taxel::ui {

enum class Mode { layout, simulate };

enum class FileTask {
  open,
  save_project,
  export_layout,
  export_taxels,
  export_samples,
  export_sheet,
  export_picture,
  export_frame,
  export_recording,  ///< of the history
  keep_recording,    ///< one that could not be written where it was to be
  export_video,
  import_recording,  ///< of a real sensor
  read_points,
  attach_layout,
  save_scene
};

/// What can be done about an open file that somebody else has changed.
enum class FileOffer {
  reload,       ///< read the document again, as an edit
  use_mesh,     ///< as it is now
  project_back  ///< use the mesh, and bring the taxels back to its surface
};

struct OpenFile {
  std::string path;
  std::string mesh = {};  ///< file, for a layout of another program, which holds none
};
struct OpenFingertipSweep {};
struct CloseDocument {};
struct ListFolder {
  std::string path;
};
struct CancelLoading {};  ///< or polishing, whichever runs
struct PolishSamples {};  ///< of the document, which shows a preview's
struct SendCommand {
  SimCommand command;
};
struct RunScenario {
  Scenario scenario;
};
/// The other of the two than when it is carried out: what was asked for before counts.
struct PlayOrPause {};
struct StepOnce {};
/// A step of the history is shown; the simulation pauses.
struct ScrubTo {
  std::uint64_t step = 0;
};
struct StepBack {};
/// Plays recorded steps, from the one that is shown: 1 forwards, -1 backwards.
struct ReplayHistory {
  int direction = -1;
};
struct SetLoop {
  std::optional<StepRange> range;  ///< none: no loop
};
struct SetBreakpoints {
  Breakpoints breakpoints;
};
struct SetHistoryLimits {
  StepHistoryLimits limits;
};
/// Every step that is simulated is kept until it ends; then it is written.
struct SetRecording {
  bool on = false;
};
/// A table of a real sensor: its columns are guessed, and asked for. Empty: asks for the file.
struct ReadRealRecording {
  std::string path;
};
enum class RealTask {
  look,          ///< at the table anew, by the mapping that the dialog has
  overlay,       ///< it, as the dialog says
  save_mapping,  ///< beside the table
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
struct CancelVideo {};
struct ResetSimulation {};
struct SetSpeed {
  double factor = 1;
};
struct SetMode {
  Mode mode = Mode::simulate;
};
struct ReloadFile {};
struct SetMeshUnit {
  double metres = 1;  ///< that one unit of the mesh file is
};
struct EditProject {
  Edit edit;
  taxel::Gesture gesture;
  std::optional<FieldInput> from = {};  ///< which says why, where the edit is refused
};
struct CancelGesture {
  std::uint64_t number = 0;
};
struct EndGesture {};
struct UndoStep {};
struct RedoStep {};
struct CopyTaxels {};  ///< those selected, as JSON
struct PasteTaxels {};
/// Empty: where it is, or the user is asked. `replace`: another file of that name may be lost.
struct SaveProject {
  std::string path;
  bool replace = false;
};
struct SaveProjectAs {};  ///< asks
struct ExportFile {
  FileTask task = FileTask::export_layout;
  std::string path;  ///< empty: asks
  bool replace = false;
  int width = 0, height = 0;  ///< of a picture [pixels]
};
/// A layout on geoms of the open scene, which is compiled anew; its file stays as it is. Empty: asks for the layout.
struct AttachLayout {
  std::vector<std::string> geoms;
  std::string path;
};
struct DetachLayout {
  std::string geom;
};
/// The open scene with all its sensors declared. Empty: asks.
struct SaveScene {
  std::string path;
  bool replace = false;
};
struct DialogClosed {};  ///< without a file
enum class UnsavedAnswer { save, discard, cancel };
struct AnswerUnsaved {
  UnsavedAnswer answer = UnsavedAnswer::cancel;
};
struct AnswerRecovery {
  bool recover = false;  ///< else it is thrown away
};
struct AnswerNotice {
  std::string file;
  std::optional<FileOffer> taken;  ///< none: all stays as it is
};
struct PreviewPattern {};  ///< of what ui.generate asks for
struct DropPreview {};     ///< the one that is being made
struct ReadPoints {        ///< a table or a picture for ui.generate
  std::string path;
};
struct TakeScreenshot {};
struct Quit {};
/// One of these. Copied, moved and destroyed in one place: the code for that, of so many kinds, in every file that
/// makes one takes most of its compile time.
struct Request
    : std::variant<OpenFile, OpenFingertipSweep, CloseDocument, ListFolder, CancelLoading, PolishSamples, SendCommand,
                   RunScenario, PlayOrPause, StepOnce, StepBack, ScrubTo, ReplayHistory, SetLoop, SetBreakpoints,
                   SetHistoryLimits, SetRecording, ReadRealRecording, ActOnReal, ShiftReal, CancelVideo,
                   ResetSimulation, SetSpeed, SetMode, ReloadFile, SetMeshUnit, EditProject, CancelGesture, EndGesture,
                   UndoStep, RedoStep, CopyTaxels, PasteTaxels, SaveProject, SaveProjectAs, ExportFile, AttachLayout,
                   DetachLayout, SaveScene, DialogClosed, AnswerUnsaved, AnswerRecovery, AnswerNotice, PreviewPattern,
                   DropPreview, ReadPoints, TakeScreenshot, Quit> {
  using variant::variant;
  Request(const Request&);
  Request& operator=(const Request&);
  Request(Request&&) noexcept;
  Request& operator=(Request&&) noexcept;
  ~Request();
};

}  // namespace taxel::ui
