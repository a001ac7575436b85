#include "app/cli/signals.h"

#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <mutex>
#include <thread>

#include "app/cli/console.h"
#include "core/base/temporary_path.h"

namespace taxel::cli {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
constexpr int kSignalStatus = 128;  // as shells do, plus the number of the signal

std::atomic<int> received{0};
std::mutex finishing_mutex;
int finishing = 0;  // number of FinishOnSignal objects

/// Records a signal. Returns whether the command will end by itself.
bool leave_to_command(int number) {
  const std::scoped_lock lock(finishing_mutex);
  const bool is_first = received.exchange(number) == 0;
  return is_first && finishing > 0;
}

/// Waits for signals and ends the process, unless the command will end by itself.
void receive(const sigset_t& signals) {
  int number = 0;
  while (::sigwait(&signals, &number) == 0) {
    if (leave_to_command(number)) continue;
    remove_temporary_paths();
    print_failure(fmt::format("ended by {}", name_of_signal(number)));
    ::_exit(kSignalStatus + number);
  }
}

}  // namespace

void handle_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : kSignals) {
    struct sigaction action {};
    if (::sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) sigaddset(&signals, number);
  }
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals] { receive(signals); }).detach();
}

int received_signal() {
  return received.load();
}

const char* name_of_signal(int number) {
  return number == SIGINT ? "SIGINT" : number == SIGHUP ? "SIGHUP" : "SIGTERM";
}

FinishOnSignal::FinishOnSignal() {
  const std::scoped_lock lock(finishing_mutex);
  ++finishing;
}
FinishOnSignal::~FinishOnSignal() {
  const std::scoped_lock lock(finishing_mutex);
  --finishing;
}

int FinishOnSignal::exit_status(int status) {
  const int number = received_signal();
  return number == 0 ? status : kSignalStatus + number;
}

}  // namespace taxel::cli
