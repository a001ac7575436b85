// A scene that is open: what a hand sets in it, layouts on its geoms, and how it is saved.
#include <algorithm>
#include <utility>

#include "app/studio/run/session.h"

namespace taxel::studio {

void Session::send(SimCommand command) {
  const bool pauses = std::holds_alternative<LoadKeyframeCommand>(command);
  if (pauses) {
    replay_.stop();
    playing_ = held_ = false;
  }
  if (!frame_) return;
  const CommandId number = tell(std::move(command));
  if (pauses) play_command_ = number;
}

/// The document stays, and so do cameras and pause; the run begins anew.
void Session::build_with(std::vector<SceneAttachment> attachments) {
  Document document = *document_;
  build_scene(
      {.document = std::move(document), .attachments = std::move(attachments), .play = playing(), .framed = false});
}

void Session::attach(const std::vector<std::string>& geoms, const std::string& layout) {
  if (!document_ || document_->kind != DocumentKind::scene || pending_) return;
  std::vector<SceneAttachment> wanted = attached_;
  for (const std::string& geom : geoms) wanted.push_back({geom, layout});
  build_with(std::move(wanted));
}

void Session::detach(const std::string& geom) {
  if (!document_ || document_->kind != DocumentKind::scene || pending_) return;
  std::vector<SceneAttachment> rest = attached_;
  std::erase_if(rest, [&](const SceneAttachment& attached) { return attached.geom == geom; });
  build_with(std::move(rest));
}

/// What there is to show of a scene's document is what its sensors were compiled of.
void Session::take_sensors(const SimFrame& frame) {
  if (document_->kind != DocumentKind::scene) return;
  document_->model = frame.scene->sensors.empty() ? nullptr : frame.scene->sensors.front();
}

void Session::save_scene(const std::string& file) {
  tell(SaveSceneCommand{file});
}

void Session::tell_saved(const SceneSaved& saved, SessionNews& news) {
  if (saved.error.empty()) {
    news.saved_scene = saved.file;
    news.messages.emplace_back(Severity::note, "Saved " + saved.file);
  } else {
    news.messages.emplace_back(Severity::error, saved.error);
  }
}

}  // namespace taxel::studio
