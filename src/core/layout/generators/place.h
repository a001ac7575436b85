// What all generators share: a taxel on a skin, and the error that names what is wrong.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// The normal of the smooth surface that the mesh stands for: vertex normals interpolated over the face (Phong 1975).
/// Unit; the face's own normal where they cancel.
dvec3 smooth_normal(const TriMesh& mesh, const SurfacePoint& at);

/// A taxel at a point of the skin, with the smooth normal there. Radius of the receptive field in metres.
Taxel taxel_on(const TriMesh& skin, const SurfacePoint& at, int id, double radius);

/// For files that people read: the centre to 0.1 micrometre, the normal to 1e-6.
Taxel rounded(Taxel taxel);

/// What becomes of the points of a pattern that are not over the skin.
enum class Beyond {
  refuse,    ///< an Error names the first
  leave_out  ///< there are fewer taxels; an Error where none is left
};
/// The first point of the skin that a ray meets from outside. Where it misses the mesh or begins inside it: none for
/// Beyond::leave_out, else an Error headed by `generator` and `where` (a parameter, or the row and column).
std::optional<SurfacePoint> skin_under(const MeshIndex& skin, const dvec3& origin, const dvec3& direction,
                                       Beyond beyond, const std::string& generator, const std::string& where);

/// Throws for Beyond::leave_out where nothing is left.
void require_some(const std::string& generator, const std::vector<Taxel>& taxels);

/// Rules of parameters; each throws Error(generator, parameter, what it must be and is).
void require_count(const std::string& generator, const std::string& parameter, int value);
void require_positive(const std::string& generator, const std::string& parameter, double value);
void require_finite(const std::string& generator, const std::string& parameter, const dvec3& value);
void require_finite(const std::string& generator, const std::string& parameter, double value);
/// Returns the unit vector of a direction.
dvec3 require_direction(const std::string& generator, const std::string& parameter, const dvec3& value);

/// The most taxels that one generator makes.
inline constexpr int kMaxGeneratedTaxels = 100'000;

}  // namespace taxel
