// The state of the help about keys and mouse: the text that its rows are searched for.
#pragma once

#include <string>

namespace taxel::ui {

struct HelpState {
  std::string typed;
};

}  // namespace taxel::ui
