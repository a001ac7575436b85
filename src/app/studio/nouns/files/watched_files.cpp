#include "app/studio/nouns/files/watched_files.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "app/studio/frame/message_list.h"
#include "app/studio/host/document/documents.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/compare/compare_state.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "core/base/error.h"
#include "ui/widgets/format.h"

namespace taxel::studio {

namespace {

std::string name_of(const std::string& file) {
  return std::filesystem::path(file).filename().string();
}

std::vector<ui::FileOffer> offers_for(const ComparedMesh& compared) {
  if (compared.distances.taxels == 0) return {ui::FileOffer::use_mesh};
  return {ui::FileOffer::use_mesh, ui::FileOffer::project_back};
}

/// Returns a sentence about the distances, or an empty text.
std::string distances_sentence(const ComparedMesh& compared) {
  const std::string text = distances_text(compared.distances);
  return text.empty() ? "" : " " + text + ".";
}

/// Takes back the notice about a file, if there is one: the file is as it was read, or the notice is answered.
void drop_notice(Host& host, const std::string& file) {
  std::erase_if(host.app.get<ui::FilesState>().notices,
                [&](const ui::FileNotice& notice) { return notice.file == file; });
}

/// Returns whether a notice offers to look for a missing mesh.
bool is_about_missing_mesh(const ui::FileNotice& notice) {
  return notice.offers == std::vector{ui::FileOffer::locate};
}

/// Shows a notice, which stays in view until the user answers it, and adds it to the list of messages.
void add_notice(Host& host, ui::FileNotice notice) {
  drop_notice(host, notice.file);
  ui::add_message(host.app.get<ui::Messages>(), Severity::warning, notice.text, ImGui::GetTime());
  host.app.get<ui::Messages>().back().toast = false;
  host.app.get<ui::FilesState>().notices.push_back(std::move(notice));
}

void tell_mesh(Host& host, ComparedMesh compared) {
  const OpenMeshPtr open = host.edits().mesh();
  const std::string& file = compared.ref.file;
  if (!host.edits().is_open() || !open || host.edits().project()->layout.mesh.file != file) return;
  if (!compared.mesh)
    return add_notice(host,
                      {file,
                       fmt::format("{} was changed and cannot be read now: {}. The mesh that was read stays open.",
                                   name_of(file), compared.problem),
                       {}});
  if (compared.mesh->loaded.sha256 == open->loaded.sha256) return drop_notice(host, file);
  add_notice(host, {file,
                    fmt::format("{} was replaced by another mesh: {} triangles, {} before.{}", name_of(file),
                                ui::grouped(compared.mesh->loaded.mesh->face_count()),
                                ui::grouped(open->loaded.mesh->face_count()), distances_sentence(compared)),
                    offers_for(compared)});
  host.files.offered_mesh = std::move(compared);
}

void tell_change(Host& host, const std::string& file, FileChange change) {
  const bool scene = host.document.kind() == DocumentKind::scene;
  const bool document = file == host.document.file() && host.document.kind() != DocumentKind::mesh;
  if (file == ui::second_layout_file(host.app)) {
    tell_second_layout(host, change);
    if (!document && !scene) return;
  }
  const std::string which =
      name_of(file) + (scene && !document ? fmt::format(", which {} uses,", name_of(host.document.file())) : "");
  if (change == FileChange::changed && !document && !scene)
    return host.files.comparison.start(host.edits().project()->layout);
  if (change == FileChange::deleted) {
    if (document && !scene && host.edits().is_open()) host.edits().mark_unsaved();
    const char* const rest = scene      ? "The scene stays open as it was read."
                             : document ? "Nothing is lost: saving writes it again."
                                        : "It stays open; saving or exporting writes it next to the new file.";
    return add_notice(host, {file, fmt::format("{} was deleted or moved. {}", which, rest), {}});
  }
  if (document && hash_of(file) == host.files.hash)
    return drop_notice(host, file);  // only its time changed, or it is back
  const char* const rest = scene ? "Reading it again restarts its run; the view and attached layouts stay."
                                 : "Reading it again is a step that undo takes back.";
  add_notice(host, {file, fmt::format("{} was changed by another program. {}", which, rest), {ui::FileOffer::reload}});
}

}  // namespace

bool has_notice(const Host& host, const std::string& file) {
  return std::any_of(host.app.get<ui::FilesState>().notices.begin(), host.app.get<ui::FilesState>().notices.end(),
                     [&](const ui::FileNotice& notice) { return notice.file == file; });
}

void watch_files(Host& host, double now) {
  std::vector<std::string> files;
  if (!host.document.file().empty() && host.document.kind() != DocumentKind::mesh)
    files.push_back(host.document.file());
  for (const SceneAttachment& attached : host.app.shown->run.attached) files.push_back(attached.layout);
  if (host.document.kind() == DocumentKind::scene && host.app.shown->run.frame) {
    const std::vector<std::string>& sources = host.app.shown->run.frame->simulated->files;
    std::copy_if(sources.begin(), sources.end(), std::back_inserter(files), [&](const std::string& source) {
      return std::find(files.begin(), files.end(), source) == files.end();
    });
  }
  if (host.edits().is_open()) {
    const std::string& mesh = host.edits().project()->layout.mesh.file;
    if (mesh != built_in_mesh().name) files.push_back(mesh);
  }
  // The document may be its own second layout.
  const std::string second = ui::second_layout_file(host.app);
  if (!second.empty() && std::find(files.begin(), files.end(), second) == files.end()) files.push_back(second);
  host.files.watch.watch(files);
  const bool waits_for_mesh = !host.app.get<ui::FilesState>().layout_without_mesh.empty();
  std::erase_if(host.app.get<ui::FilesState>().notices, [&](const ui::FileNotice& notice) {
    if (is_about_missing_mesh(notice)) return !waits_for_mesh;
    return std::find(files.begin(), files.end(), notice.file) == files.end();
  });
  for (const auto& [file, change] : host.files.watch.look(now)) tell_change(host, file, change);
  host.executor.run_posted();
  if (std::optional<ComparedMesh> compared = host.files.comparison.take()) tell_mesh(host, std::move(*compared));
}

/// Reports if the opened document was made on a different mesh than the one in its mesh file.
void tell_other_mesh(Host& host) {
  if (!host.edits().is_open() || !host.app.shown->document.model) return;
  const Layout& layout = host.edits().project()->layout;
  const OpenMeshPtr mesh = host.edits().mesh();
  if (!mesh || layout.mesh.sha256.empty() || layout.mesh.sha256 == mesh->loaded.sha256) return;
  ComparedMesh compared{layout.mesh, mesh, host.app.shown->document.model->skin,
                        distances_to(*host.app.shown->document.model->skin, layout), ""};
  compared.ref.sha256 = mesh->loaded.sha256;
  add_notice(host, {layout.mesh.file,
                    fmt::format("{} is not the mesh that this layout was made on: its hash differs.{}",
                                name_of(layout.mesh.file), distances_sentence(compared)),
                    offers_for(compared)});
  host.files.offered_mesh = std::move(compared);
}

void offer_to_locate(Host& host, const std::string& layout, const std::string& mesh) {
  ui::FilesState& files = host.app.get<ui::FilesState>();
  files.layout_without_mesh = layout;
  std::erase_if(files.notices, [](const ui::FileNotice& notice) { return is_about_missing_mesh(notice); });
  files.notices.push_back(
      {mesh,
       fmt::format("{} asks for the mesh {}, which is not in {}. Locate it, or drop it here.", name_of(layout),
                   name_of(mesh), std::filesystem::path(mesh).parent_path().string()),
       {ui::FileOffer::locate}});
}

/// Registers a file that this program wrote, so that no change is reported for it. Adds a message if its mesh was
/// written too.
void wrote(Host& host, const std::string& file, const Project& written) {
  host.files.watch.accept(file);
  if (file == ui::second_layout_file(host.app)) ui::reread_second_layout(host.app);
  if (file == host.document.file()) host.files.hash = hash_of(file);
  drop_notice(host, file);
  const std::string& open = host.edits().project()->layout.mesh.file;
  if (written.layout.mesh.file == open || open == built_in_mesh().name) return;
  ui::add_message(host.app.get<ui::Messages>(), Severity::note,
                  fmt::format("{} is gone: its mesh was written to {}", open, written.layout.mesh.file),
                  ImGui::GetTime());
}

void carry_out(const ui::AnswerNotice& answer, Host& host) {
  if (!has_notice(host, answer.file)) return;
  const std::vector<ui::FileNotice>& notices = host.app.get<ui::FilesState>().notices;
  const bool leaves_mesh = !answer.taken && std::ranges::any_of(notices, [&](const ui::FileNotice& notice) {
    return notice.file == answer.file && is_about_missing_mesh(notice);
  });
  if (leaves_mesh) host.app.get<ui::FilesState>().layout_without_mesh.clear();
  drop_notice(host, answer.file);
  if (!answer.taken) return;
  if (*answer.taken == ui::FileOffer::locate)
    return ask_for_file(host.app, ui::FileTask::open,
                        "The mesh of " + host.app.get<ui::FilesState>().layout_without_mesh);
  if (*answer.taken == ui::FileOffer::reload) return host.document.reload();
  const std::optional<ComparedMesh> compared = std::exchange(host.files.offered_mesh, std::nullopt);
  if (!compared || compared->ref.file != answer.file) return;
  edit_document(host, [&](EditSession& edits) {
    std::vector<Edit> steps;
    if (*answer.taken == ui::FileOffer::project_back)
      steps.emplace_back(projected_onto(*compared->skin, edits.project()->layout));
    const bool same = compared->mesh == edits.mesh();
    edits.add_mesh(compared->ref, compared->mesh);
    steps.emplace_back(
        ReplaceMesh{compared->ref, same ? *edits.project()->layout.sampling.region : std::vector<int>{}});
    edits.edit_together(steps);
  });
}

}  // namespace taxel::studio
