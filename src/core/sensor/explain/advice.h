// Remedies for sampling noise, each checked by reading the same contacts again with the remedy.
#pragma once

#include <map>

#include "core/sensor/explain/explanation.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Returns the reading of the contact of a step by another model.
double reading_of(const SensorModel& model, int taxel, const SensorStep& step);

/// Multiples of the layout's number of samples that are tried, in this order.
inline constexpr std::array<double, 3> kTriedFactors{4, 16, 64};
/// Largest number of samples that is tried. With more samples an explanation would take too long.
inline constexpr double kMaxTriedSamples = 100'000;
/// A remedy brings the change below this fraction of the limit. The fraction is less than 1 because the limit is
/// relative to the taxel's largest reading, which changes a little with the samples too.
inline constexpr double kCureMargin = 0.9;

/// Models with more samples by factor, each built when it is first needed.
using DenserModels = std::map<double, SensorModelPtr>;

/// Reads both contacts with kTriedFactors times the samples until the change is below kCureMargin x limit. Returns the
/// first number of samples with such a change, or the largest number that was tried, or nothing if no model with more
/// samples could be built. A weighted_sum is scaled to the layout's number of samples. Throws Cancelled through
/// `progress`.
std::optional<SamplesNeeded> samples_that_cure(const SensorModelPtr& model, int taxel, const SensorStep& before,
                                               const SensorStep& now, double limit, DenserModels& made,
                                               SensorCache& cache, Progress* progress = nullptr);

/// Angle limits that are tried for a field that the limit cuts [degrees]; those below the layout's own are left out.
inline constexpr std::array<double, 5> kTriedAngles{60, 75, 90, 135, 180};

/// Returns the model without the angle limit of the receptive fields, for exact_reading() only: it has no samples of
/// its own.
SensorModel without_angle_limit(const SensorModel& model);

/// Reads both contacts with the limits of kTriedAngles until the change is below kCureMargin x limit. Returns the first
/// such limit, or the largest one that was tried, or nothing if none is larger than the layout's. Throws Cancelled
/// through `progress`.
std::optional<AngleTried> angle_that_cures(const SensorModelPtr& model, int taxel, const SensorStep& before,
                                           const SensorStep& now, double limit, SensorCache& cache,
                                           Progress* progress = nullptr);

/// Returns the change of the reading from `before` to `now` for the same samples with Voronoi weights.
double change_with_voronoi_weights(const SensorModel& model, int taxel, const SensorStep& before,
                                   const SensorStep& now);

}  // namespace taxel
