#include "app/studio/nouns/scene/scene_commands.h"

#include <filesystem>
#include <utility>

#include "app/studio/host/document/documents.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/files/ask_for_file.h"
#include "app/studio/nouns/files/file_task.h"

namespace taxel::studio {

namespace {

/// The document, the cameras and pause stay, and another run begins.
void build_with(Host& host, std::vector<SceneAttachment> attachments) {
  host.run.build({.document = *host.document.opened(),
                  .attachments = std::move(attachments),
                  .lead = host.run.scene().lead,
                  .plays = host.run.playing(),
                  .turns_cameras = false});
}

void attach(Host& host, const std::vector<std::string>& geoms, const std::string& layout) {
  if (!host.document.opened() || host.document.kind() != DocumentKind::scene || host.run.pending()) return;
  std::vector<SceneAttachment> attachments = host.run.scene().attached;
  for (const std::string& geom : geoms) attachments.push_back({geom, layout});
  build_with(host, std::move(attachments));
}

void detach(Host& host, const std::string& geom) {
  if (!host.document.opened() || host.document.kind() != DocumentKind::scene || host.run.pending()) return;
  std::vector<SceneAttachment> attachments = host.run.scene().attached;
  std::erase_if(attachments, [&](const SceneAttachment& attached) { return attached.geom == geom; });
  build_with(host, std::move(attachments));
}

}  // namespace

void carry_out(const ui::AttachLayout& command, Host& host) {
  command.path.empty() ? ask_for_file(host.app, ui::FileTask::attach_layout, "")
                       : attach(host, command.geoms, command.path);
}

void carry_out(const ui::DetachLayout& command, Host& host) {
  detach(host, command.geom);
}

}  // namespace taxel::studio
