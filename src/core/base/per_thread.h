// Values of which each thread of a loop has its own: created when a thread first requests one, and used again in its
// next chunk. Like parallel.h this uses oneTBB, and plain means in a build with ThreadSanitizer, because oneTBB passes
// memory between threads unseen by it.
#pragma once

#include <functional>

#ifdef __SANITIZE_THREAD__
#include <memory>
#include <mutex>
#include <thread>
#include <unordered_map>
#else
#include <tbb/enumerable_thread_specific.h>
#endif

namespace taxel {

template <class T>
class PerThread {
 public:
#ifdef __SANITIZE_THREAD__
  /// `make()` gives the T of a thread.
  explicit PerThread(std::function<T()> make) : make_(std::move(make)) {}
  /// That of the thread that calls, valid as long as this object.
  T& local() {
    const auto mine = [this]() -> std::unique_ptr<T>& {
      const std::lock_guard lock(mutex_);
      return of_[std::this_thread::get_id()];  // a map moves none of its values
    };
    std::unique_ptr<T>& value = mine();
    if (!value) value.reset(new T(make_()));
    return *value;
  }

 private:
  std::function<T()> make_;
  std::mutex mutex_;
  std::unordered_map<std::thread::id, std::unique_ptr<T>> of_;
#else
  /// `make()` gives the T of a thread.
  explicit PerThread(std::function<T()> make) : values_(std::move(make)) {}
  /// That of the thread that calls, valid as long as this object.
  T& local() {
    return values_.local();
  }

 private:
  tbb::enumerable_thread_specific<T> values_;
#endif
};

}  // namespace taxel
