// The simulation as the window uses it: commands in, replies out, wherever the steps are made.
#pragma once

#include <string>

#include "core/run/command.h"
#include "core/run/event.h"

namespace taxel {

/// A simulation with its host. Belongs to one thread, which is never blocked by steps that follow a clock.
class SimHost {
 public:
  SimHost() = default;
  virtual ~SimHost() = default;
  SimHost(const SimHost&) = delete;
  SimHost& operator=(const SimHost&) = delete;

  /// Requests the execution of a command. Returns its number, which the events that it causes have.
  virtual CommandId send(SimCommand command) = 0;
  /// Reports that `seconds` have passed on the clock of the window.
  virtual void advance(double seconds) = 0;
  /// Returns and forgets the replies since the last call.
  virtual SimReplies take() = 0;
  /// Sets the folder for the journals of recordings (recording_journal.h), from which the rows of a killed process can
  /// be recovered. Without a folder, recordings are in memory until they end.
  virtual void set_journal_folder(const std::string& folder) = 0;
};

}  // namespace taxel
