// Parallel loops whose result cannot depend on the number of threads: chunks are fixed by the caller, each chunk writes
// its own output, and any reduction is done afterwards in chunk order. PerThread has values for the threads of a loop.
//
// All use oneTBB. A build with ThreadSanitizer uses plain threads and a map, because the synchronisation of oneTBB is
// not instrumented, nor is the memory that it passes between threads: every loop would look like a race, and
// suppressing these reports would hide our own races.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <functional>
#include <utility>

#ifdef __SANITIZE_THREAD__
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <vector>
#else
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>
#endif

namespace taxel {

#ifdef __SANITIZE_THREAD__
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
#endif

/// Calls body(begin, end) for consecutive chunks of [0, count), at most `chunk` long each.
template <class Body>
void parallel_chunks(int count, int chunk, const Body& body) {
  const int chunks = (count + chunk - 1) / chunk;
  const auto run = [&](int c) { body(c * chunk, std::min(count, (c + 1) * chunk)); };
#ifdef __SANITIZE_THREAD__
  plain_threads(chunks, run);
#else
  tbb::parallel_for(tbb::blocked_range<int>(0, chunks, 1), [&](const tbb::blocked_range<int>& range) {
    for (int c = range.begin(); c != range.end(); ++c) run(c);
  });
#endif
}

/// Runs all bodies in parallel, each to its end, and then throws the exception of the first body (in this order) that
/// threw. An exception that left a task of oneTBB would cancel the loops inside of the other tasks, which would then
/// return half done without an error.
template <class... Body>
void parallel_all(const Body&... bodies) {
  std::array<std::exception_ptr, sizeof...(Body)> failures;
  const auto guarded = [](const auto& body, std::exception_ptr& failure) {
    return [&body, &failure] {
      try {
        body();
      } catch (...) {
        failure = std::current_exception();
      }
    };
  };
  [&]<std::size_t... I>(std::index_sequence<I...>) {
#ifdef __SANITIZE_THREAD__
    const std::array<std::function<void()>, sizeof...(Body)> all{guarded(bodies, failures[I])...};
    plain_threads(static_cast<int>(all.size()), [&](int i) { all[static_cast<std::size_t>(i)](); });
#else
    tbb::parallel_invoke(guarded(bodies, failures[I])...);
#endif
  }
  (std::index_sequence_for<Body...>{});
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

/// Runs a body whose loops do not begin other tasks of this thread while they wait. A thread that holds a mutex might
/// otherwise begin a task that locks the same mutex.
template <class Body>
void isolated(const Body& body) {
#ifdef __SANITIZE_THREAD__
  body();
#else
  tbb::this_task_arena::isolate(body);
#endif
}

/// Runs a body whose loops use this thread alone, for callers that run many bodies on threads of their own.
template <class Body>
void on_this_core(const Body& body) {
#ifdef __SANITIZE_THREAD__
  body();
#else
  tbb::task_arena one(1);
  one.execute(body);
#endif
}

/// Values of which each thread of a loop has its own: created when a thread first requests one, and used again in its
/// next chunk.
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
