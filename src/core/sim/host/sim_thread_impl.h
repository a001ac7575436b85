// What the simulation's thread owns: the simulator, its history, and the door between the threads.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "core/base/mailbox.h"
#include "core/run/history/step_history.h"
#include "core/sim/host/frame_memory.h"
#include "core/sim/host/live_recording.h"
#include "core/sim/host/pacing.h"
#include "core/sim/host/sim_thread.h"
#include "core/sim/host/step_time.h"
#include "core/sim/simulator.h"

namespace taxel {

inline double seconds_since_epoch() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Everything but the queue and the mailbox belongs to the simulation's thread.
struct SimThread::Impl {
  std::mutex mutex;  // guards the next six
  std::condition_variable wake;
  std::vector<SimCommand> queue;
  std::uint64_t posted = 0;
  bool clock_driven = true;
  bool clock_changed = false;
  std::string journal_folder;  // empty: recordings are kept in memory only

  Mailbox<SimFrame> mailbox;

  std::unique_ptr<Simulator> simulator;
  Pacing pacing;
  bool running = true, playing = false, by_clock = true;
  double speed = 1.0;
  std::string error;    // why stepping stopped
  std::string refused;  // why the last scene or model was not taken; the one before goes on
  std::uint64_t loads = 0, replacements = 0, runs = 0, commands = 0;
  SavedScene saved;
  std::optional<LiveRecording> recording;   // runs
  std::optional<EndedRecording> unwritten;  // ended, and could not be written
  WrittenRecording written;
  std::string journal_failure;  // why the newest recording is not kept on disk; empty: it is
  int journals = 0;             // number of journals begun
  StepHistory history;
  std::optional<std::uint64_t> scrubbed;  // the step of the past that is shown
  bool follows_before = false;            // frames carry the step before
  std::shared_ptr<const RecalledSteps> recalled;
  std::optional<Stop> stop;
  SimState state;  // scratch, and
  StepView view;   // likewise, of the step just made
  std::shared_ptr<const HistoryLanes> lanes = std::make_shared<const HistoryLanes>();
  Trace trace;
  FrameMemory memory;
  std::shared_ptr<const Trace> posted_trace = std::make_shared<const Trace>();  // a copy
  StepTime step_time, record_time;
  StepCosts costs;
  double last_frame = 0, last_trace = 0, last_taken = 0;
  bool answered = true;  // the last frame answers a command, or is the last of a run
  bool changed = true;   // something to show since the last frame

  std::thread thread;  // last: starts when all else is there

  Impl() : thread([this] { run(); }) {}
  ~Impl() {
    post(QuitCommand{});
    thread.join();
  }

  std::uint64_t post(SimCommand command) {
    std::uint64_t number = 0;
    {
      const std::scoped_lock lock(mutex);
      queue.push_back(std::move(command));
      number = ++posted;
    }
    wake.notify_one();
    return number;
  }

  void run();
  std::vector<SimCommand> take_commands();
  void execute(const SimCommand& command);
  void load(const std::function<std::unique_ptr<Simulator>()>& make);
  void replace_model(const ReplaceModelCommand& command);
  void set_playing(bool on);
  void begin_run();
  void go_on_from_shown();
  void scrub(std::uint64_t step);
  void recall(const RecallCommand& asked);
  bool execute_on_scene(const SimCommand& command);
  bool execute_on_recording(const SimCommand& command);
  void begin_recording(const std::string& file);
  void end_recording(const std::string& why);
  void begin_journal();
  void record_step();
  void write(EndedRecording ended, const std::string& file);
  void export_history(const ExportHistoryCommand& command);
  void execute_on_history(const SimCommand& command);
  bool step_once();
  void add_trace_row();
  void burst();
  bool frames_are_taken(double now);
  void publish(bool even_if_recent);
  void copy_rows(double now, bool even_if_recent);
  [[nodiscard]] StepPtr previous_step() const;

  [[nodiscard]] bool stepping() const { return playing && by_clock && simulator != nullptr; }
};

}  // namespace taxel
