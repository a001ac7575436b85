// Events of the session, for the window to act on, and commands of the simulation as commands of the window.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/command.h"
#include "app/studio/frame/message_list.h"
#include "core/base/error.h"
#include "core/run/command.h"

namespace taxel::studio {

/// A message for the user.
struct HostMessage {
  Severity severity = Severity::note;
  std::string text;
  ui::Holds holds = ui::Holds::always;
  bool is_shown = true;  ///< otherwise the message is only listed, not displayed
};
/// A document or a scene is displayed.
struct Opened {
  ui::Mode mode = ui::Mode::simulate;  ///< mode that shows the document best
  bool another_document = false;       ///< it is not the same document in another scene
  bool turns_cameras = true;           ///< the cameras should turn to the document
  bool is_doubtful = false;            ///< the report about the mesh is worth a look
  std::string file;                    ///< file of the document, or empty if the document is built in
  std::string state;                   ///< state of the window, saved with the step that was opened
};
/// The document was read again, as an edit.
struct Reloaded {};
/// The edited layout has a new model.
struct ModelBuilt {
  bool is_resized = false;  ///< the mesh has another size: the cameras should turn to it
};
/// There is a new frame of the simulation.
struct FrameArrived {};
/// There is a new result of the probe, the measure, the receptive fields or another job.
struct ResultArrived {};
/// A study was read from the folder of a batch.
struct StudyRead {
  std::string folder;
};
/// A layout was not opened, because its mesh is missing.
struct MeshMissing {
  std::string layout, mesh;  ///< paths of both files
};
/// A recording could not be written and is retained, to be written elsewhere.
struct RecordingUnwritten {
  std::string why;
};

using HostEvent = std::variant<HostMessage, Opened, Reloaded, ModelBuilt, FrameArrived, ResultArrived, StudyRead,
                               MeshMissing, RecordingUnwritten>;
using HostEvents = std::vector<HostEvent>;

struct Host;

/// Sends a command of the user to the simulation. One about the scene is dropped if there is none.
void carry_out(const SimCommand& command, Host& host);

}  // namespace taxel::studio
