// State of the interface's fields from frame to frame: the refused input, and the widget that has the keyboard.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace taxel::ui {

/// Input of the user in one field.
struct FieldInput {
  std::string field;  ///< name of the field in the registry of widgets
  std::string typed;  ///< typed text; empty for a choice
};

/// Typed text that is not valid. The field keeps the text and displays the reason, and the document does not change.
struct Refusal {
  FieldInput input;
  std::string words;           ///< reason, displayed below the field
  std::vector<int> selection;  ///< ids of the taxels that were being edited
};

/// State of all fields.
struct FieldState {
  FieldInput last;                 ///< last accepted input
  std::vector<int> selection;      ///< ids of the taxels that the fields edit
  std::optional<Refusal> refused;  ///< last refused input
  bool in_menus = false;           ///< whether the menu bar has the keyboard
  bool had_keys = false;           ///< a field, a popup or the menu bar had the keyboard at the end of the last frame
  std::string keyboard_panel;      ///< title of the panel with keyboard navigation; empty if there is none
  std::string entered_panel;       ///< title of the panel that gets keyboard navigation in the next frame
  int entering = 0;                ///< frames until that panel has the keyboard
};

}  // namespace taxel::ui
