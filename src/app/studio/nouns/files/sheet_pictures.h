// The views of a layout for its printed sheet.
#pragma once

#include <vector>

#include "core/sensor/layout_sheet.h"
#include "ui/scene/scene_renderer.h"

namespace taxel::studio {

/// Draws the sensor from its pad, its back and both sides, which its frame defines, with the ids of its taxels.
std::vector<SheetPicture> sheet_pictures(ui::SceneRenderer& renderer, const SensorModelPtr& model);

}  // namespace taxel::studio
