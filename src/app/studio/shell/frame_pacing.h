// The number of frames that the window has to draw, and the time that they take.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "app/studio/shell/state/state_json.h"

namespace taxel::studio {

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
