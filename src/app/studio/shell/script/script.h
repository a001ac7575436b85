// Scripts for the window: one raw event or command a line, as JSON. Plain values; script_player.h plays them.
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

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

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
/// Leaves the window alone for a period of real time [s], in which no frame is drawn unless something moves. With
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

}  // namespace taxel::studio
