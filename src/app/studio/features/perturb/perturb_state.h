// The selected body in the hand.
#pragma once

#include <cstdint>

#include "core/run/controls.h"

namespace taxel::ui {

struct PerturbState {
  using PerDocument = PerturbState;          ///< another document resets all of it
  int geom = -1;                             ///< of SimScene::geoms, on which the selected body was clicked
  dvec3 point_G{0};                          ///< where
  Perturb::Kind kind = Perturb::Kind::none;  ///< while a button holds it
  int button = 0;                            ///< that one
  std::uint64_t grip = 0;                    ///< counts how often it was taken hold of
  dvec2 start{0};                            ///< of the pointer then [pixels of the view]
  dvec3 grabbed_W{0};                        ///< the point then
};

}  // namespace taxel::ui
