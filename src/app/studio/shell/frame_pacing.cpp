#include "app/studio/shell/frame_pacing.h"

#include <algorithm>
#include <utility>

namespace taxel::studio {
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
