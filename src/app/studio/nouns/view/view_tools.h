// The pointer in the 3-D view, where no other tool takes it.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

extern const Feature kClicks;      ///< counts the clicks in the view
extern const Feature kWheel;       ///< the wheel zooms, or changes a size of the tool in use
extern const Feature kGizmo;       ///< a click on an axis looks along it
extern const Feature kPlaceTaxel;  ///< a click with Ctrl places a taxel
extern const Feature kSelection;   ///< a click selects, a double click centres the camera

}  // namespace taxel::ui
