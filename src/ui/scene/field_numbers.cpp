#include "ui/scene/field_numbers.h"

#include <algorithm>

#include "ui/scene/color_map.h"

namespace taxel::ui {

namespace {
constexpr glm::vec3 kWarning(0.90f, 0.16f, 0.45f);  // a colour that no map has
}

glm::vec3 overlap_color(int taxels) {
  if (taxels <= 0) return kWarning;
  return kColorMaps.front().at(0.12 + 0.88 * (std::min(taxels, kMostOverlap) - 1) / (kMostOverlap - 1));
}

glm::vec3 euclidean_only_color() {
  return kWarning;
}

glm::vec3 normal_color(double angle_deg, double limit_deg) {
  return angle_deg > limit_deg ? kWarning
                               : kColorMaps.front().at(limit_deg > 0 ? 0.2 + 0.8 * angle_deg / limit_deg : 0.2);
}

}  // namespace taxel::ui
