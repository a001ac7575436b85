// Choices of the user that replace parts of a layout's readout.
#pragma once

#include <optional>

#include "core/layout/layout.h"
#include "core/layout/words.h"

namespace taxel {

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

}  // namespace taxel
