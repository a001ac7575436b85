#include "core/sensor/explain/exact_reading.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/sensor/readout/aggregate.h"

namespace taxel {

ExactReading exact_reading(const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces,
                           const ExactOptions& how) {
  if (taxel < 0 || taxel >= model.taxel_count())
    throw Error(fmt::format("there is no taxel {}, the layout has {}", taxel, model.taxel_count()));
  return aggregate_spec(model.layout.readout.aggregate).exact(model, taxel, surfaces, how);
}

}  // namespace taxel
