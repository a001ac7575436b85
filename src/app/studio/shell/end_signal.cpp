#include "app/studio/shell/end_signal.h"

#include <atomic>

#include "core/base/os/signals.h"

namespace taxel::studio {

namespace {

std::atomic<int> recorded{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may only use atomics without a lock");

extern "C" void record_end_signal(int number) {
  int none = 0;
  recorded.compare_exchange_strong(none, number);
}

}  // namespace

void record_end_signals() {
  os::record_end_signals(record_end_signal);
}

int end_signal() {
  return recorded;
}

}  // namespace taxel::studio
