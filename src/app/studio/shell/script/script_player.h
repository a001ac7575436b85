// Plays a script. Its events enter the program like a user's; its commands run after the frame to which they belong.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/shell/script/script.h"
#include "app/studio/shell/window/input_event.h"

namespace taxel::studio {

/// Functions of the window that the player needs.
struct ScriptStage {
  /// Returns the pixel of a target. Throws Error that says why there is none.
  std::function<ImVec2(const Target&)> locate;
  std::function<bool()> idle;                           ///< whether nothing loads and all input was processed
  std::function<std::optional<double>()> running_time;  ///< time of the simulation [s], or empty if it does not run
  std::function<void(const std::string&)> save_screenshot, save_state;
  std::function<std::string()> state;  ///< state of the window as JSON
  std::function<void()> quit;
};

class ScriptPlayer {
 public:
  explicit ScriptPlayer(Script script) : script_(std::move(script)) {}

  /// Returns the events of the next frame. Throws Error naming file and line.
  std::vector<InputEvent> before_frame(const ScriptStage& stage);
  /// Runs the commands after the frame. Throws Error naming file and line.
  void after_frame(const ScriptStage& stage);
  [[nodiscard]] bool finished() const { return next_ >= script_.lines.size(); }
  /// Returns whether a RestCommand has begun and is not over.
  [[nodiscard]] bool rests() const;

 private:
  template <class Body>
  void at_line(const Body& body);
  [[nodiscard]] bool due() const;
  /// Runs the command of the current line. Returns false if the command waits and is to be run again after the next
  /// frame.
  bool run_command(const ScriptStage& stage);
  bool is_so(const ExpectCommand& expect, const ScriptStage& stage);

  Script script_;
  std::size_t next_ = 0;
  int frame_ = 0;
  /// Time at which the present WaitForCommand or RestCommand began to wait.
  std::optional<std::chrono::steady_clock::time_point> waits_since_;
  bool hovers_tab_ = false;  ///< whether the pointer was moved to the tab that the present line clicks
  int idle_frames_ = 0;      ///< number of frames in a row after which the window was idle
};

/// Throws Error that names the found value if the state differs from the expectation.
void check_expectation(const ExpectCommand& expect, const std::string& state_json);

}  // namespace taxel::studio
