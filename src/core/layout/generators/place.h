// Functions that all generators share: placing taxels on a skin, moving them there from another source, and checks of
// parameters.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Returns the unit normal of the smooth surface that the mesh approximates: vertex normals interpolated over the face
/// (Phong 1975), or the normal of the face if they cancel.
dvec3 smooth_normal(const TriMesh& mesh, const SurfacePoint& at);

/// Returns a taxel at a point of the skin, with the smooth normal there. `radius` is that of the receptive field [m].
Taxel taxel_on(const TriMesh& skin, const SurfacePoint& at, int id, double radius);

/// Rounds the centre to 0.1 micrometre and the normal to 1e-6, for files that people read.
Taxel rounded(Taxel taxel);

/// Treatment of the points of a pattern that are not over the skin.
enum class Beyond {
  refuse,    ///< the generator throws Error that names the first one
  leave_out  ///< they get no taxels; Error if no taxel is left
};
/// Returns the first point of the skin on a ray from outside. If the ray misses the mesh or begins inside it, returns
/// nothing for Beyond::leave_out, and otherwise throws Error(generator, where, ...); `where` is a parameter, or a row
/// and column.
std::optional<SurfacePoint> skin_under(const MeshIndex& skin, const dvec3& origin, const dvec3& direction,
                                       Beyond beyond, const std::string& generator, const std::string& where);

/// Throws Error if there are no taxels.
void require_some(const std::string& generator, const std::vector<Taxel>& taxels);

// Rules of parameters. Each throws Error(generator, parameter, ...) with the rule and the value.
void require_count(const std::string& generator, const std::string& parameter, int value);
void require_positive(const std::string& generator, const std::string& parameter, double value);
void require_finite(const std::string& generator, const std::string& parameter, const dvec3& value);
void require_finite(const std::string& generator, const std::string& parameter, double value);
/// Returns the unit vector of a direction. Throws Error unless the length is finite and not 0.
dvec3 require_direction(const std::string& generator, const std::string& parameter, const dvec3& value);

/// Largest number of taxels that one generator makes.
inline constexpr int kMaxGeneratedTaxels = 100'000;

/// Moves taxels from another source (a table, a drawing) onto a skin: returns them and their subtaxels at the nearest
/// points of the skin, with the smooth normals there. Ids, names, radii and order are unchanged. Throws Error("points",
/// "taxel ID", ...) for a taxel that is farther than `farthest` [m] from the skin (its unit may be wrong), or not
/// finite.
std::vector<Taxel> onto_skin(std::vector<Taxel> taxels, const MeshIndex& skin,
                             double farthest = std::numeric_limits<double>::infinity());

}  // namespace taxel
