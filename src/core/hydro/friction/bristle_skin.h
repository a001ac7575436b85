// The points of a soft body's skin that carry bristles, and the shares of a contact that each of them bears.
#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/hydro/fields/pressure_field.h"

namespace taxel {

/// Roots of bristles: material points spread evenly over the skin of a pressure field. Immutable.
class BristleSkin {
 public:
  /// Spreads `count` roots by farthest-point sampling (Gonzalez 1985). The roots are equal for equal fields. Throws
  /// Error if the field has no skin or `count` is below 1.
  BristleSkin(const PressureField& field, int count);

  [[nodiscard]] const std::vector<dvec3>& roots() const { return roots_; }  ///< frame of the field [m]
  /// Distance within which each point of the skin has a root [m].
  [[nodiscard]] double spacing() const { return spacing_; }
  /// Length s of the shares, see BristleSearch::shares() [m]. With a shorter one they would follow the pressure better,
  /// and with a longer one they would change more slowly where a contact slides.
  [[nodiscard]] double reach() const { return std::sqrt(0.4) * spacing_; }

 private:
  std::vector<dvec3> roots_;
  double spacing_ = 0;
};
using BristleSkinPtr = std::shared_ptr<const BristleSkin>;

/// Part of a point's load that a root bears.
struct BristleShare {
  int root = 0;
  double part = 0;
};

/// Returns the share of a root at a distance d_i from a point, before division by the sum: (1 - (d_i^2 - d^2)/s^2)^2
/// where the bracket is positive, with the least distance d of a root and s = BristleSkin::reach(). It is continuous in
/// the place of the point.
inline double share_of(double squared_distance, double least_squared_distance, double reach) {
  const double bracket = 1 - (squared_distance - least_squared_distance) / (reach * reach);
  return bracket > 0 ? bracket * bracket : 0;
}

/// Finds the roots near points of contact surfaces. Memory that only speeds up a step: the results do not depend on
/// earlier calls.
class BristleSearch {
 public:
  explicit BristleSearch(BristleSkinPtr skin) : skin_(std::move(skin)) {}

  [[nodiscard]] const BristleSkin& skin() const { return *skin_; }
  [[nodiscard]] const BristleSkinPtr& skin_pointer() const { return skin_; }
  /// Returns the shares of a point x, which add up to 1, by share_of(). On flat skin they do not depend on the depth of
  /// x. Valid until the next call.
  std::span<const BristleShare> shares(const dvec3& x);

 private:
  [[nodiscard]] const std::vector<int>& candidates(const dvec3& x);

  BristleSkinPtr skin_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;  // roots that may have a share at a point of the cell
  std::vector<BristleShare> shares_;
};

}  // namespace taxel
