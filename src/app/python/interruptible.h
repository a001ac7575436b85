// Long computations that Ctrl+C ends.
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>
#include <future>

#include "core/base/progress.h"

namespace taxel::python {

/// Returns work(), which runs in another thread and reports to `progress`, while this thread handles Python's signals
/// without holding Python's lock in between. Throws the exception of the work, or the Python exception of a signal,
/// such as KeyboardInterrupt.
template <class Work>
auto run_interruptibly(Progress& progress, const Work& work) {
  auto running = std::async(std::launch::async, [&] { return work(); });
  bool is_interrupted = false;
  for (;;) {
    std::future_status status{};
    {
      const nanobind::gil_scoped_release release;
      status = running.wait_for(std::chrono::milliseconds(20));
    }
    if (status == std::future_status::ready) break;
    if (!is_interrupted && PyErr_CheckSignals() != 0) {
      is_interrupted = true;
      progress.cancel();
    }
  }
  try {
    auto result = running.get();
    if (is_interrupted) throw nanobind::python_error();
    return result;
  } catch (const Cancelled&) {
    throw nanobind::python_error();
  }
}

}  // namespace taxel::python
