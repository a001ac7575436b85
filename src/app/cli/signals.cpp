#include "app/cli/signals.h"

#include <fmt/format.h>

#include <atomic>
#include <mutex>

#include "app/cli/console.h"
#include "core/base/os/process.h"
#include "core/base/output.h"

namespace taxel::cli {
namespace {

constexpr int kSignalStatus = 128;  // as shells do, plus the number of the signal

std::atomic<int> received{0};
std::mutex finishing_mutex;
int finishing = 0;       // number of FinishOnSignal objects
std::string last_words;  // of set_last_words()

/// Records a signal. Returns whether the command will end by itself.
bool leave_to_command(int number) {
  const std::scoped_lock lock(finishing_mutex);
  const bool is_first = received.exchange(number) == 0;
  return is_first && finishing > 0;
}

/// Ends the process, unless the command will end by itself.
void receive(int number) {
  if (leave_to_command(number)) return;
  remove_temporary_paths();
  const std::scoped_lock lock(finishing_mutex);
  print_failure(fmt::format("ended by {}{}{}", os::signal_name(number), last_words.empty() ? "" : ": ", last_words));
  os::end_process(kSignalStatus + number);
}

}  // namespace

void handle_signals() {
  os::receive_end_signals(receive);
}

int received_signal() {
  return received.load();
}

const char* name_of_signal(int number) {
  return os::signal_name(number);
}

void set_last_words(const std::string& text) {
  const std::scoped_lock lock(finishing_mutex);
  last_words = text;
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
