// The members of SimThread: the simulator, its history, and the queue and mailbox between the threads.
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

/// All members except the first seven and the mailbox belong to the simulation's thread.
struct SimThread::Impl {
  std::mutex mutex;  // guards the next six members
  std::condition_variable wake;
  std::vector<SimCommand> queue;
  std::uint64_t posted = 0;
  bool clock_driven = true;
  bool clock_changed = false;
  std::string journal_folder;  // empty if recordings are in memory only

  Mailbox<SimFrame> mailbox;

  std::unique_ptr<Simulator> simulator;
  Pacing pacing;
  bool running = true, playing = false, real_time = true;
  double speed = 1.0;
  std::string error;    // why the simulation failed
  std::string refused;  // why the latest scene or model was refused; the previous one continues
  std::uint64_t loads = 0, replacements = 0, runs = 0, commands = 0;
  SavedScene saved;
  std::optional<LiveRecording> recording;   // recording that is being made
  std::optional<EndedRecording> unwritten;  // ended recording that could not be written
  WrittenRecording written;
  std::string journal_failure;  // why the newest recording has no journal, or empty
  int journals = 0;             // number of journals begun
  StepHistory history;
  std::optional<std::uint64_t> displayed;  // number of the recorded step that is displayed
  bool follows_before = false;             // frames have the previous step
  std::shared_ptr<const RecalledSteps> recalled;
  std::optional<Stop> stop;
  SimState state;  // scratch
  StepView view;   // scratch; the latest step
  std::shared_ptr<const HistoryLanes> lanes = std::make_shared<const HistoryLanes>();
  Trace trace;
  FrameMemory memory;
  std::shared_ptr<const Trace> published_trace = std::make_shared<const Trace>();  // a copy
  StepTime step_time, record_time;
  StepCosts costs;
  double last_frame = 0, last_trace = 0, last_consumed = 0;
  bool answered = true;  // the latest frame followed a command, or is the last one of a run
  bool changed = true;   // the state has changed since the latest frame

  std::thread thread;  // last member: starts after all others exist

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
  void resume_from_displayed_step();
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
  bool frames_are_consumed(double now);
  void publish(bool even_if_recent);
  void copy_rows(double now, bool even_if_recent);
  [[nodiscard]] StepPtr previous_step() const;

  [[nodiscard]] bool stepping() const { return playing && real_time && simulator != nullptr; }
};

}  // namespace taxel
