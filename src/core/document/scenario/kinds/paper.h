// The path of the paper's released demo: onto the demo's box, and back.
#pragma once

#include "core/document/scenario/kinds/kind_traits.h"

namespace taxel::scenarios {

struct Paper : Timed {
  static constexpr std::string_view kWord = "paper";
  static constexpr bool kHasObject = false;
  Paper() { record_interval = 0.025; }  // a step of the released demo

  template <class Self, class V>
  static void visit(Self&, const V&) {}
  bool operator==(const Paper&) const = default;
};

}  // namespace taxel::scenarios
