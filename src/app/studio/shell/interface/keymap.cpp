#include "app/studio/frame/keymap.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

namespace taxel::ui {

namespace {

constexpr std::array kGestures = {
    Gesture{kEverywhere, "Left-drag", "Orbit"},
    Gesture{kEverywhere, "Right-drag", "Pan (Shift: keep the height)"},
    Gesture{kEverywhere, "Wheel, middle-drag", "Zoom"},
    Gesture{kEverywhere, "Shift+wheel", "Move the clip plane"},
    Gesture{kEverywhere, "Right double-click", "Centre on the point"},
    Gesture{kEverywhere, "Click", "Select a taxel (view, table, bars, legend)"},
    Gesture{kEverywhere, "Shift+click", "Add a taxel to the selection, or take it out"},
    Gesture{kSimulate, "Click on the contact surface", "Inspect the polygon (Explain panel)"},
    Gesture{kLayout, "Ctrl+click", "Add a taxel on the surface"},
    Gesture{kLayout, "Drag a selected taxel", "Slide it along the surface"},
    Gesture{kLayout, "Ctrl+wheel", "Change the radius by 2 %"},
    Gesture{kLayout, "Double-click a cell", "Type in the table of taxels (Tab: next cell)"},
    Gesture{kLayout, "Drag a row", "Reorder taxels"},
    Gesture{kLayout, "Brush: left-drag", "Paint the region (Shift or Ctrl: erase; wheel: radius)"},
    Gesture{kLayout, "Generate: click, drag", "Put the pattern there (Ctrl+wheel: turn it)"},
    Gesture{kLayout, "Wheel, drag on the probe", "Press it deeper; put down: slide it along the surface"},
    Gesture{kSimulate, "Double-click", "Select a body"},
    Gesture{kSimulate, "Ctrl+left-drag", "Turn the selected body (Shift: about level axes)"},
    Gesture{kSimulate, "Ctrl+right-drag", "Pull the selected body (Shift: keep the height)"},
    Gesture{kSimulate, "Ctrl+Alt+left-drag", "The same, without the right button"},
    Gesture{kSimulate, "Ctrl+right double-click", "Track the body: the camera goes along (Esc frees it)"},
    Gesture{kGesture, "0-9 . -", "Exact value, in mm or degrees (Backspace)"},
    Gesture{kGesture, "Shift", "A tenth of the pace"},
    Gesture{kGesture, "Ctrl", "Snap"},
    Gesture{kGesture, "Click, right click", "Accept, cancel"},
    Gesture{kEverywhere, "Drag in the timeline", "Show a recorded step"},
    Gesture{kEverywhere, "Shift+drag in the timeline", "Loop over these steps (Shift+click: no more)"},
    Gesture{kEverywhere, "Click in a plot", "Show the step at that place"},
    Gesture{kWidget, "Enter", "Apply the value of a field, as leaving the field does"},
    Gesture{kWidget, "Esc", "Leave a field as it was, close a menu, leave a panel"},
    Gesture{kWidget, "Tab, Shift+Tab", "Next and previous field of the panel"},
    Gesture{kEverywhere, "Alt or F10", "Keyboard to the menus (arrows, letters, Enter, Esc)"},
    Gesture{kEverywhere, "Alt+F, Alt+E, ...", "Open the menu with this letter"},
    Gesture{kWidget, "Space, arrows, Ctrl+Tab", "Press, choose; next panel, once the keyboard is in one"},
    Gesture{kEverywhere, "Drop a file", "Open a project, layout, mesh, MuJoCo scene, saved step or data set"},
};

const char* key_name(int key) {
  switch (key) {
    case ImGuiKey_Equal:
      return "=";
    case ImGuiKey_Minus:
      return "-";
    case ImGuiKey_Slash:
      return "/";
    case ImGuiKey_LeftBracket:
      return "[";
    case ImGuiKey_RightBracket:
      return "]";
    case ImGuiKey_Period:
      return ".";
    case ImGuiKey_RightArrow:
      return "Right";
    case ImGuiKey_LeftArrow:
      return "Left";
    case ImGuiKey_UpArrow:
      return "Up";
    case ImGuiKey_DownArrow:
      return "Down";
    case ImGuiKey_Escape:
      return "Esc";
    default:
      return ImGui::GetKeyName(static_cast<ImGuiKey>(key));
  }
}

}  // namespace

std::span<const Gesture> gestures() {
  return kGestures;
}

std::string chord_name(int chord, const KeyNames& names) {
  if (chord == 0) return {};
  std::string text;
  if ((chord & ImGuiMod_Ctrl) != 0) text += "Ctrl+";
  if ((chord & ImGuiMod_Alt) != 0) text += "Alt+";
  if ((chord & ImGuiMod_Shift) != 0) text += "Shift+";
  const int key = chord & ~ImGuiMod_Mask_;
  const auto named = names.find(key);
  return text + (named != names.end() ? named->second : key_name(key));
}

std::string chord_names(const Binding& binding, const KeyNames& names) {
  const std::string first = chord_name(binding.chord, names), also = chord_name(binding.also, names);
  return also.empty() ? first : first + ", " + also;
}

const char* to_string(Context context) {
  switch (context) {
    case Context::everywhere:
      return "everywhere";
    case Context::layout:
      return "LAYOUT";
    case Context::simulate:
      return "SIMULATE";
    case Context::gesture:
      return "gesture";
    case Context::widget:
      return "field";
  }
  return "";
}

std::string bindings_as_text() {
  std::string text = fmt::format("{:<30} {:<12} {}\n", "KEY", "WHERE", "WHAT");
  for (const Binding& b : bindings()) {
    if (b.chord != 0) text += fmt::format("{:<30} {:<12} {}\n", chord_names(b), to_string(b.context), b.label);
  }
  for (const Gesture& g : kGestures) {
    text += fmt::format("{:<30} {:<12} {}\n", g.gesture, to_string(g.context), g.label);
  }
  return text;
}

}  // namespace taxel::ui
