// The selected body and the drag that moves it.
#pragma once

#include <cstdint>

#include "core/run/controls.h"

namespace taxel::ui {

struct PerturbState {
  using PerDocument = PerturbState;          ///< another document resets all of it
  int geom = -1;                             ///< clicked geom of the selected body, index in SimScene::geoms, or -1
  dvec3 point_G{0};                          ///< clicked point, in the frame of the geom
  Perturb::Kind kind = Perturb::Kind::none;  ///< kind of the drag while a button is held
  int button = 0;                            ///< mouse button of the drag
  std::uint64_t grip = 0;                    ///< number of drags so far
  dvec2 start{0};                            ///< pointer at the start of the drag [pixels of the view]
  dvec3 grabbed_W{0};                        ///< grabbed point at the start of the drag
};

}  // namespace taxel::ui
