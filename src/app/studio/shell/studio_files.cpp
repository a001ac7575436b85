// Saves and exports documents, and handles unsaved edits when the user leaves a document.
#include <fmt/format.h>

#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/document/project_files.h"
#include "app/studio/host/episodes/episode_document.h"
#include "app/studio/host/examples/example_files.h"
#include "app/studio/host/examples/examples.h"
#include "app/studio/host/examples/new_layout.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/file_dialog_tool.h"
#include "app/studio/nouns/files/file_listing.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/shell/state/settings.h"
#include "app/studio/shell/studio.h"
#include "core/base/error.h"
#include "core/base/text/shown_message.h"
#include "core/mesh/mesh_io.h"

namespace taxel::studio {

namespace {

/// Returns whether a command leaves the open document. A data set is opened next to the document.
bool leaves_document(const ui::Command& command) {
  if (const auto* file = std::get_if<ui::OpenFile>(&command)) return !data_set_folder(file->path);
  return std::holds_alternative<ui::OpenEpisode>(command) || std::holds_alternative<ui::OpenExample>(command) ||
         std::holds_alternative<ui::NewLayout>(command) || std::holds_alternative<ui::CloseDocument>(command) ||
         std::holds_alternative<ui::Quit>(command);
}

}  // namespace

/// Opens a file, or a data set in the panel of data sets. A layout without mesh is opened on the bare mesh that is
/// open, or waits for the next mesh.
void Studio::carry_out(const ui::OpenFile& file) {
  if (const auto folder = data_set_folder(file.path)) return read_data_set(folder->string());
  SkinChoice skin;
  skin.mesh = file.mesh;
  std::string path = file.path;
  if (!path.empty() && needs_mesh(path) && skin.mesh.empty()) {
    if (!session_.edits().is_open() || session_.kind() != DocumentKind::mesh) {
      files_.layout_without_mesh = path;
      ui::add_message(app_.get<ui::Messages>(), Severity::note,
                      path + ": holds no mesh: drop or open its mesh file as well", ImGui::GetTime(),
                      ui::Holds::while_mesh_missing);
      return;
    }
    skin.mesh = session_.file();
  } else if (!path.empty() && is_mesh_file(path) && !files_.layout_without_mesh.empty()) {
    skin.mesh = path;
    path = files_.layout_without_mesh;
  }
  files_.layout_without_mesh.clear();
  session_.open(path, skin);
}

/// Opens an example. The files of a scene are written first, where they can be looked at and changed.
void Studio::carry_out(const ui::OpenExample& example) {
  files_.layout_without_mesh.clear();
  if (!is_scene_example(example.name)) return session_.open(example.name);
  if (const auto folder = written_examples()) session_.open((*folder / scene_of_example(example.name)).string());
}

void Studio::carry_out(const ui::NewLayout&) {
  session_.open(std::string(kNewLayout));
  ui::add_message(app_.get<ui::Messages>(), Severity::note,
                  "New layout on the fingertip: Ctrl+click places a taxel, Ctrl+G generates a pattern. Drop a mesh for "
                  "a layout on another one.",
                  ImGui::GetTime());
}

/// Writes the example files below the folder of states and returns their folder, or nothing if that failed, which is
/// reported.
std::optional<std::filesystem::path> Studio::written_examples() {
  const std::filesystem::path own =
      options_.state_dir.empty() ? state_folder() : std::filesystem::path(options_.state_dir);
  try {
    write_examples(own / "examples");
  } catch (const Error& error) {
    ui::add_message(app_.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
    return std::nullopt;
  }
  return own / "examples";
}

void Studio::carry_out(const ui::OpenExamples&) {
  const auto folder = written_examples();
  if (!folder) return;
  ui::begin_dialog(app_.get<ui::FileDialog>(), ui::FileTask::open);
  list_folder(app_.get<ui::FileDialog>(), folder->string());
}

bool Studio::hold_if_unsaved(const ui::Command& command) {
  if (!leaves_document(command) || !session_.edits().dirty() || std::exchange(outcome_.discards_edits, false))
    return false;
  held_ = command;
  app_.get<ui::FilesState>().asks_unsaved = true;
  return true;
}

void Studio::carry_out(const ui::AnswerUnsaved& command) {
  app_.get<ui::FilesState>().asks_unsaved = false;
  if (!held_) return;
  if (command.answer == ui::UnsavedAnswer::save) {
    save_project("", false);
  } else if (command.answer == ui::UnsavedAnswer::discard) {
    outcome_.discards_edits = true;
    app_.ui->post(*std::exchange(held_, std::nullopt));
  } else {
    held_.reset();
  }
}

void Studio::carry_out(const ui::SaveAs&) {
  if (app_.shown->document.is_scene) return carry_out(ui::SaveScene{});
  ask_for_file(ui::FileTask::save_project, "");
}

/// Returns the document with the present camera.
Project Studio::project_to_save() const {
  Project project = *session_.edits().project();
  const ui::Camera& camera = app_.viewer->cameras[0];
  project.view = View{camera.target, camera.azimuth_deg, camera.elevation_deg, camera.distance, camera.fov_deg};
  return project;
}

std::optional<ui::Camera> Studio::camera_of_project() const {
  if (!session_.edits().is_open() || !session_.edits().project()->view) return std::nullopt;
  const View& view = *session_.edits().project()->view;
  ui::Camera camera;
  camera.target = view.target;
  camera.azimuth_deg = view.azimuth_deg;
  camera.elevation_deg = view.elevation_deg;
  camera.distance = view.distance;
  camera.fov_deg = view.fov_deg;
  return camera;
}

/// A problem is displayed by the window's own dialog.
void Studio::ask_for_file(ui::FileTask task, const std::string& problem) {
  const bool again = app_.get<ui::FileDialog>().task == task && !problem.empty();
  const std::string typed = app_.get<ui::FileDialog>().path;
  problem.empty() ? ui::begin_dialog(app_.get<ui::FileDialog>(), task)
                  : ui::begin_own_dialog(app_.get<ui::FileDialog>(), task);
  const bool folder = task == ui::FileTask::export_recording || task == ui::FileTask::keep_recording;
  const SuggestedFile suggested = suggested_file(session_.file(), app_.shown->document.name,
                                                 folder                               ? "-recording"
                                                 : task == ui::FileTask::export_video ? "-video.mp4"
                                                                                      : ui::extension_of(task));
  list_folder(app_.get<ui::FileDialog>(),
              suggested.folder.empty() || again ? app_.get<ui::FileDialog>().folder : suggested.folder);
  app_.get<ui::FileDialog>().path = again ? typed : suggested.name;
  app_.get<ui::FileDialog>().error = problem;
}

void Studio::update_desktop_dialog() {
  const ui::DesktopDialogStage stage{*app_.ui, app_.get<ui::FileDialog>(), app_.get<ui::Messages>(),
                                     app_.get<ui::FilesState>().notices, ImGui::GetTime()};
  if (files_.desktop_dialog.update(stage, app_.get<ui::ControlsState>().geoms))
    pacing_.request(FramePacing::kSettlingFrames);
}

/// Drops the command that waits until the document is saved, unless the user is being asked about it.
void Studio::carry_out(const ui::DialogClosed&) {
  if (!app_.get<ui::FilesState>().asks_unsaved) held_.reset();
}

/// Returns whether a file may be written. Asks the user before another file is overwritten, or the document's own file
/// after another program has changed it.
bool Studio::may_write(const std::string& path, ui::FileTask task, bool replace) {
  std::error_code ignored;
  const bool own = !session_.file().empty() && std::filesystem::equivalent(path, session_.file(), ignored);
  const bool changed = own && has_notice(session_.file());  // the file on disk is not the one that was opened
  if (replace || (own && !changed) || !std::filesystem::exists(path, ignored)) return true;
  const std::string name = std::filesystem::path(path).filename().string();
  ask_for_file(task,
               name + (changed ? " was changed by another program." : " exists.") + " The same again replaces it.");
  app_.get<ui::FileDialog>().path = path;
  app_.get<ui::FileDialog>().exists = path;
  return false;
}

void Studio::save_project(const std::string& path, bool replace) {
  if (!session_.edits().is_open()) return;
  const bool known = session_.kind() == DocumentKind::project;
  if (path.empty() && !known) return ask_for_file(ui::FileTask::save_project, "");
  const std::string file = path.empty() ? session_.file() : path;
  if (!may_write(file, ui::FileTask::save_project, replace)) return;
  try {
    const Project written = with_mesh_on_disk(project_to_save(), file, session_.edits().mesh());
    write_project(file, written);
    wrote(file, written);
  } catch (const Error& error) {
    ui::add_message(app_.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
    return ask_for_file(ui::FileTask::save_project, shown_message(error));
  }
  session_.saved_as(file);
  files_.hash = hash_of(file);
  remember_recent(app_.get<ui::FilesState>().recent, file);
  ui::add_message(app_.get<ui::Messages>(), Severity::note, "Saved " + file, ImGui::GetTime());
  if (held_) app_.ui->post(*std::exchange(held_, std::nullopt));
}

void Studio::carry_out(const ui::SaveScene& wanted) {
  if (session_.kind() != DocumentKind::scene || !session_.frame()) return;
  if (wanted.path.empty()) return ask_for_file(ui::FileTask::save_scene, "");
  std::error_code ignored;
  if (std::filesystem::equivalent(wanted.path, session_.file(), ignored))
    return ask_for_file(ui::FileTask::save_scene, "That is the scene that is open, which stays as it is.");
  if (may_write(wanted.path, ui::FileTask::save_scene, wanted.replace)) session_.save_scene(wanted.path);
}

void Studio::start_autosave() {
  const std::filesystem::path folder =
      options_.state_dir.empty() ? state_folder() : std::filesystem::path(options_.state_dir);
  try {
    files_.autosave.start(folder / "autosave");
    files_.lost = files_.autosave.lost();
    files_.recordings = left_recordings(folder / "recordings");
    session_.keep_recordings_in((folder / "recordings").string());
  } catch (const Error& error) {
    ui::add_message(app_.get<ui::Messages>(), Severity::warning, shown_message(error), 0);
  }
  offer_recovery();
}

void Studio::keep_unsaved_at_end() {
  const bool dirty = session_.edits().dirty();
  files_.autosave.leave(dirty ? session_.edits().project() : nullptr, app_.shown->document.name, session_.file());
}

void Studio::keep_unsaved() {
  if (!files_.autosave.started()) return;
  const bool dirty = session_.edits().dirty();
  const std::string failure =
      files_.autosave.update(dirty ? session_.edits().project() : nullptr, dirty ? session_.edits().revision() : 0,
                             app_.shown->document.name, session_.file(), steady_seconds());
  if (!failure.empty())
    ui::add_message(app_.get<ui::Messages>(), Severity::warning, "Edits are not kept: " + failure, ImGui::GetTime(),
                    ui::Holds::while_unkept);
}

void Studio::offer_recovery() {
  app_.get<ui::FilesState>().recovery.name.clear();
  if (files_.lost.empty()) return offer_recording();
  const LostDocument& lost = files_.lost.front();
  app_.get<ui::FilesState>().recovery.name = lost.name + " was edited and not saved when the program ended.";
  app_.get<ui::FilesState>().recovery.detail =
      fmt::format("Kept {}{}{}", lost.when, lost.origin.empty() ? "" : ", opened from ", lost.origin);
}

void Studio::offer_recording() {
  if (files_.recordings.empty()) return;
  const LeftRecording& left = files_.recordings.front();
  app_.get<ui::FilesState>().recovery.name =
      fmt::format("A recording of {} steps was not written when the program ended.", left.recording.rows.size());
  app_.get<ui::FilesState>().recovery.detail =
      fmt::format("{:.6g} s to {:.6g} s, to be written as {}", left.recording.rows.front().time,
                  left.recording.rows.back().time, left.target);
}

/// Writes or discards a recording that was left behind. If that fails, the recording is offered again at the next
/// start.
void Studio::answer_left_recording(bool recover) {
  if (files_.recordings.empty()) return;
  const LeftRecording left = std::move(files_.recordings.front());
  files_.recordings.erase(files_.recordings.begin());
  try {
    if (recover) {
      const std::string file = write_left_recording(left).string();
      ui::add_message(app_.get<ui::Messages>(), Severity::note,
                      fmt::format("Recorded {} steps in {}, without the scene", left.recording.rows.size(), file),
                      ImGui::GetTime());
    } else {
      discard_left_recording(left);
    }
  } catch (const Error& error) {
    ui::add_message(app_.get<ui::Messages>(), Severity::error,
                    fmt::format("{} (offered again at the next start)", shown_message(error)), ImGui::GetTime());
  }
}

void Studio::carry_out(const ui::AnswerRecovery& command) {
  if (files_.lost.empty()) {
    answer_left_recording(command.recover);
    return offer_recovery();
  }
  const LostDocument lost = files_.lost.front();
  files_.lost.erase(files_.lost.begin());
  if (command.recover) {
    files_.autosave.take_over(lost);
    session_.recover(lost);
  } else {
    Autosave::forget(lost);
  }
  offer_recovery();
}

}  // namespace taxel::studio
