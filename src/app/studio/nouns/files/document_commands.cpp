#include "app/studio/nouns/files/document_commands.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/document/document_files.h"
#include "app/studio/host/document/documents.h"
#include "app/studio/host/examples.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/files/watched_files.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/scene/scene_layouts.h"
#include "app/studio/nouns/study/study_state.h"
#include "core/base/error.h"
#include "core/base/math.h"
#include "core/base/text/message.h"
#include "core/mesh/mesh_io.h"

namespace taxel::ui {

void carry_out(const ToggleDesktopDialog&, App& app) {
  app.get<FileDialog>().prefers_desktop = !app.get<FileDialog>().prefers_desktop;
}

void carry_out(const ShowOpenDialog&, App& app) {
  open_dialog(*app.ui, app.get<FileDialog>());
}

}  // namespace taxel::ui

namespace taxel::studio {
namespace {

/// Returns whether a command leaves the open document. A study is opened next to the document.
bool leaves_document(const ui::Command& command) {
  if (const auto* file = command.get_if<ui::OpenFile>()) return !batch_folder(file->path);
  return command.is<ui::OpenExample>() || command.is<ui::NewLayout>() || command.is<ui::CloseDocument>() ||
         command.is<ui::Quit>();
}

/// Returns the document with the present camera.
Project project_to_save(const Host& host) {
  Project project = *host.edits().project();
  const ui::Camera& camera = host.app.viewer->cameras[0];
  project.view = View{camera.target, camera.azimuth_deg, camera.elevation_deg, camera.distance, camera.fov_deg};
  return project;
}

/// Writes the example files below the folder of states and returns their folder, or nothing if that failed, which is
/// reported.
std::optional<std::filesystem::path> written_examples(Host& host) {
  const std::filesystem::path& own = host.files.kept_in;
  try {
    write_examples(own / "examples");
  } catch (const Error& error) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
    return std::nullopt;
  }
  return own / "examples";
}

}  // namespace

/// Returns whether a file may be written. Asks the user before another file is overwritten, or the document's own file
/// after another program has changed it.
bool may_write(Host& host, const std::string& path, ui::FileTask task, bool replace) {
  std::error_code ignored;
  const bool own = !host.document.file().empty() && std::filesystem::equivalent(path, host.document.file(), ignored);
  const bool changed =
      own && has_notice(host, host.document.file());  // the file on disk is not the one that was opened
  if (replace || (own && !changed) || !std::filesystem::exists(path, ignored)) return true;
  const std::string name = std::filesystem::path(path).filename().string();
  ask_for_file(host.app, task,
               name + (changed ? " was changed by another program." : " exists.") + " The same again replaces it.");
  host.app.get<ui::FileDialog>().path = path;
  host.app.get<ui::FileDialog>().exists = path;
  return false;
}

void carry_out_held(Host& host) {
  if (host.app.get<ui::FilesState>().held)
    host.app.ui->post(*std::exchange(host.app.get<ui::FilesState>().held, std::nullopt));
}

/// Saves the edited layout of a scene. A scene that declares the layout with another number of taxels is read again.
void save_layout_in_scene(Host& host) {
  const bool was_text = host.document.scene_layout->is_text;
  if (was_text && !host.edits().dirty()) return carry_out_held(host);  // the text of the scene stays
  if (!save_scene_layout(host) || !host.run.frame) return;
  const std::vector<std::string>& geoms = host.document.scene_layout->geoms;
  const std::size_t taxels = host.edits().project()->layout.taxels.size();
  const SimScene& scene = *host.run.frame->simulated;
  const bool any_declared = std::any_of(geoms.begin(), geoms.end(), [&](const std::string& geom) {
    return is_declared(host.run, geom) && scene.sensors[at(ui::sensor_on(scene, geom))]->layout.taxels.size() != taxels;
  });
  if (any_declared && !was_text && !host.app.get<ui::FilesState>().held) host.document.reload();
  carry_out_held(host);
}

void save_project(Host& host, const std::string& path, bool replace) {
  if (!host.edits().is_open()) return;
  if (host.document.kind() == DocumentKind::scene) return save_layout_in_scene(host);
  const bool is_project = host.document.kind() == DocumentKind::project;
  if (path.empty() && !is_project) return ask_for_file(host.app, ui::FileTask::save_project, "");
  const std::string file = path.empty() ? host.document.file() : path;
  if (!may_write(host, file, ui::FileTask::save_project, replace)) return;
  try {
    const Project written = with_mesh_on_disk(project_to_save(host), file, host.edits().mesh());
    write_project(file, written);
    wrote(host, file, written);
  } catch (const Error& error) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
    return ask_for_file(host.app, ui::FileTask::save_project, shown_message(error));
  }
  host.document.saved_as(file);
  host.files.hash = hash_of(file);
  ui::remember_recent(host.app.get<ui::FilesState>().recent, file);
  ui::add_message(host.app.get<ui::Messages>(), Severity::note, "Saved " + file, ImGui::GetTime());
  carry_out_held(host);
}

bool hold_if_unsaved(Host& host, const ui::Command& command) {
  if (!(leaves_document(command) || leaves_scene_layout(command, host)) || !host.edits().dirty() ||
      std::exchange(host.app.get<ui::FilesState>().discards_edits, false))
    return false;
  host.app.get<ui::FilesState>().held = command;
  host.app.get<ui::FilesState>().asks_unsaved = true;
  return true;
}

std::optional<ui::Camera> camera_of_project(const Host& host) {
  if (!host.edits().is_open() || !host.edits().project()->view) return std::nullopt;
  const View& view = *host.edits().project()->view;
  ui::Camera camera;
  camera.target = view.target;
  camera.azimuth_deg = view.azimuth_deg;
  camera.elevation_deg = view.elevation_deg;
  camera.distance = view.distance;
  camera.fov_deg = view.fov_deg;
  return camera;
}

/// Opens a file, or a study in the panel of studies. A layout without mesh is opened on the bare mesh that is open, or
/// waits for the next mesh.
void carry_out(const ui::OpenFile& file, Host& host) {
  if (batch_folder(file.path)) return carry_out(ui::OpenStudy{file.path}, host);
  if (const std::string why_not = file.path.empty() ? "" : why_not_opened(file.path); !why_not.empty())
    return host.report(Severity::error, file.path + ": " + why_not);
  SkinChoice skin;
  skin.mesh = file.mesh;
  std::string path = file.path;
  if (!path.empty() && needs_mesh(path) && skin.mesh.empty()) {
    if (!host.edits().is_open() || host.document.kind() != DocumentKind::mesh) {
      host.app.get<ui::FilesState>().layout_without_mesh = path;
      ui::add_message(host.app.get<ui::Messages>(), Severity::note,
                      path + ": holds no mesh: drop or open its mesh file as well", ImGui::GetTime(),
                      ui::Holds::while_mesh_missing);
      return;
    }
    skin.mesh = host.document.file();
  } else if (!path.empty() && is_mesh_file(path) && !host.app.get<ui::FilesState>().layout_without_mesh.empty()) {
    skin.mesh = path;
    path = host.app.get<ui::FilesState>().layout_without_mesh;
  }
  host.app.get<ui::FilesState>().layout_without_mesh.clear();
  host.document.open(path, skin);
}

/// Opens an example. The files of a scene are written first, where they can be looked at and changed.
void carry_out(const ui::OpenExample& example, Host& host) {
  host.app.get<ui::FilesState>().layout_without_mesh.clear();
  if (!is_scene_example(example.name)) return host.document.open(example.name);
  if (const auto folder = written_examples(host))
    host.document.open((*folder / scene_of_example(example.name)).string());
}

void carry_out(const ui::NewLayout&, Host& host) {
  host.document.open(std::string(kNewLayout));
  ui::add_message(host.app.get<ui::Messages>(), Severity::note,
                  "New layout on the fingertip: Ctrl+click places a taxel, Ctrl+G generates a pattern. Drop a mesh for "
                  "a layout on another one.",
                  ImGui::GetTime());
}

void carry_out(const ui::OpenExamples&, Host& host) {
  const auto folder = written_examples(host);
  if (!folder) return;
  ui::begin_dialog(host.app.get<ui::FileDialog>(), ui::FileTask::open);
  list_folder(host.app.get<ui::FileDialog>(), folder->string());
}

void carry_out(const ui::CloseDocument&, Host& host) {
  host.document.close();
  host.handover.clear();
  drop_scene(host);
  host.app.viewer->selection = {};
}

void carry_out(const ui::CancelLoading&, Host& host) {
  host.document.loader.cancel();
}

void carry_out(const ui::ReloadFile&, Host& host) {
  host.document.reload();
}

void carry_out(const ui::SaveProject& command, Host& host) {
  save_project(host, command.path, command.replace);
}

void carry_out(const ui::SaveScene& wanted, Host& host) {
  if (host.document.kind() != DocumentKind::scene || !host.run.frame) return;
  if (wanted.path.empty()) return ask_for_file(host.app, ui::FileTask::save_scene, "");
  std::error_code ignored;
  if (std::filesystem::equivalent(wanted.path, host.document.file(), ignored))
    return ask_for_file(host.app, ui::FileTask::save_scene, "That is the scene that is open, which stays as it is.");
  if (!may_write(host, wanted.path, ui::FileTask::save_scene, wanted.replace)) return;
  const bool has_layout = host.document.scene_layout && !host.edits().project()->layout.taxels.empty();
  // The scene that is open stays as it is, with the layouts that its file declares.
  const bool is_unsaved =
      has_layout && !edits_declared_layout(host) && (host.edits().dirty() || !host.document.scene_layout->is_written);
  if (is_unsaved && !save_scene_layout(host)) return;
  if (has_layout) host.handover.request();
  host.files.scene_to_save = wanted.path;
}

void carry_out(const ui::SaveAs&, Host& host) {
  if (host.app.shown->document.is_scene) return carry_out(ui::SaveScene{}, host);
  ask_for_file(host.app, ui::FileTask::save_project, "");
}

/// Drops the command that waits until the document is saved, unless the user is being asked about it.
void carry_out(const ui::DialogClosed&, Host& host) {
  if (!host.app.get<ui::FilesState>().asks_unsaved) host.app.get<ui::FilesState>().held.reset();
}

void carry_out(const ui::AnswerUnsaved& command, Host& host) {
  host.app.get<ui::FilesState>().asks_unsaved = false;
  if (!host.app.get<ui::FilesState>().held) return;
  if (command.answer == ui::UnsavedAnswer::save) {
    save_project(host, "", false);
  } else if (command.answer == ui::UnsavedAnswer::discard) {
    host.app.get<ui::FilesState>().discards_edits = true;
    host.app.ui->post(*std::exchange(host.app.get<ui::FilesState>().held, std::nullopt));
  } else {
    host.app.get<ui::FilesState>().held.reset();
  }
}

}  // namespace taxel::studio

namespace taxel::studio {

void offer_recording(Host& host) {
  if (host.files.recordings.empty()) return;
  const LeftRecording& left = host.files.recordings.front();
  host.app.get<ui::FilesState>().recovery.name =
      fmt::format("A recording of {} steps was not written when the program ended.", left.recording.rows.size());
  host.app.get<ui::FilesState>().recovery.detail =
      fmt::format("{:.6g} s to {:.6g} s, to be written as {}", left.recording.rows.front().time,
                  left.recording.rows.back().time, left.target);
}

void offer_recovery(Host& host) {
  host.app.get<ui::FilesState>().recovery.name.clear();
  if (host.files.lost.empty()) return offer_recording(host);
  const LostDocument& lost = host.files.lost.front();
  host.app.get<ui::FilesState>().recovery.name = lost.name + " was edited and not saved when the program ended.";
  host.app.get<ui::FilesState>().recovery.detail =
      fmt::format("Kept {}{}{}", lost.when, lost.origin.empty() ? "" : ", opened from ", lost.origin);
}

/// Writes or discards a recording that was left behind. If that fails, the recording is offered again at the next
/// start.
void answer_left_recording(Host& host, bool recover) {
  if (host.files.recordings.empty()) return;
  const LeftRecording left = std::move(host.files.recordings.front());
  host.files.recordings.erase(host.files.recordings.begin());
  try {
    if (recover) {
      const std::string file = write_left_recording(left).string();
      ui::add_message(host.app.get<ui::Messages>(), Severity::note,
                      fmt::format("Recorded {} steps in {}, without the scene", left.recording.rows.size(), file),
                      ImGui::GetTime());
    } else {
      discard_left_recording(left);
    }
  } catch (const Error& error) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::error,
                    fmt::format("{} (offered again at the next start)", shown_message(error)), ImGui::GetTime());
  }
}

void start_autosave(Host& host) {
  const std::filesystem::path& folder = host.files.kept_in;
  try {
    host.files.autosave.start(folder / "autosave");
    host.files.lost = host.files.autosave.lost();
    host.files.recordings = left_recordings(folder / "recordings");
    host.run.simulation->set_journal_folder((folder / "recordings").string());
  } catch (const Error& error) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::warning, shown_message(error), 0);
  }
  offer_recovery(host);
}

namespace {

/// Returns the file that edits belong to; empty if it was not written yet.
std::string origin_of_edits(const Host& host) {
  const std::optional<ui::SceneLayout>& layout = host.document.scene_layout;
  return !layout ? host.document.file() : layout->is_written ? layout->file : "";
}

}  // namespace

void keep_unsaved(Host& host) {
  if (!host.files.autosave.started()) return;
  const bool dirty = host.edits().dirty();
  const std::string failure = host.files.autosave.update(
      dirty ? host.edits().project() : nullptr, dirty ? host.edits().revision() : 0, host.app.shown->document.name,
      origin_of_edits(host), steady_seconds(), host.edits().mesh());
  if (!failure.empty())
    ui::add_message(host.app.get<ui::Messages>(), Severity::warning, "Edits are not kept: " + failure, ImGui::GetTime(),
                    ui::Holds::while_unkept);
}

void keep_unsaved_at_end(Host& host) {
  const bool dirty = host.edits().dirty();
  host.files.autosave.leave(dirty ? host.edits().project() : nullptr, host.app.shown->document.name,
                            origin_of_edits(host), host.edits().mesh());
}

void carry_out(const ui::AnswerRecovery& command, Host& host) {
  if (host.files.lost.empty()) {
    answer_left_recording(host, command.recover);
    return offer_recovery(host);
  }
  const LostDocument lost = host.files.lost.front();
  host.files.lost.erase(host.files.lost.begin());
  if (command.recover) {
    host.files.autosave.take_over(lost);
    host.document.recover(lost);
  } else {
    Autosave::forget(lost);
  }
  offer_recovery(host);
}

}  // namespace taxel::studio
