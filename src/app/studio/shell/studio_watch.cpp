// Reports changes that other programs make to open files, and offers remedies.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/host/document/documents.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/shell/comparison.h"
#include "app/studio/shell/studio.h"
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

}  // namespace

/// Shows a notice, which stays in view until the user answers it, and adds it to the list of messages.
void Studio::add_notice(ui::FileNotice notice) {
  drop_notice(notice.file);
  ui::add_message(app_.get<ui::Messages>(), Severity::warning, notice.text, ImGui::GetTime());
  app_.get<ui::Messages>().back().toast = false;
  app_.get<ui::FilesState>().notices.push_back(std::move(notice));
}

/// Takes back the notice about a file, if there is one: the file is as it was read, or the notice is answered.
void Studio::drop_notice(const std::string& file) {
  std::erase_if(app_.get<ui::FilesState>().notices, [&](const ui::FileNotice& notice) { return notice.file == file; });
}

bool Studio::has_notice(const std::string& file) const {
  return std::any_of(app_.get<ui::FilesState>().notices.begin(), app_.get<ui::FilesState>().notices.end(),
                     [&](const ui::FileNotice& notice) { return notice.file == file; });
}

void Studio::watch_files() {
  std::vector<std::string> files;
  if (!session_.file().empty() && session_.kind() != DocumentKind::mesh) files.push_back(session_.file());
  for (const SceneAttachment& attached : app_.shown->run.attached) files.push_back(attached.layout);
  if (session_.kind() == DocumentKind::scene && app_.shown->run.frame) {
    const std::vector<std::string>& sources = app_.shown->run.frame->simulated->files;
    std::copy_if(sources.begin(), sources.end(), std::back_inserter(files), [&](const std::string& source) {
      return std::find(files.begin(), files.end(), source) == files.end();
    });
  }
  if (session_.edits().is_open()) {
    const std::string& mesh = session_.edits().project()->layout.mesh.file;
    if (mesh != built_in_mesh().name) files.push_back(mesh);
  }
  // The document may be its own second layout.
  const std::string second = ui::second_layout_file(app_);
  if (!second.empty() && std::find(files.begin(), files.end(), second) == files.end()) files.push_back(second);
  files_.watch.watch(files);
  std::erase_if(app_.get<ui::FilesState>().notices, [&](const ui::FileNotice& notice) {
    return std::find(files.begin(), files.end(), notice.file) == files.end();
  });
  for (const auto& [file, change] : files_.watch.look(timing_.clock->now())) tell_change(file, change);
  timing_.executor->run_posted();
  if (std::optional<ComparedMesh> compared = files_.comparison.take()) tell_mesh(std::move(*compared));
}

void Studio::tell_change(const std::string& file, FileChange change) {
  const bool scene = session_.kind() == DocumentKind::scene;
  const bool document = file == session_.file() && session_.kind() != DocumentKind::mesh;
  if (file == ui::second_layout_file(app_)) {
    tell_second_layout(change);
    if (!document && !scene) return;
  }
  const std::string which =
      name_of(file) + (scene && !document ? fmt::format(", which {} uses,", name_of(session_.file())) : "");
  if (change == FileChange::changed && !document && !scene)
    return files_.comparison.start(session_.edits().project()->layout);
  if (change == FileChange::deleted) {
    if (document && session_.edits().is_open()) session_.edits().mark_unsaved();
    const char* const rest = scene      ? "The scene stays open as it was read."
                             : document ? "Nothing is lost: saving writes it again."
                                        : "It stays open; saving or exporting writes it next to the new file.";
    return add_notice({file, fmt::format("{} was deleted or moved. {}", which, rest), {}});
  }
  if (document && hash_of(file) == files_.hash) return drop_notice(file);  // only its time changed, or it is back
  const char* const rest = scene ? "Reading it again restarts its run; the view and attached layouts stay."
                                 : "Reading it again is a step that undo takes back.";
  add_notice({file, fmt::format("{} was changed by another program. {}", which, rest), {ui::FileOffer::reload}});
}

void Studio::tell_mesh(ComparedMesh compared) {
  const OpenMeshPtr open = session_.edits().mesh();
  const std::string& file = compared.ref.file;
  if (!session_.edits().is_open() || !open || session_.edits().project()->layout.mesh.file != file) return;
  if (!compared.mesh)
    return add_notice({file,
                       fmt::format("{} was changed and cannot be read now: {}. The mesh that was read stays open.",
                                   name_of(file), compared.problem),
                       {}});
  if (compared.mesh->loaded.sha256 == open->loaded.sha256) return drop_notice(file);
  add_notice({file,
              fmt::format("{} was replaced by another mesh: {} triangles, {} before.{}", name_of(file),
                          ui::grouped(compared.mesh->loaded.mesh->face_count()),
                          ui::grouped(open->loaded.mesh->face_count()), distances_sentence(compared)),
              offers_for(compared)});
  files_.offered_mesh = std::move(compared);
}

/// Reports if the opened document was made on a different mesh than the one in its mesh file.
void Studio::tell_other_mesh() {
  if (!session_.edits().is_open() || !app_.shown->document.model) return;
  const Layout& layout = session_.edits().project()->layout;
  const OpenMeshPtr mesh = session_.edits().mesh();
  if (!mesh || layout.mesh.sha256.empty() || layout.mesh.sha256 == mesh->loaded.sha256) return;
  ComparedMesh compared{layout.mesh, mesh, app_.shown->document.model->skin,
                        distances_to(*app_.shown->document.model->skin, layout), ""};
  compared.ref.sha256 = mesh->loaded.sha256;
  add_notice({layout.mesh.file,
              fmt::format("{} is not the mesh that this layout was made on: its hash differs.{}",
                          name_of(layout.mesh.file), distances_sentence(compared)),
              offers_for(compared)});
  files_.offered_mesh = std::move(compared);
}

void Studio::carry_out(const ui::AnswerNotice& answer) {
  if (!has_notice(answer.file)) return;
  drop_notice(answer.file);
  if (!answer.taken) return;
  if (*answer.taken == ui::FileOffer::reload) return session_.reload();
  const std::optional<ComparedMesh> compared = std::exchange(files_.offered_mesh, std::nullopt);
  if (!compared || compared->ref.file != answer.file) return;
  edit_document([&](EditSession& edits) {
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

/// Registers a file that this program wrote, so that no change is reported for it. Adds a message if its mesh was
/// written too.
void Studio::wrote(const std::string& file, const Project& written) {
  files_.watch.accept(file);
  if (file == ui::second_layout_file(app_)) ui::reread_second_layout(app_);
  if (file == session_.file()) files_.hash = hash_of(file);
  drop_notice(file);
  const std::string& open = session_.edits().project()->layout.mesh.file;
  if (written.layout.mesh.file == open || open == built_in_mesh().name) return;
  ui::add_message(app_.get<ui::Messages>(), Severity::note,
                  fmt::format("{} is gone: its mesh was written to {}", open, written.layout.mesh.file),
                  ImGui::GetTime());
}

}  // namespace taxel::studio
