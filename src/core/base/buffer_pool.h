// Buffers that are passed back and forth between threads.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace taxel {

/// Values that are no longer used, retained for their memory: new memory from the system costs more than filling it.
/// All functions may be called from any thread.
template <class T>
class BufferPool {
 public:
  /// Retains a value, or discards it if the pool is full.
  void put(T value) {
    const std::scoped_lock lock(mutex_);
    if (values_.size() < kMaxValues) values_.push_back(std::move(value));
  }
  /// Returns the value that was put first, or a new one if the pool is empty.
  T pop() {
    const std::scoped_lock lock(mutex_);
    if (values_.empty()) return {};
    T value = std::move(values_.front());
    values_.erase(values_.begin());
    return value;
  }

 private:
  static constexpr std::size_t kMaxValues = 3;  // one is displayed, one waits, one is being made
  std::mutex mutex_;
  std::vector<T> values_;
};

}  // namespace taxel
