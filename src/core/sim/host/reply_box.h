// Replies of a simulation between two threads.
#pragma once

#include <algorithm>
#include <iterator>
#include <mutex>
#include <utility>
#include <vector>

#include "core/run/event.h"

namespace taxel {

/// A newer frame replaces one that was not taken; events are kept until they are taken.
class ReplyBox {
 public:
  void post(SimFramePtr frame, std::vector<SimEvent> events) {
    const std::scoped_lock lock(mutex_);
    replies_.frame.swap(frame);  // the old frame is destroyed outside of the lock
    std::move(events.begin(), events.end(), std::back_inserter(replies_.events));
  }
  SimReplies take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(replies_, {});
  }
  [[nodiscard]] bool has_frame() const {
    const std::scoped_lock lock(mutex_);
    return replies_.frame != nullptr;
  }

 private:
  mutable std::mutex mutex_;
  SimReplies replies_;
};

}  // namespace taxel
