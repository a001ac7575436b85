// Samples of a taxel that would read a back face of a thin body if contact surfaces did not leave it out.
#pragma once

#include "core/sensor/explain/explanation.h"

namespace taxel {

/// Returns the number of samples of taxel number `taxel` whose rays meet a back face (hydro/kernel/front_weight.h)
/// before the polygon that they read, or read one that counts in part.
int count_samples_at_back_faces(const SensorModel& model, int taxel, const SensorStep& step);

/// Returns the sentence on back faces in the taxel's field, or nothing if there are none.
std::string back_faces_text(const Explanation& explanation);

}  // namespace taxel
