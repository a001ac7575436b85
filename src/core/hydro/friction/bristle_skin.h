// The points of a soft body's skin that carry bristles, and the shares of a contact that each of them bears.
#pragma once

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

/// Finds the roots near points of contact surfaces. Memory that only speeds up a step: the results do not depend on
/// earlier calls.
class BristleSearch {
 public:
  explicit BristleSearch(BristleSkinPtr skin) : skin_(std::move(skin)) {}

  [[nodiscard]] const BristleSkin& skin() const { return *skin_; }
  [[nodiscard]] const BristleSkinPtr& skin_pointer() const { return skin_; }
  /// Returns the shares of a point x, which add up to 1. They are continuous in x: with the distance d_i of root i and
  /// the least distance d, the share is proportional to (1 - (d_i^2 - d^2)/s^2)^2 where that bracket is positive; s^2
  /// is 0.4 of the square of the spacing. On flat skin it does not depend on the depth of x. Valid until the next call.
  std::span<const BristleShare> shares(const dvec3& x);

 private:
  [[nodiscard]] const std::vector<int>& candidates(const dvec3& x);

  BristleSkinPtr skin_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;  // roots that may have a share at a point of the cell
  std::vector<BristleShare> shares_;
};

}  // namespace taxel
