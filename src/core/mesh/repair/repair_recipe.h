// Recipe for the repair of a mesh file: plain values, those of the key /mesh/repair of a layout.
#pragma once

#include <optional>

namespace taxel {

/// How far a repair may go.
enum class RepairLevel {
  automatic,  ///< exact steps, and a wrap of the shells that they cannot close
  exact,      ///< exact steps only: a mesh that stays open is an error
  wrap,       ///< every shell is wrapped
  keep        ///< nothing is changed: a mesh that is not closed cannot be soft
};

/// How the mesh of a body that a skin touches is repaired.
enum class TouchedRepair {
  automatic,  ///< a soft mesh as the mesh of a skin, a rigid one by exact steps
  exact,      ///< exact steps only
  off         ///< nothing is changed
};

/// Lengths in metres. An empty value means its default, which depends on the diagonal d of the mesh's bounds.
struct RepairRecipe {
  RepairLevel level = RepairLevel::automatic;
  std::optional<double> join;         ///< largest distance over which rims are joined; 3e-4 d
  std::optional<double> fill;         ///< widest hole that is filled without a warning; 0.1 d
  std::optional<double> edge;         ///< edge length of a wrap; d/128, or more if that would take too long
  std::optional<double> tolerance;    ///< largest simplification error of a wrap; edge/6
  std::optional<double> refine;       ///< longest edge of a soft skin, in thicknesses of the pad; 2
  bool has_two_sided_sheets = false;  ///< a surface without an inside becomes two-sided: for rigid bodies
  bool operator==(const RepairRecipe&) const = default;
};
inline constexpr double kDefaultRefine = 2.0;

}  // namespace taxel
