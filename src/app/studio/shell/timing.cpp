#include "app/studio/shell/timing.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/studio/host/jobs/job_executor.h"
#include "core/sim/host/sim_host.h"

namespace taxel::studio {

double RealClock::now() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double RealClock::duration(double measured) const {
  constexpr double kMinDuration = 1e-4;  // [s] ImGui needs a positive one
  return std::max(kMinDuration, measured);
}

Timing make_timing(const Options& options) {
  if (options.is_real_time())
    return {std::make_unique<RealClock>(), std::make_unique<JobPool>(), std::make_unique<SimThread>(), true};
  return {std::make_unique<ScriptClock>(), std::make_unique<InlineExecutor>(), std::make_unique<InlineSim>(), false};
}

namespace {

constexpr double kRateWindow = 0.5;  // [s] shortest time over which a rate is measured

double seconds_from(FramePacing::Clock::time_point a, FramePacing::Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

}  // namespace

void FramePacing::request(int frames) {
  due_ = std::max(due_, frames);
}

void FramePacing::request_if_changed(const Seen& now) {
  if (now != seen_) request(kSettlingFrames);
  seen_ = now;
}

double FramePacing::begin_frame() {
  due_ = std::max(0, due_ - 1);
  frame_began_ = Clock::now();
  return seconds_from(last_frame_, frame_began_);
}

std::optional<double> FramePacing::end_frame() {
  const Clock::time_point now = Clock::now();
  ++pace_.pictures;
  pace_.seconds += seconds_from(std::exchange(last_frame_, now), now);
  pace_.worst_seconds = std::max(pace_.worst_seconds, seconds_from(frame_began_, now));
  ++counted_frames_;
  const double window = seconds_from(counted_since_, now);
  if (window <= kRateWindow) return std::nullopt;
  counted_since_ = now;
  return std::exchange(counted_frames_, 0) / window;
}

double FramePacing::advance() {
  const Clock::time_point now = Clock::now();
  return seconds_from(std::exchange(advanced_, now), now);
}

Pace FramePacing::pace(int scene_draws) const {
  Pace pace = pace_;
  pace.scene_draws = scene_draws - scene_draws_;
  return pace;
}

void FramePacing::reset(int scene_draws) {
  pace_ = {};
  scene_draws_ = scene_draws;
}

}  // namespace taxel::studio
