// Why a taxel of the simulation reads what it reads.
#include "app/studio/run/session.h"

namespace taxel::studio {

void Session::explain(std::optional<ui::ExplainRequest> request) {
  if (request.has_value() != explain_request_.has_value()) tell(FollowStepBeforeCommand{request.has_value()});
  explain_request_ = request;
}

/// Of the step that is shown; while the simulation runs by its clock the last one stays. Not by clock it waits.
void Session::take_explanation(SessionNews& news) {
  const bool runs = by_clock_ && frame_ && frame_->playing;
  if (!runs || !explain_request_) jobs_.explain.explain(frame_, explain_request_);
  if (!by_clock_) jobs_.explain.wait();
  ui::ExplainedPtr newest = jobs_.explain.newest();
  if (newest == explained_) return;
  explained_ = std::move(newest);
  news.new_reading = true;
}

}  // namespace taxel::studio
