// A repair of a problem: an edit and the text that offers it.
#pragma once

#include <string>

#include "core/document/edit.h"

namespace taxel {

struct Fix {
  std::string words;  ///< text of a button: "Move taxel 3 to the surface, by 0.8 mm"
  Edit edit;
};

}  // namespace taxel
