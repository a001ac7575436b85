// The data sheet from which the inspector computes the modulus of a pad.
#pragma once

#include <optional>
#include <string>

#include "core/hydro/material/pad_modulus.h"

namespace taxel::ui {

struct MaterialState {
  using PerDocument = MaterialState;                     ///< another document resets all of it
  bool is_open = false;                                  ///< whether the fields are shown
  std::string preset;                                    ///< word of the elastomer of `layer`, or empty
  ElasticLayer layer{60e3, 0.49, 0, LayerBase::bonded};  ///< thickness 0: that of the layout
  std::optional<double> contact_radius;                  ///< radius for which the force is right [m]; empty: wide
  std::optional<PadModulus> result;                      ///< nothing if the values are bad, or not yet computed
  std::string problem;                                   ///< reason why there is no result
};

}  // namespace taxel::ui
