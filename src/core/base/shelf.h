// Memory that goes round between two threads.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace taxel {

/// Values that another thread has done with, for the memory that they hold: asking the system for it anew, page by
/// page, costs more than filling it.
template <class T>
class Shelf {
 public:
  /// Keeps it, unless there are enough.
  void put(T value) {
    const std::scoped_lock lock(mutex_);
    if (values_.size() < kMost) values_.push_back(std::move(value));
  }
  /// What lay longest, or a new one.
  T take() {
    const std::scoped_lock lock(mutex_);
    if (values_.empty()) return {};
    T value = std::move(values_.front());
    values_.erase(values_.begin());
    return value;
  }

 private:
  static constexpr std::size_t kMost = 3;  // one is shown, one waits, one is made
  std::mutex mutex_;
  std::vector<T> values_;
};

}  // namespace taxel
