// One slot between two threads: the writer never waits, the reader gets the newest value or nothing.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace taxel {

/// Holds the newest immutable T. The lock is held for a swap of pointers only.
template <class T>
class Mailbox {
 public:
  void post(std::shared_ptr<const T> value) {
    const std::scoped_lock lock(mutex_);
    value_.swap(value);  // the old value is destroyed outside of the lock
  }
  /// Returns the newest value posted since the last take, or null. Taking empties the slot.
  std::shared_ptr<const T> take() {
    std::shared_ptr<const T> taken;
    const std::scoped_lock lock(mutex_);
    taken.swap(value_);
    return taken;
  }
  /// Whether a value waits to be taken.
  [[nodiscard]] bool full() const {
    const std::scoped_lock lock(mutex_);
    return value_ != nullptr;
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const T> value_;
};

}  // namespace taxel
