// Scripts for the window: one raw event or command a line, as JSON. A player runs them.
//
//   {"frame": 10, "event": "mouse_down", "button": "left", "at": [400, 300], "mods": ["ctrl"]}
//   {"frame": 12, "event": "click", "at": {"widget": "Run"}}
//   {"frame": 60, "do": "screenshot", "file": "sweep.png"}
//
// `frame` counts frames from 0, does not advance during a wait, and may be left out, which means the frame of the
// previous line. `at` is a pixel, {"view": [u, v]} in fractions of the 3-D view from its top left corner,
// {"world": [x, y, z]} in metres, {"taxel": id} or {"widget": "Label"}.
#pragma once

#include <imgui.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/studio/shell/window/input_event.h"
#include "core/base/math.h"

namespace taxel::studio {

struct PixelTarget {
  double x = 0, y = 0;
};
struct ViewTarget {
  double u = 0, v = 0;
};
struct WorldTarget {
  dvec3 p_W{0};
};
struct TaxelTarget {
  int id = 0;
};
struct WidgetTarget {
  std::string label;
};
using Target = std::variant<PixelTarget, ViewTarget, WorldTarget, TaxelTarget, WidgetTarget>;

using Modifiers = std::vector<ImGuiKey>;  ///< modifier keys such as ImGuiMod_Ctrl

// Events are the input of a user.
struct MouseMoveEvent {
  Target at;
};
struct MouseButtonEvent {
  std::optional<Target> at;
  int button = 0;
  bool down = false;
  Modifiers mods;
};
struct ClickEvent {
  std::optional<Target> at;
  int button = 0;
  int count = 1;
  Modifiers mods;
};
struct WheelEvent {
  std::optional<Target> at;
  double x = 0, y = 0;
  Modifiers mods;
};
struct KeyEvent {
  ImGuiKey key = ImGuiKey_None;
  bool down = true, up = true;
  Modifiers mods;
};
struct TextEvent {
  std::string text;
};
/// Drops files, with absolute paths. A script gives the paths absolute or relative to its folder.
struct DropEvent {
  std::vector<std::string> files;
};
struct ResizeEvent {
  int width = 0, height = 0;
};
struct CloseEvent {};

// Commands control the test. Paths of written files are relative to the working folder.
struct ScreenshotCommand {
  std::string file;
};
struct DumpStateCommand {
  std::string file;
};
/// Waits until nothing loads and all input was processed.
struct WaitIdleCommand {};
/// Waits until the simulation reaches a time [s].
struct WaitTimeCommand {
  double time = 0;
};
/// Compares the state's value at a JSON pointer, which must equal a JSON text, contain a text, or be within [least,
/// most].
struct ExpectCommand {
  std::string pointer, equals, contains;
  std::optional<double> least, most;
};
/// Waits until the state meets an expectation, for at most a minute. Meant for events outside of the program.
struct WaitForCommand {
  ExpectCommand expect;
};
/// Leaves the window alone for a period of real time [s], in which no frame is drawn unless something moves. The period
/// begins when no job works in the background, so that a slow machine does not end the rest before its jobs. With
/// --live only.
struct RestCommand {
  double seconds = 0;
};
struct QuitCommandLine {};

using ScriptStep =
    std::variant<MouseMoveEvent, MouseButtonEvent, ClickEvent, WheelEvent, KeyEvent, TextEvent, DropEvent, ResizeEvent,
                 CloseEvent, ScreenshotCommand, DumpStateCommand, WaitIdleCommand, WaitTimeCommand, ExpectCommand,
                 WaitForCommand, RestCommand, QuitCommandLine>;

struct ScriptLine {
  int number = 0;  ///< line number in the file, from 1
  int frame = 0;
  ScriptStep step;
};

struct Script {
  std::string file;
  std::vector<ScriptLine> lines;
};

/// Reads a script. Throws Error(file, "line N", message) for anything that is not exactly this format.
Script read_script(const std::filesystem::path& file);
/// Parses the text of a script file. Throws Error as read_script() does.
Script parse_script(const std::string& text, const std::filesystem::path& file);

/// Functions of the window that the player needs.
struct ScriptStage {
  /// Returns the pixel of a target. Throws Error that says why there is none.
  std::function<ImVec2(const Target&)> locate;
  std::function<bool()> idle;                           ///< whether nothing loads and all input was processed
  std::function<bool()> works;                          ///< whether anything loads or a job works in the background
  std::function<std::optional<double>()> running_time;  ///< time of the simulation [s], or empty if it does not run
  std::function<void(const std::string&)> save_screenshot, save_state;
  std::function<std::string()> state;  ///< state of the window as JSON
  std::function<void()> quit;
};

/// Plays a script. Its events enter the program like a user's; its commands run after the frame to which they belong.
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
