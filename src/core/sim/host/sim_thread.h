// The simulation in its own thread: it executes commands and publishes the newest frame, without blocking the caller.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/run/command.h"
#include "core/run/frame.h"

namespace taxel {

/// A thread with a simulator, its history and its recording.
class SimThread {
 public:
  SimThread();
  ~SimThread();  ///< stops and joins
  SimThread(const SimThread&) = delete;
  SimThread& operator=(const SimThread&) = delete;

  /// Queues a command without blocking. Returns its number: frames with SimFrame::commands of at least that number
  /// include its effect.
  std::uint64_t send(SimCommand command);
  SimFramePtr newest_frame();  ///< newest frame since the last call, or null
  /// Sets whether play runs in real time. Otherwise only StepCommand makes steps, for scripts and tests.
  void set_clock_driven(bool on);
  /// Sets the folder for the journals of recordings (recording_journal.h), from which the rows of a killed process can
  /// be recovered. Without a folder, recordings are in memory until they end.
  void set_journal_folder(const std::string& folder);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taxel
