// Mirror images of taxels, and pairs of taxels that are images of each other.
//
// Twins are found without a given plane: it is across `distal` and `pad`, through the middle of all taxels or through
// the origin, whichever leaves fewer taxels without a twin. A pair counts if each of the two is nearest to the image of
// the other, and nearer than half of its radius; a taxel near the plane that is nearest to its own image has no twin.
// Cost: O(n^2) distances for n taxels.
#include "core/layout/generators/mirror.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/layout/generators/place.h"

namespace taxel {
namespace {

/// Mirrors points: x' = x - 2 ((x - p) . n) n with a unit vector n. For directions, p = 0.
dvec3 reflected(const dvec3& x, const dvec3& p, const dvec3& n) {
  return x - 2.0 * glm::dot(x - p, n) * n;
}

template <class T>
void reflect(T& disc, const dvec3& p, const dvec3& n) {
  disc.center = reflected(disc.center, p, n);
  disc.normal = reflected(disc.normal, dvec3(0), n);
}

/// Returns the twins on the other side of a plane through `p` with the unit normal `n`; see mirror_twins().
std::vector<int> twins_by_plane(const Layout& layout, std::span<const std::size_t> taxels, const dvec3& p,
                                const dvec3& n) {
  std::vector<int> nearest(taxels.size(), -1);
  for (std::size_t i = 0; i < taxels.size(); ++i) {
    const Taxel& taxel = layout.taxels[taxels[i]];
    const dvec3 image = reflected(taxel.center, p, n);
    double least = std::min(0.5 * taxel.radius, glm::distance(image, taxel.center));
    for (std::size_t j = 0; j < taxels.size(); ++j) {
      const double distance = glm::distance(image, layout.taxels[taxels[j]].center);
      if (j != i && distance < least) least = distance, nearest[i] = static_cast<int>(j);
    }
  }
  std::vector<int> twins = nearest;
  for (std::size_t i = 0; i < twins.size(); ++i)
    if (twins[i] >= 0 && nearest[static_cast<std::size_t>(twins[i])] != static_cast<int>(i)) twins[i] = -1;
  return twins;
}

}  // namespace

Layout mirrored_layout(Layout layout, int axis) {
  dvec3 normal(0);
  normal[axis] = 1;
  layout.mesh.scale[axis] = -layout.mesh.scale[axis];
  layout.taxels = mirror_images(layout.taxels, {dvec3(0), normal});
  layout.frame = {reflected(layout.frame.distal, dvec3(0), normal), reflected(layout.frame.pad, dvec3(0), normal)};
  layout.name = mirrored_name(layout.name);
  return layout;
}

std::vector<int> mirror_twins(const Layout& layout, std::span<const std::size_t> taxels) {
  const dvec3 across = glm::cross(layout.frame.distal, layout.frame.pad);
  std::vector<int> best(taxels.size(), -1);
  if (!(glm::length(across) > 0)) return best;
  dvec3 middle(0);
  for (const Taxel& taxel : layout.taxels) middle += taxel.center / static_cast<double>(layout.taxels.size());
  for (const dvec3& point : {middle, dvec3(0)}) {
    std::vector<int> twins = twins_by_plane(layout, taxels, point, glm::normalize(across));
    if (std::count(twins.begin(), twins.end(), -1) < std::count(best.begin(), best.end(), -1)) best = std::move(twins);
  }
  return best;
}

std::string mirrored_name(const std::string& name) {
  const std::string left = "left", right = "right";
  if (const std::size_t at = name.find(left); at != std::string::npos)
    return std::string(name).replace(at, left.size(), right);
  if (const std::size_t at = name.find(right); at != std::string::npos)
    return std::string(name).replace(at, right.size(), left);
  return name.empty() ? name : name + " mirrored";
}

std::vector<Taxel> mirror_images(const std::vector<Taxel>& taxels, const MirrorPlane& plane) {
  require_finite("mirror", "point", plane.point);
  const dvec3 n = require_direction("mirror", "normal", plane.normal);
  std::vector<Taxel> images = taxels;
  for (Taxel& image : images) {
    reflect(image, plane.point, n);
    for (Subtaxel& subtaxel : image.subtaxels) reflect(subtaxel, plane.point, n);
  }
  return images;
}

std::vector<Taxel> with_mirror_images(const std::vector<Taxel>& taxels, const MirrorPlane& plane, double tolerance) {
  if (!(tolerance >= 0.0) || !std::isfinite(tolerance))
    throw Error("mirror", "tolerance", fmt::format("must be finite and 0 or more, is {}", tolerance));
  int next_id = 0;
  for (const Taxel& taxel : taxels) {
    if (taxel.id == std::numeric_limits<int>::max()) throw Error("mirror", "id", "no id is left after the largest");
    next_id = std::max(next_id, taxel.id + 1);
  }
  std::vector<Taxel> all = taxels;
  for (Taxel& image : mirror_images(taxels, plane)) {
    const bool has_image = std::any_of(taxels.begin(), taxels.end(), [&](const Taxel& taxel) {
      return glm::distance(taxel.center, image.center) <= tolerance;
    });
    if (has_image) continue;
    if (next_id < 0) throw Error("mirror", "id", "no id is left after the largest");
    image.id = next_id;
    next_id = next_id == std::numeric_limits<int>::max() ? -1 : next_id + 1;
    image.name = mirrored_name(image.name);
    all.push_back(std::move(image));
  }
  return all;
}

}  // namespace taxel
