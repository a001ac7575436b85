// What fields of the interface remember between two pictures: what was refused in which, and who has the keyboard.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace taxel::ui {

struct FieldInput {
  std::string field;  ///< its name in the registry of widgets
  std::string typed;  ///< empty for what is chosen, not typed
};

/// What was typed and could not be: the field keeps it and says why, the document stays as it is.
struct Refusal {
  FieldInput input;
  std::string words;
  std::vector<int> selection;  ///< ids of the taxels that it was about
};

struct FieldState {
  FieldInput last;             ///< taken over last
  std::vector<int> selection;  ///< ids of the taxels that the fields are about
  std::optional<Refusal> refused;
  bool had_keys = false;       ///< a field or a popup had the keyboard when the picture before ended
  std::string keyboard_panel;  ///< title of the panel whose widgets Tab, Space and the arrows work on; empty: none
  std::string entered_panel;   ///< the keyboard goes there in the next picture
  int entering = 0;            ///< pictures until it has arrived
};

}  // namespace taxel::ui
