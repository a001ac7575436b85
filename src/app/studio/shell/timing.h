// The time that the frames of the window follow, the real time with threads or that of a script, and the number of
// frames to draw.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

#include "app/studio/host/jobs/job_executor.h"
#include "app/studio/shell/options.h"
#include "app/studio/shell/state/state_json.h"
#include "core/sim/host/sim_host.h"

namespace taxel::studio {

/// The time of the window.
class FrameClock {
 public:
  FrameClock() = default;
  virtual ~FrameClock() = default;
  FrameClock(const FrameClock&) = delete;
  FrameClock& operator=(const FrameClock&) = delete;

  /// Returns the time since an arbitrary moment [s].
  [[nodiscard]] virtual double now() const = 0;
  /// Returns how long to wait for input, at most `seconds` [s].
  [[nodiscard]] virtual double wait(double seconds) const = 0;
  /// Returns the duration of a frame that took `measured` [s].
  [[nodiscard]] virtual double duration(double measured) const = 0;
  /// Reports that a frame was displayed.
  virtual void tick() = 0;
};

/// The real time.
class RealClock final : public FrameClock {
 public:
  [[nodiscard]] double now() const override;
  [[nodiscard]] double wait(double seconds) const override { return seconds; }
  [[nodiscard]] double duration(double measured) const override;
  void tick() override {}
};

/// The time of a script: every frame takes 20 ms, which are twenty steps of the sweep.
class ScriptClock final : public FrameClock {
 public:
  [[nodiscard]] double now() const override { return now_; }
  [[nodiscard]] double wait(double /*seconds*/) const override { return 0; }
  [[nodiscard]] double duration(double /*measured*/) const override { return kFrame; }
  void tick() override { now_ += static_cast<float>(kFrame); }  // as ImGui adds up its time

 private:
  static constexpr double kFrame = 0.020;  // [s]
  double now_ = 0;
};

/// The clock, the executor of jobs and the simulation that belong together.
struct Timing {
  std::unique_ptr<FrameClock> clock;
  std::unique_ptr<JobExecutor> executor;
  std::unique_ptr<SimHost> simulation;
  bool is_real_time = true;
};

/// Chooses the real time with threads, or the time of a script with all work on the calling thread.
[[nodiscard]] Timing make_timing(const Options& options);

/// The number of frames that the window has to draw, and the time that they take.
class FramePacing {
 public:
  using Clock = std::chrono::steady_clock;
  /// Number of frames after an input: widgets need a second look at changed values.
  static constexpr int kSettlingFrames = 3;

  /// What no event of the session reports.
  struct Seen {
    std::uint64_t ended_jobs = 0;  ///< JobExecutor::ended()
    bool waits = false;            ///< whether something is under way that ends without an input
    std::size_t messages = 0, shown_messages = 0, notices = 0;
    bool operator==(const Seen&) const = default;
  };

  /// Requests at least this number of frames from now on.
  void request(int frames);
  /// Requests frames if something has changed since the last call.
  void request_if_changed(const Seen& now);
  [[nodiscard]] bool is_due() const { return due_ > 0; }
  /// Begins a requested frame. Returns the time since the previous one [s].
  double begin_frame();
  /// Ends a frame. Returns the frames per second, each time that they were measured over some of them.
  std::optional<double> end_frame();
  /// Registers that no frame was drawn, which is no slow frame.
  void rest() { last_frame_ = Clock::now(); }
  /// Returns the time since the last call [s].
  double advance();
  /// Ignores the time until now in the next advance().
  void skip() { advanced_ = Clock::now(); }

  /// Returns the measures since the program began, or since reset(). `scene_draws` is the number of drawn 3-D views.
  [[nodiscard]] Pace pace(int scene_draws) const;
  void reset(int scene_draws);

 private:
  Pace pace_;
  Seen seen_;
  int due_ = kSettlingFrames;
  int scene_draws_ = 0;     // number of drawn 3-D views at the last reset()
  int counted_frames_ = 0;  // number of frames since counted_since_
  Clock::time_point frame_began_, last_frame_ = Clock::now(), advanced_ = Clock::now(), counted_since_ = Clock::now();
};

}  // namespace taxel::studio
