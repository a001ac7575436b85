#include "app/studio/shell/end_signal.h"

#include <atomic>
#include <csignal>

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
  struct sigaction action {};
  action.sa_handler = record_end_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  for (const int number : {SIGTERM, SIGINT, SIGHUP}) {
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(number, &action, nullptr);  // nohup ignores SIGHUP
  }
}

int end_signal() {
  return recorded;
}

}  // namespace taxel::studio
