// The simulation in its own thread: commands go in, the newest frame comes out, nobody waits for anybody.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/run/command.h"
#include "core/run/frame.h"

namespace taxel {

class SimThread {
 public:
  SimThread();
  ~SimThread();  ///< stops and joins
  SimThread(const SimThread&) = delete;
  SimThread& operator=(const SimThread&) = delete;

  /// Never blocks. Returns the command's number, which frames after it have reached in SimFrame::commands.
  std::uint64_t send(SimCommand command);
  SimFramePtr newest_frame();  ///< newest since the last call, or null
  /// For headless pictures and tests: steps exactly when told (StepCommand), never by the clock.
  void set_clock_driven(bool on);
  /// Recordings are kept in journals (recording_journal.h) of this folder while they run, so that a killed process
  /// loses none of their rows. Without it they are in memory only.
  void set_journal_folder(const std::string& folder);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taxel
