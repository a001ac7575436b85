// The state of menus and command palette under the keyboard, the help about keys and mouse, and the status line.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"

namespace taxel::ui {

/// The state of the menu bar under the keyboard.
struct MenuKeys {
  bool on = false;          ///< whether the menu bar has the keyboard
  int menu = 0;             ///< index of the marked or open menu
  int asked = -1;           ///< index of the menu that opens in this frame, or -1
  bool open = false;        ///< whether a menu of the bar is open
  bool on_submenu = false;  ///< whether the marked entry is the title of a submenu
  bool alt_alone = false;   ///< whether Alt went down, and no other key or button since
  int before = 0;           ///< number of open popups at the begin of the last frame
  int after = 0;            ///< number of open popups after the menus of the last frame
  unsigned window = 0;      ///< ImGui's id of the window that had the keyboard before, or 0
};

struct Found;
/// All entries of the command palette.
using FoundEntries = std::shared_ptr<const std::vector<Found>>;

/// The state of the command palette.
struct PaletteState {
  bool open = false;
  bool wants_focus = false;  ///< whether the text field gets the keyboard in the next frame
  std::string typed;
  int chosen = 0;                       ///< index in the displayed list
  std::optional<std::string> searched;  ///< text that `found` belongs to; nothing before the first search
  std::vector<std::size_t> found;       ///< indices of the entries that it matches, best first
  KeyNames key_names;                   ///< names of keys in `entries`
  FoundEntries entries;                 ///< all that can be found, or null before the first search
};

struct HelpState {
  std::string typed;  ///< text that the rows are searched for
};

/// One row of the help.
struct HelpRow {
  std::string keys, where;
  std::string label;
};

/// Returns the rows in which each word of `typed` begins a word of the label, of its synonyms, of the keys, or of the
/// context. Case is ignored. An empty text matches all rows.
[[nodiscard]] std::vector<HelpRow> find_help(std::string_view typed, const KeyNames& names = {});

/// The window with all keys and mouse gestures, and a field that searches them.
extern const Feature kHelp;

/// The window about the program: version, purpose and licence.
extern const Feature kAbout;

/// Returns "0.98 x real time", or a word for a run that is paused, has ended or waits for polished samples. Empty
/// without a scene, and while a run plays in script mode.
std::string pace_text(const Shown& shown);

/// The line at the bottom of the window: rates, force, counts, messages.
extern const Feature kStatusLine;

}  // namespace taxel::ui
