// The simulation on the thread of its caller, for scripts and tests: the same calls give the same steps.
#pragma once

#include <string>

#include "core/sim/host/sim_host.h"
#include "core/sim/host/sim_loop.h"

namespace taxel {

/// Makes steps in send() and advance() only.
class InlineSim final : public SimHost {
 public:
  /// Executes the command before it returns.
  CommandId send(SimCommand command) override;
  /// While the simulation plays, makes the steps that fill `seconds` at its speed. Does nothing while replies wait to
  /// be taken, so that each command and each group of steps is displayed. Replies to play, pause and speed do not
  /// count.
  void advance(double seconds) override;
  SimReplies take() override;
  void set_journal_folder(const std::string& folder) override { loop_.recordings().set_journal_folder(folder); }

 private:
  SimLoop loop_;
  CommandId sent_ = 0;
  double unspent_ = 0;        // simulated time that did not fill a step [s]
  bool is_frame_due_ = true;  // the state has changed since the latest frame
  bool is_held_ = false;      // replies wait to be taken that hold up advance()
};

}  // namespace taxel
