// Choices of the user that complete a layout of another program.
#pragma once

#include <optional>
#include <string>

#include "core/base/math.h"

namespace taxel {

struct SkinChoice {
  std::string sensor = {};          ///< name or geom of the sensor, or empty for the first one
  std::string mesh = {};            ///< mesh file, or empty for the layout's own
  std::optional<dvec3> scale = {};  ///< factor from units of `mesh` to metres; guessed, with a note, if empty
  std::optional<double> unit = {};  ///< length of the unit of a layout file that names none [m]; 1 if empty
  bool operator==(const SkinChoice&) const = default;
};

}  // namespace taxel
