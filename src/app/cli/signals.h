// Signals that end a command, SIGINT, SIGTERM and SIGHUP, and long computations that they cancel.
#pragma once

#include <chrono>
#include <future>
#include <string>

#include "app/cli/console.h"
#include "core/base/progress.h"

namespace taxel::cli {

/// Starts a thread that receives the signals. Call this before any other thread starts. A signal that the parent
/// process ignores, as nohup does with SIGHUP, stays ignored.
///
/// A signal removes all temporary files and ends the process with status 128 + its number. While a FinishOnSignal
/// exists, the first signal only sets received_signal(); a second one ends the process, and the journal of a run stays.
void handle_signals();

/// Returns the number of the signal that the command has received, or 0.
int received_signal();
/// Returns the name of a signal for messages, such as "SIGTERM".
const char* name_of_signal(int number);

/// Sets the text after the name of a signal that ends the process at once. There is no text if it is empty.
void set_last_words(const std::string& text);

/// A command that checks received_signal() regularly and then writes its results.
class FinishOnSignal {
 public:
  FinishOnSignal();
  ~FinishOnSignal();
  FinishOnSignal(const FinishOnSignal&) = delete;
  FinishOnSignal& operator=(const FinishOnSignal&) = delete;

  /// Returns `status`, or 128 + the number of the received signal.
  [[nodiscard]] static int exit_status(int status);
};

/// Returns work(progress), which runs in another thread while this thread updates the bar of the console and
/// the name of its step. A signal
/// cancels the progress. Throws the exception of `work`.
template <class Work>
auto with_progress(Console& console, const Work& work) {
  Progress progress;
  auto result = std::async(std::launch::async, [&] { return work(progress); });
  while (result.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
    console.progress(progress.fraction(), progress.step());
    if (received_signal() != 0) progress.cancel();
  }
  console.progress(1);
  return result.get();
}

}  // namespace taxel::cli
