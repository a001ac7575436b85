// What is recommended against sampling noise: read again with it, and only then said.
#pragma once

#include <map>

#include "core/sensor/explain/explanation.h"

namespace taxel {

/// Multiples of the layout's samples that are tried, in this order.
inline constexpr std::array<double, 3> kTriedFactors{4, 16, 64};
/// More samples than this are not tried: an explanation would take too long.
inline constexpr double kMaxTriedSamples = 100'000;
/// A cure brings the change below this part of the limit, because the taxel's largest reading, to which the limit is
/// relative, changes a little with the samples too.
inline constexpr double kCureMargin = 0.9;

/// Models with more samples, by factor; made when they are needed first.
using DenserModels = std::map<double, SensorModelPtr>;

/// Reads both contacts with 4, 16 and 64 times the samples until the change stays below kCureMargin x limit. Returns
/// the first number of samples that does, otherwise the largest that was tried; nothing if none could be. A weighted
/// sum is scaled to the layout's number of samples. Throws Cancelled through `progress`.
std::optional<SamplesNeeded> samples_that_cure(const SensorModelPtr& model, int taxel, const SensorStep& before,
                                               const SensorStep& now, double limit, DenserModels& made,
                                               SensorCache& cache, Progress* progress = nullptr);

/// The reading's change from `before` to `now` of the same samples with Voronoi weights.
double change_with_voronoi_weights(const SensorModel& model, int taxel, const SensorStep& before,
                                   const SensorStep& now);

}  // namespace taxel
