// The press: the finger moves down to a depth, rests, and moves up.
#pragma once

#include "core/document/scenario/kinds/pressed.h"

namespace taxel::scenarios {

struct Press : Pressed {
  static constexpr std::string_view kWord = "press";
  template <class Self, class V>
  static void visit_at_depth(Self&, const V&) {}
  bool operator==(const Press&) const = default;
};

}  // namespace taxel::scenarios
