#include "core/sensor/integral/make_skin_fields.h"

#include "core/sensor/integral/pressure_integral.h"

namespace taxel {

SkinFieldsPtr make_skin_fields(const Layout& layout, const SensorSkin& skin, const std::vector<int>& region,
                               const HydroBody& body, double depth, IntegralKind kind) {
  auto weights = std::make_shared<const FieldWeights>(layout, *skin.sensed);
  auto fields = std::make_shared<SkinFields>(SkinFields{weights, FaceFields(weights, skin.sensed->mesh()), {}, {}, {}});
  if (kind == IntegralKind::force) {
    // The tets of a pad end at its thickness. Where contact is deeper, guesses are not worth their lists.
    const double thickness = body.material.thickness;
    fields->nearest.emplace(*skin.sensed, thickness > 0 ? std::min(thickness, depth) : depth);
  } else {
    fields->prisms.emplace(skin, region, fields->faces, body, depth);
    fields->whole = PressureIntegral::of_whole_fields(*fields, static_cast<int>(layout.taxels.size()),
                                                      kind == IntegralKind::weighted_mean);
  }
  return fields;
}

}  // namespace taxel
