// The state of the interface that every panel and tool takes: widgets, fields and the commands posted in this frame.
#pragma once

#include <utility>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/frame/keymap.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// The widgets take only the Ui of it.
struct WindowUi : Ui {
  std::vector<Command> commands;  ///< commands posted in this frame, in order
  KeyNames key_names;             ///< names of keys in texts

  void post(Command command) { commands.push_back(std::move(command)); }
};

}  // namespace taxel::ui
