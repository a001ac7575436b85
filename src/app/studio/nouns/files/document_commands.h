// Commands that open, save and close documents, and unsaved documents and recordings that are kept for the next start.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "ui/scene/camera.h"

namespace taxel::ui {

enum class UnsavedAnswer { save, discard, cancel };
struct ShowOpenDialog {};
/// Asks for files by the desktop's own dialog, or by the window's.
struct ToggleDesktopDialog {};
struct OpenFile {
  std::string path;
  std::string mesh = {};  ///< file, for a layout of another program without a mesh
};
/// Opens an example that travels inside the program: the name of a row of studio::examples().
struct OpenExample {
  std::string name;
  bool operator==(const OpenExample&) const = default;
};
/// Opens a new layout without taxels, on the fingertip's mesh.
struct NewLayout {};
/// Writes the files of the examples, unless they are there, and opens the file dialog in their folder.
struct OpenExamples {};
struct CloseDocument {};
struct CancelLoading {};  ///< or polishing, whichever runs
struct ReloadFile {};
/// An empty path saves the document where it is, or asks for a file. `replace`: another file there may be lost.
struct SaveProject {
  std::string path = {};
  bool replace = false;
};
struct SaveAs {};  ///< asks for the file of the project, or of the scene if a scene is open
/// Saves the open scene with all its sensors declared. An empty path asks for the file.
struct SaveScene {
  std::string path = {};
  bool replace = false;
};
struct DialogClosed {};  ///< without a file
struct AnswerUnsaved {
  UnsavedAnswer answer = UnsavedAnswer::cancel;
};

void carry_out(const ShowOpenDialog& command, App& app);
void carry_out(const ToggleDesktopDialog& command, App& app);

struct AnswerRecovery {
  bool recover = false;  ///< otherwise the lost document is deleted
};

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::OpenFile& command, Host& host);
void carry_out(const ui::OpenExample& command, Host& host);
void carry_out(const ui::NewLayout& command, Host& host);
void carry_out(const ui::OpenExamples& command, Host& host);
void carry_out(const ui::CloseDocument& command, Host& host);
void carry_out(const ui::CancelLoading& command, Host& host);
void carry_out(const ui::ReloadFile& command, Host& host);
void carry_out(const ui::SaveProject& command, Host& host);
void carry_out(const ui::SaveAs& command, Host& host);
void carry_out(const ui::SaveScene& command, Host& host);
void carry_out(const ui::DialogClosed& command, Host& host);
void carry_out(const ui::AnswerUnsaved& command, Host& host);

/// Returns whether a file may be written. Asks the user before another file is overwritten, or the document's own file
/// after another program has changed it.
[[nodiscard]] bool may_write(Host& host, const std::string& path, ui::FileTask task, bool replace);
/// Asks whether to save if the command leaves a document with unsaved edits. Returns whether the command has to wait.
[[nodiscard]] bool hold_if_unsaved(Host& host, const ui::Command& command);

/// Returns the camera that is saved with the document, if there is one.
[[nodiscard]] std::optional<ui::Camera> camera_of_project(const Host& host);

void carry_out(const ui::AnswerRecovery& command, Host& host);

/// Begins to keep unsaved edits, and offers documents and recordings that an earlier program has left.
void start_autosave(Host& host);
/// Writes unsaved edits that are due.
void keep_unsaved(Host& host);
/// Writes unsaved edits for the next start when a signal ends the program.
void keep_unsaved_at_end(Host& host);

}  // namespace taxel::studio
