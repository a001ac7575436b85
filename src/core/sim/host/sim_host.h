// The simulation as the window uses it: commands in, replies out, wherever the steps are made: in a thread of their
// own, or, for scripts and tests, on the thread of the caller.
#pragma once

#include <memory>
#include <string>

#include "core/run/command.h"
#include "core/run/event.h"

namespace taxel {

struct SimLoop;

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

/// The simulation in its own thread, which carries out commands and publishes frames without blocking the caller. While
/// it plays, simulated time follows the clock at the requested speed.
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

/// The simulation on the thread of its caller: the same calls give the same steps. It makes steps in send() and
/// advance() only.
class InlineSim final : public SimHost {
 public:
  InlineSim();
  ~InlineSim() override;

  /// Carries out the command before it returns.
  CommandId send(SimCommand command) override;
  /// While the simulation plays, makes the steps that fill `seconds` at its speed. Does nothing while replies wait to
  /// be taken, so that each command and each group of steps is displayed. Replies to play, pause and speed do not
  /// count.
  void advance(double seconds) override;
  SimReplies take() override;
  void set_journal_folder(const std::string& folder) override;

 private:
  std::unique_ptr<SimLoop> loop_;
  CommandId sent_ = 0;
  double unspent_ = 0;        // simulated time that did not fill a step [s]
  bool is_frame_due_ = true;  // the state has changed since the latest frame
  bool is_held_ = false;      // replies wait to be taken that hold up advance()
};

}  // namespace taxel
