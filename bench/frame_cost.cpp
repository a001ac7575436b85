// Cost of a drawn frame for the simulation. The program's own simulation thread steps as fast as it can. In every
// second stretch of time, frames are taken 60 times a second, as by the window; in the other stretches none is taken,
// and the thread soon makes none. Measured are the processor time of the thread, and the time that it waits for a lock
// or for memory. Both are the kernel's own counts (schedstat), which other programs do not change. Linux only.
//
//   bench_frame_cost [STRETCHES]
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/sim/host/sim_host.h"
#include "our_fingertip.h"

namespace {
using namespace taxel;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr double kSamples = 16000;
constexpr auto kFrame = 16'666us;
constexpr auto kStretch = 700ms;
constexpr auto kForgotten = 350ms;  // time until a simulation makes no more frames if none is taken

std::set<std::string> threads() {
  std::set<std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task"))
    all.insert(entry.path().filename().string());
  return all;
}

/// A simulation thread, and its id in the kernel.
class Watched {
 public:
  Watched() : before_(threads()), simulation_(std::make_unique<SimThread>()) {
    for (const std::string& task : threads())
      if (!before_.contains(task)) task_ = task;
  }
  SimThread& simulation() { return *simulation_; }
  SimFramePtr ask(SimCommand command) {
    const CommandId id = simulation_->send(std::move(command));
    while (true) {
      const SimReplies replies = simulation_->take();
      if (!replies.events.empty() && replies.events.back().reply_to == id) return replies.frame;
      std::this_thread::sleep_for(100us);
    }
  }

  struct Count {
    double processor = 0, stood = 0;  // [s]
    std::uint64_t steps = 0, frames = 0;
    Count& operator+=(const Count& other) {
      processor += other.processor, stood += other.stood, steps += other.steps, frames += other.frames;
      return *this;
    }
  };
  /// Returns the times so far. `stood` is the time in which the thread neither ran nor waited for a processor.
  Count count() {
    const SimFramePtr frame = ask(SpeedCommand{1e6});
    if (!frame->error.empty() || !frame->playing) throw Error("it does not run: " + frame->error);
    std::uint64_t ran = 0, queued = 0;  // [ns]
    std::ifstream("/proc/self/task/" + task_ + "/schedstat") >> ran >> queued;
    const double now = std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
    const double processor = 1e-9 * static_cast<double>(ran);
    return {processor, now - processor - 1e-9 * static_cast<double>(queued), frame->step, 0};
  }

 private:
  std::set<std::string> before_;
  std::unique_ptr<SimThread> simulation_;
  std::string task_;
};

/// Runs the simulation for one stretch, and takes its frames if `takes` is true.
Watched::Count stretch(Watched& watched, bool takes) {
  SimFramePtr shown;  // kept until the next frame, as in the window
  std::uint64_t frames = 0;
  const auto run = [&](Clock::duration length) {
    const Clock::time_point begin = Clock::now();
    for (Clock::time_point next = begin; next < begin + length;) {
      std::this_thread::sleep_until(next += takes ? Clock::duration(kFrame) : length);
      if (!takes) continue;
      if (SimFramePtr frame = watched.simulation().take().frame) shown = std::move(frame), ++frames;
    }
  };
  run(kForgotten);
  const Watched::Count before = watched.count();
  frames = 0;
  run(kStretch);
  const Watched::Count after = watched.count();
  return {after.processor - before.processor, after.stood - before.stood, after.steps - before.steps, frames};
}

/// Measures stretches that begin after `steps_before` steps. If `again` is true, all stretches continue from this same
/// step, because later steps have other costs.
void measure(const char* what, int steps_before, bool again, const SimCommand& load, int stretches) {
  Watched watched;
  watched.ask(load);
  const SimFramePtr frame = watched.ask(StepCommand{steps_before});
  std::size_t hits = 0, polygons = 0;
  for (const SensorStep& sensor : frame->sensors) {
    hits += sensor.hits.size();
    for (const ContactSurface& surface : sensor.surfaces) polygons += surface.polygons.size();
  }
  watched.ask(SpeedCommand{1e6});
  watched.ask(PlayCommand{});
  const auto run = [&](bool takes) {
    if (again) watched.ask(ScrubCommand{frame->step}), watched.ask(PlayCommand{});
    return stretch(watched, takes);
  };
  Watched::Count with, without;
  std::vector<double> parts;
  for (int i = 0; i < stretches; ++i) {
    const bool first = i % 2 == 0;
    const Watched::Count a = run(first), b = run(!first);
    const Watched::Count &on = first ? a : b, &off = first ? b : a;
    with += on, without += off;
    parts.push_back((on.processor / static_cast<double>(on.steps)) / (off.processor / static_cast<double>(off.steps)) -
                    1);
  }
  std::sort(parts.begin(), parts.end());
  const double part = parts[parts.size() / 2], plain = without.processor / static_cast<double>(without.steps);
  const double frames_per_step = static_cast<double>(with.frames) / static_cast<double>(with.steps);
  const auto stood = [](const Watched::Count& c) { return 1e6 * c.stood / static_cast<double>(c.steps); };
  fmt::print(
      "| {}: {} rays, {} polygons | {:.1f} us | {:+.2f} % | {:+.2f} to {:+.2f} % | {:.0f} us | {:.2f}, {:.2f} us |\n",
      what, hits, polygons, 1e6 * plain, 100 * part, 100 * parts.front(), 100 * parts.back(),
      1e6 * part * plain / frames_per_step, stood(without), stood(with));
}

}  // namespace

int main(int argc, char** argv) {
  int stretches = 8;
  if (argc > 1) std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), stretches);
  fmt::print("{} pairs of stretches\n\n", stretches);
  fmt::print(
      "| | a step without frames | more with 60 a second, median | least to most | so much a frame | "
      "stood still a step: without, with |\n| --- | --- | --- | --- | --- | --- |\n");
  Scenario press = default_scenario(kKind<scenarios::Press>);
  press.as<scenarios::Press>().hold = 2000;
  measure("pressed fingertip", 2500, false, LoadScenarioCommand{bench::our_fingertip(kSamples), press}, stretches);
  measure("hand of five fingers after 20 s", 10000, true,
          LoadSceneCommand{TAXEL_SOURCE_DIR "/assets/scenes/hand_grasps_ball.xml", {}}, stretches);
  return 0;
}
