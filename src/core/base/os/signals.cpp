#include "core/base/os/signals.h"

#include <pthread.h>

#include <array>
#include <csignal>
#include <thread>
#include <utility>

namespace taxel::os {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

bool is_ignored(int number) {
  struct sigaction action {};
  return ::sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN;
}

}  // namespace

void receive_end_signals(std::function<void(int)> receive) {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : kSignals)
    if (!is_ignored(number)) sigaddset(&signals, number);
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals, receive = std::move(receive)] {
    int number = 0;
    while (::sigwait(&signals, &number) == 0) receive(number);
  }).detach();
}

void record_end_signals(void (*record)(int)) {
  struct sigaction action {};
  action.sa_handler = record;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  for (const int number : kSignals)
    if (!is_ignored(number)) ::sigaction(number, &action, nullptr);
}

const char* signal_name(int number) {
  return number == SIGINT ? "SIGINT" : number == SIGHUP ? "SIGHUP" : "SIGTERM";
}

}  // namespace taxel::os
