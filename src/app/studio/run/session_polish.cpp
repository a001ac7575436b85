// A preview's samples become polished ones, or stay as they are.
#include <utility>

#include "app/studio/run/session.h"

namespace taxel::studio {

void Session::polish() {
  if (loader_.busy() || polished_ || !document_ || !document_->previewed()) return;
  preview_pictures_ = 0;
  loader_.polish(*document_);
}

/// Another document was to be loaded while the samples of this one were polished; it stays after all.
void Session::resume_polishing() {
  if (document_ && document_->model != left_preview_) polish();
}

void Session::keep_preview(Severity severity, const std::string& why, SessionNews& news) {
  news.messages.emplace_back(severity, why);
  const Document* shown = pending_ ? &pending_->document : document_ ? &*document_ : nullptr;
  if (shown == nullptr || !shown->model) return;
  left_preview_ = shown->model;
  for (const std::string& note : notes_of_samples(*shown->model)) news.messages.emplace_back(Severity::warning, note);
}

void Session::finish_polished(SessionNews& news) {
  const Polished models = std::exchange(polished_, std::nullopt)->models;
  if (!document_ || document_->model != models.preview) return;  // what they belong to was refused, or closed
  document_->model = models.model;
  for (const std::string& note : notes_of_samples(*document_->model))
    news.messages.emplace_back(Severity::warning, note);
}

}  // namespace taxel::studio
