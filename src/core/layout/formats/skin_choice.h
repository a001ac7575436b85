// What the user chooses where a layout of another program leaves it open.
#pragma once

#include <optional>
#include <string>

#include "core/base/math.h"

namespace taxel {

struct SkinChoice {
  std::string sensor = {};          ///< its name or geom in a file that holds several; empty: the first
  std::string mesh = {};            ///< mesh file; empty: the layout's own
  std::optional<dvec3> scale = {};  ///< of `mesh` to metres; empty: guessed from the taxels, with a note
  bool operator==(const SkinChoice&) const = default;
};

}  // namespace taxel
