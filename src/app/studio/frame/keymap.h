// Table of key bindings and commands, with the names of keys and further words for commands. It drives menus, keys, the
// command palette, F1 help and --list-bindings.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/studio/frame/command.h"

namespace taxel::ui {

/// ImGui's key to its name on the user's keyboard, for keys whose name differs from a US keyboard.
using KeyNames = std::map<int, std::string>;

struct App;

/// Context in which a key is valid: that of SIMULATE is valid in ANALYSE as well. Priority: running gesture, focused
/// widget, mode, everywhere.
enum class Context { everywhere, layout, simulate, gesture, widget };
inline constexpr auto kEverywhere = Context::everywhere, kLayout = Context::layout, kSimulate = Context::simulate,
                      kGesture = Context::gesture, kWidget = Context::widget;

/// One command that a key, a menu or the palette offers.
struct Binding {
  using Test = bool (*)(const App& app);
  Command command;
  Context context = kEverywhere;
  int chord = 0;  ///< an ImGuiKeyChord, or 0 if only a menu offers the command
  const char* label = "";
  Test enabled = nullptr;  ///< whether the command can be carried out now; null if always
  /// Whether the menu entry is ticked. If null, is_checked() decides by the command.
  Test checked = nullptr;
  bool repeats = false;        ///< whether the command repeats while the key is down
  int also = 0;                ///< a second chord, or 0
  const char* menu = nullptr;  ///< "Menu" or "Menu/Submenu", or null if no menu lists it
  bool separated = false;      ///< whether a line separates the entry from the one above it in the menu
  /// Returns why the command is disabled, for a tooltip; null if its label says enough.
  const char* (*why_disabled)(const App& app) = nullptr;
  const char* needs = nullptr;  ///< condition under which the command is enabled, as a sentence; null if always
};
/// Returns all rows. A menu lists its entries in this order.
std::span<const Binding> bindings();

/// Returns the row of a command, which must have one.
[[nodiscard]] const Binding& binding_of(const Command& command);

/// One row of the help: a mouse gesture, or keys that are not bound to a command.
struct Gesture {
  Context context;
  const char* gesture;
  const char* label;
};
std::span<const Gesture> gestures();

/// Returns "Ctrl+Shift+S"; empty for 0. Keys that are not in `names` have their names on a US keyboard. Needs no ImGui
/// context.
std::string chord_name(int chord, const KeyNames& names = {});
/// Returns both chords of a row: "Ctrl+Y, Ctrl+Shift+Z".
std::string chord_names(const Binding& binding, const KeyNames& names = {});
const char* to_string(Context context);

/// Returns all keys and gestures as aligned text, as --list-bindings prints it: with the names of a US keyboard.
std::string bindings_as_text();

/// Returns further words by which people look for the command, field, gesture or heading with this label, in lower case
/// and separated by spaces or commas; empty if there are none.
[[nodiscard]] std::string_view synonyms_of(std::string_view label);
/// Returns the labels with synonyms.
[[nodiscard]] std::vector<std::string_view> labels_with_synonyms();

}  // namespace taxel::ui
