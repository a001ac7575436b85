// The replay: the finger takes the poses of a recording, step by step.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/document/scenario/kinds/kind_traits.h"

namespace taxel::scenarios {

struct Replay : Timed {
  static constexpr std::string_view kWord = "replay";
  static constexpr bool kHasPoses = true, kHasTimestep = false;
  std::string source = {};  ///< folder of a recording, or its .npz file

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(FieldSpec{"source", "Recording", "A folder of taxel sweep, play or run, or its readings.npz",
                FieldQuantity::file},
      self.source);
  }
  void check(ObjectShape) const {
    if (source.empty()) throw Error("", "/source", "a replay needs a recording: a folder or its .npz");
  }
  bool operator==(const Replay&) const = default;
};

}  // namespace taxel::scenarios
