// Parallel loop on newly created threads, for parallel.h in a build with ThreadSanitizer.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace taxel {

/// Calls body(i) for i in [0, count) in some order, on a few threads. Throws the first exception of a body; the
/// remaining calls are then not made.
template <class Body>
void plain_threads(int count, const Body& body) {
  constexpr int kThreads = 3;
  std::atomic<int> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    for (int i = next++; i < count; i = next++) {
      try {
        body(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::jthread> others;
  for (int t = 1; t < std::min(kThreads, count); ++t) others.emplace_back(work);
  work();
  others.clear();  // joined
  if (failure) std::rethrow_exception(failure);
}

}  // namespace taxel
