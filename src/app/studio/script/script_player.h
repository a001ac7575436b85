// Plays a script: its events go through the same door as a hand's, its commands run after the picture of their frame.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/script/script.h"
#include "app/studio/shell/window/input_event.h"

namespace taxel::studio {

/// What the player needs of the window.
struct ScriptStage {
  /// Pixel of a target. Throws Error that says why there is none.
  std::function<ImVec2(const Target&)> locate;
  std::function<bool()> idle;                           ///< nothing loads, all input was taken
  std::function<std::optional<double>()> running_time;  ///< of the simulation [s]; none: it does not run
  std::function<void(const std::string&)> save_screenshot, save_state;
  std::function<std::string()> state;  ///< as JSON
  std::function<void()> quit;
};

class ScriptPlayer {
 public:
  explicit ScriptPlayer(Script script) : script_(std::move(script)) {}

  /// Events of the next picture. Throws Error naming file and line.
  std::vector<InputEvent> before_frame(const ScriptStage& stage);
  /// Commands after the picture. Throws Error naming file and line.
  void after_frame(const ScriptStage& stage);
  [[nodiscard]] bool finished() const { return next_ >= script_.lines.size(); }
  /// A rest has begun and is not over.
  [[nodiscard]] bool rests() const;

 private:
  template <class Body>
  void at_line(const Body& body);
  [[nodiscard]] bool due() const;
  /// Runs the command of the line at hand; false: it waits and is asked again after the next picture.
  bool run_command(const ScriptStage& stage);
  bool is_so(const ExpectCommand& expect, const ScriptStage& stage);

  Script script_;
  std::size_t next_ = 0;
  int frame_ = 0;
  std::optional<std::chrono::steady_clock::time_point> waits_since_;  ///< for the state to be as is wanted
  int idle_frames_ = 0;  ///< pictures in a row after which the window was idle
};

/// Throws Error that says what was found where the state differs from what is expected.
void check_expectation(const ExpectCommand& expect, const std::string& state_json);

}  // namespace taxel::studio
