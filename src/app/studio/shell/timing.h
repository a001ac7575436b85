// The time that the frames of the window follow: the real time with threads, or that of a script.
#pragma once

#include <memory>

#include "app/studio/host/jobs/job_executor.h"
#include "app/studio/shell/options.h"
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

}  // namespace taxel::studio
