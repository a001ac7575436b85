// The plugin keys of a sensor that this program hands over.
#pragma once

#include <fmt/format.h>

#include <string>

#include "core/sensor/sensor_model.h"

namespace taxel {

/// Returns the keys, as MJCF, on which the size of a handed-over sensor's output and state depends: the number of its
/// taxels and, if its layout has friction that sticks, that friction.
inline std::string hosted_keys(const SensorModel& model) {
  const Material& material = model.layout.material;
  std::string keys = fmt::format(R"(<config key="taxels" value="{}"/>)", model.taxel_count());
  if (material.tangential_stiffness > 0)
    keys += fmt::format(R"(<config key="tangential_stiffness" value="{}"/><config key="bristles" value="{}"/>)",
                        material.tangential_stiffness, material.bristles);
  return keys;
}

}  // namespace taxel
