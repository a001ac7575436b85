// Scripts for the window: one raw event or command a line, as JSON. Plain values; script_player.h plays them.
//
//   {"frame": 10, "event": "mouse_down", "button": "left", "at": [400, 300], "mods": ["ctrl"]}
//   {"frame": 12, "event": "click", "at": {"widget": "Run"}}
//   {"frame": 60, "do": "screenshot", "file": "sweep.png"}
//
// `frame` counts pictures from 0, stands still while a wait lasts, and may be left out (as in the line before). `at` is
// a pixel, {"world": [x, y, z]} in metres, {"taxel": id} or {"widget": "Label"}.
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
struct WorldTarget {
  dvec3 p_W{0};
};
struct TaxelTarget {
  int id = 0;
};
struct WidgetTarget {
  std::string label;
};
using Target = std::variant<PixelTarget, WorldTarget, TaxelTarget, WidgetTarget>;

using Modifiers = std::vector<ImGuiKey>;  ///< ImGuiMod_Ctrl, ...

// Events: what a hand can do.
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
struct DropEvent {
  std::vector<std::string> files;
};  ///< absolute, or from the script's folder
struct ResizeEvent {
  int width = 0, height = 0;
};
struct CloseEvent {};

// Commands: what a tester wants. Files are written from the working folder.
struct ScreenshotCommand {
  std::string file;
};
struct DumpStateCommand {
  std::string file;
};
struct WaitIdleCommand {};  ///< until nothing loads and all input was taken
struct WaitTimeCommand {
  double time = 0;
};  ///< until the simulation reaches it [s]
/// Compares the state's value at a JSON pointer: equals (JSON text), or within [least, most].
struct ExpectCommand {
  std::string pointer, equals, contains;
  std::optional<double> least, most;
};
struct WaitForCommand {
  ExpectCommand expect;
};  ///< until the state is so, at most a minute: for what happens outside of the program
/// Leaves the window alone for a while of real time [s]: unless something moves, no frame is drawn. With --live only.
struct RestCommand {
  double seconds = 0;
};
struct QuitCommandLine {};

using ScriptStep =
    std::variant<MouseMoveEvent, MouseButtonEvent, ClickEvent, WheelEvent, KeyEvent, TextEvent, DropEvent, ResizeEvent,
                 CloseEvent, ScreenshotCommand, DumpStateCommand, WaitIdleCommand, WaitTimeCommand, ExpectCommand,
                 WaitForCommand, RestCommand, QuitCommandLine>;

struct ScriptLine {
  int number = 0;  ///< in the file, from 1
  int frame = 0;
  ScriptStep step;
};

struct Script {
  std::string file;
  std::vector<ScriptLine> lines;
};

/// Throws Error(file, "line N", message) for anything that is not exactly this format.
Script read_script(const std::filesystem::path& file);
/// The same of the file's text.
Script parse_script(const std::string& text, const std::filesystem::path& file);

}  // namespace taxel::studio
