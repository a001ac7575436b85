// Taxels placed on a skin or moved onto it, and the rules of parameters.

#include "core/layout/generators/place.h"

#include <fmt/format.h>

#include "core/mesh/query/triangle.h"

namespace taxel {

dvec3 smooth_normal(const TriMesh& mesh, const SurfacePoint& at) {
  return skin_normal_at_weights(mesh, at.face, at.barycentric);
}

Taxel taxel_on(const TriMesh& skin, const SurfacePoint& at, int id, double radius) {
  Taxel taxel;
  taxel.id = id;
  taxel.center = at.position;
  taxel.normal = smooth_normal(skin, at);
  taxel.radius = radius;
  return taxel;
}

Taxel rounded(Taxel taxel) {
  const double per_metre = 1e7, per_unit = 1e6;
  taxel.center = glm::round(taxel.center * per_metre) / per_metre + 0.0;  // + 0 replaces -0 by 0
  taxel.normal = glm::round(taxel.normal * per_unit) / per_unit + 0.0;
  return taxel;
}

std::optional<SurfacePoint> skin_under(const MeshIndex& skin, const dvec3& origin, const dvec3& direction,
                                       Beyond beyond, const std::string& generator, const std::string& where) {
  const std::optional<MeshHit> hit = skin.cast({origin, direction});
  const TriMesh& mesh = skin.mesh();
  if (hit && !(glm::dot(mesh.face_normals()[static_cast<std::size_t>(hit->face)], direction) > 0.0)) {
    SurfacePoint at;
    at.face = hit->face;
    at.barycentric = hit->barycentric;
    for (int c = 0; c < 3; ++c) at.position += hit->barycentric[c] * mesh.vertex(hit->face, c);
    return at;
  }
  if (beyond == Beyond::leave_out) return std::nullopt;
  throw Error(
      generator, where,
      fmt::format("the ray from [{:.6g}, {:.6g}, {:.6g}] along [{:.4g}, {:.4g}, {:.4g}] {}", origin.x, origin.y,
                  origin.z, direction.x, direction.y, direction.z, hit ? "begins inside the mesh" : "misses the mesh"));
}

void require_some(const std::string& generator, const std::vector<Taxel>& taxels) {
  if (taxels.empty()) throw Error(generator, "no point of the pattern lies over the skin");
}

void require_count(const std::string& generator, const std::string& parameter, int value) {
  if (value < 1) throw Error(generator, parameter, fmt::format("must be at least 1, is {}", value));
  if (value > kMaxGeneratedTaxels)
    throw Error(generator, parameter, fmt::format("must be at most {}, is {}", kMaxGeneratedTaxels, value));
}

void require_positive(const std::string& generator, const std::string& parameter, double value) {
  if (!(value > 0.0) || !std::isfinite(value))
    throw Error(generator, parameter, fmt::format("must be finite and greater than 0, is {}", value));
}

void require_finite(const std::string& generator, const std::string& parameter, double value) {
  if (!std::isfinite(value)) throw Error(generator, parameter, fmt::format("must be finite, is {}", value));
}

void require_finite(const std::string& generator, const std::string& parameter, const dvec3& value) {
  if (!is_finite(value))
    throw Error(generator, parameter, fmt::format("must be finite, is [{}, {}, {}]", value.x, value.y, value.z));
}

dvec3 require_direction(const std::string& generator, const std::string& parameter, const dvec3& value) {
  require_finite(generator, parameter, value);
  const double length = glm::length(value);
  if (!(length > 0.0) || !std::isfinite(length))
    throw Error(generator, parameter, fmt::format("must be a direction, is [{}, {}, {}]", value.x, value.y, value.z));
  return value / length;
}

namespace {

template <class T>
void bring(T& disc, const MeshIndex& skin, double farthest, const std::string& where) {
  require_finite("points", where, disc.center);
  const SurfacePoint at = skin.closest_point(disc.center);
  if (at.distance > farthest)
    throw Error("points", where,
                fmt::format("is {:.4g} m from the surface, more than {:.4g} m: is the unit another one?", at.distance,
                            farthest));
  disc.center = at.position;
  disc.normal = smooth_normal(skin.mesh(), at);
}

}  // namespace

std::vector<Taxel> onto_skin(std::vector<Taxel> taxels, const MeshIndex& skin, double farthest) {
  for (Taxel& taxel : taxels) {
    bring(taxel, skin, farthest, fmt::format("taxel {}", taxel.id));
    for (std::size_t i = 0; i < taxel.subtaxels.size(); ++i)
      bring(taxel.subtaxels[i], skin, farthest, fmt::format("taxel {}, subtaxel {}", taxel.id, i));
  }
  return taxels;
}

}  // namespace taxel
