// The simulation in its own thread, paced by the clock: it executes commands and publishes frames without blocking the
// caller.
#pragma once

#include <memory>
#include <string>

#include "core/sim/host/sim_host.h"

namespace taxel {

/// A thread with a simulation. While the simulation plays, simulated time follows the clock at the requested speed.
class SimThread final : public SimHost {
 public:
  SimThread();
  ~SimThread() override;  ///< stops and joins

  /// Queues a command. Never blocks.
  CommandId send(SimCommand command) override;
  void advance(double seconds) override;  ///< does nothing: the thread reads the clock itself
  SimReplies take() override;
  void set_journal_folder(const std::string& folder) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taxel
