// A mailbox of one value between two threads: the writer never waits, and the reader gets the latest value or nothing.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace taxel {

/// Contains the latest immutable T. The mutex is locked only while pointers are swapped.
template <class T>
class Mailbox {
 public:
  void post(std::shared_ptr<const T> value) {
    const std::scoped_lock lock(mutex_);
    value_.swap(value);  // the old value is destroyed outside of the lock
  }
  /// Returns the latest value posted since the last take(), or null. The mailbox is then empty.
  std::shared_ptr<const T> take() {
    std::shared_ptr<const T> taken;
    const std::scoped_lock lock(mutex_);
    taken.swap(value_);
    return taken;
  }
  /// Returns true if there is a value.
  [[nodiscard]] bool full() const {
    const std::scoped_lock lock(mutex_);
    return value_ != nullptr;
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const T> value_;
};

}  // namespace taxel
