// The recorded steps, read by other models.
#include "app/studio/run/session.h"

namespace taxel::studio {

/// Not by clock some steps are read in each picture, until all are.
void Session::take_models(SessionNews& news) {
  const bool runs = frame_ && (by_clock_ ? frame_->playing : playing_ && !frame_->finished);
  if (const std::optional<RecallCommand> next = models_.follow(frame_, runs)) tell(*next);
  if (!by_clock_) models_.wait();
  ui::ComparedPtr newest = models_.newest();
  if (newest == compared_) return;
  compared_ = std::move(newest);
  news.new_reading = true;
}

}  // namespace taxel::studio
