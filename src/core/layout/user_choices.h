// Choices of the user on top of a layout: of its readout, which they replace in part, and of the skin under a layout of
// another program.
#pragma once

#include <optional>
#include <string>

#include "core/base/math.h"
#include "core/layout/layout.h"
#include "core/layout/words.h"

namespace taxel {

/// Replaces parts of a layout's readout.
struct ReadoutChoice {
  std::optional<Aggregate> aggregate = {};
  std::optional<ReadingMethod> method = {};

  [[nodiscard]] bool is_empty() const { return !aggregate && !method; }

  /// Returns a readout with these choices. An aggregate without an exact method is read by samples unless a method is
  /// chosen as well.
  [[nodiscard]] Readout applied_to(Readout readout) const {
    readout.aggregate = aggregate.value_or(readout.aggregate);
    if (aggregate && !has_exact_method(*aggregate)) readout.method = ReadingMethod::samples;
    readout.method = method.value_or(readout.method);
    return readout;
  }
};

/// Completes a layout of another program.
struct SkinChoice {
  std::string sensor = {};          ///< name or geom of the sensor, or empty for the first one
  std::string mesh = {};            ///< mesh file, or empty for the layout's own
  std::optional<dvec3> scale = {};  ///< factor from units of `mesh` to metres; guessed, with a note, if empty
  std::optional<double> unit = {};  ///< length of the unit of a layout file that names none [m]; 1 if empty
  bool operator==(const SkinChoice&) const = default;
};

}  // namespace taxel
