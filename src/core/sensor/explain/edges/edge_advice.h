// Remedies for jumps at mesh edges, each checked by reading the same contacts again with the remedy.
#pragma once

#include <array>
#include <vector>

#include "core/sensor/explain/edges/setting_tried.h"
#include "core/sensor/sensor_step.h"

namespace taxel {

/// Widths of the roll-off below the angle limit that are tried [degrees]; those up to the layout's own are left out.
inline constexpr std::array<double, 3> kTriedFalloffs{10, 20, 40};
/// Factors of the taxel's radius that are tried.
inline constexpr std::array<double, 2> kTriedRadii{1.5, 2};

/// Returns the readings without the jumps of the faces' normals: the model's own, with the normals that the angle
/// refers to interpolated over the faces, for exact_reading() only. The result has no samples of its own.
SensorModel with_interpolated_angles(const SensorModel& model);

/// Reads both contacts with other settings until the change is below kCureMargin x limit: interpolated normals, a
/// roll-off over them, rays along the taxel's normal, exact readings, a larger radius. Only settings that the layout
/// does not have and that its aggregate allows are tried. Throws Cancelled through `progress`.
std::vector<SettingTried> settings_against_edges(const SensorModelPtr& model, int taxel, const SensorStep& before,
                                                 const SensorStep& now, double limit, SensorCache& cache,
                                                 Progress* progress = nullptr);

}  // namespace taxel
