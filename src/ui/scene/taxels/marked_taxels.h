// The taxels that have an arrow and an id in the view.
#pragma once

#include <vector>

#include "ui/scene/sensor_view.h"

namespace taxel::ui {

/// Largest number of taxels with an arrow while overlays.all_taxels is off. More arrows than these hide the contact.
inline constexpr int kMaxMarkedTaxels = 60;
/// Smallest reading of a responding taxel, as a fraction of the range of the readings.
inline constexpr double kRespondingPart = 0.02;
/// Height above a taxel's centre of the point that decides how the taxel is seen, in parts of its radius.
inline constexpr double kSightLift = 0.2;

/// Returns whether the reading of a taxel is large enough to be seen.
[[nodiscard]] bool is_responding(const SceneInput& input, const SensorView& view, int taxel);
/// Returns whether the pointer is on a taxel.
[[nodiscard]] bool is_hovered(const SceneInput& input, const SensorView& view, int taxel);

/// Returns the taxels with an arrow and an id, ascending, one list for each view. Hidden taxels have none. With
/// overlays.all_taxels these are all others. Otherwise these are the hovered, the selected and the responding ones, at
/// most kMaxMarkedTaxels of all sensors together: first the hovered and the selected ones, then those with the largest
/// readings; equal readings in the order of the taxels.
[[nodiscard]] std::vector<std::vector<int>> marked_taxels(const SceneInput& input,
                                                          const std::vector<SensorView>& views);

/// How a taxel is seen from the eye.
enum class Sighting {
  clear,   ///< nothing is in front of the taxel, and it faces the eye
  behind,  ///< the taxel faces away, or a transparent skin is in front of it
  hidden   ///< a solid body is in front of it, or an opaque skin
};
/// Returns how a taxel is seen, at a point just above its centre, which may lie a little below the skin. Cost: one ray
/// through all skins and solid bodies.
[[nodiscard]] Sighting sighting(const SceneInput& input, const std::vector<SensorView>& views, const SensorView& view,
                                int taxel, const dvec3& eye_W);

}  // namespace taxel::ui
