// The recorded steps, read by other models.
#include "app/studio/run/session.h"

namespace taxel::studio {

/// Not by clock some steps are read in each picture, until all are.
void Session::take_models(SessionNews& news) {
  const bool runs = frame_ && (by_clock_ ? frame_->playing : playing_ && !frame_->finished);
  if (const std::optional<RecallCommand> next = jobs_.models.follow(frame_, runs)) tell(*next);
  if (!by_clock_) jobs_.models.wait();
  ui::ComparedPtr newest = jobs_.models.newest();
  if (newest == compared_) return;
  compared_ = std::move(newest);
  news.new_reading = true;
}

}  // namespace taxel::studio
