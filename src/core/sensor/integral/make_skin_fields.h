// Computes the receptive fields as functions on the skin.
#pragma once

#include "core/sensor/integral/skin_fields.h"

namespace taxel {

/// Computes the fields of a layout for an integral other than IntegralKind::none. `region` lists the sampled faces of
/// skin.mesh, ascending; empty for all. `depth` is SensorModel::max_depth [m].
SkinFieldsPtr make_skin_fields(const Layout& layout, const SensorSkin& skin, const std::vector<int>& region,
                               const HydroBody& body, double depth, IntegralKind kind);

}  // namespace taxel
