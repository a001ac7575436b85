// Mirrored taxels: their links, and the edits that follow them.
#include "core/document/edit_impl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/base/error.h"
#include "core/layout/field/overlap.h"
#include "core/layout/field/point_grid.h"
#include "core/layout/generators/place.h"

namespace taxel {
namespace {

std::optional<int> twin_across(const Mirror& mirror, int id) {
  for (const MirrorLink& link : mirror.links) {
    if (link.taxel == id) return link.image;
    if (link.image == id) return link.taxel;
  }
  return std::nullopt;
}

std::unordered_map<int, int> twins_across(const Mirror& mirror) {
  std::unordered_map<int, int> twins;
  for (const MirrorLink& link : mirror.links) {
    twins.emplace(link.taxel, link.image);
    twins.emplace(link.image, link.taxel);
  }
  return twins;
}

void take_image(const Taxel& of, const MirrorPlane& plane, const ChangedFields& fields, Taxel& twin) {
  Taxel image = mirror_images({of}, plane).front();
  if (fields.center) twin.center = image.center;
  if (fields.normal) twin.normal = image.normal;
  if (fields.radius) twin.radius = image.radius;
  if (fields.subtaxels) twin.subtaxels = std::move(image.subtaxels);
  if (fields.density) twin.density = image.density;
}

/// Returns the links across this plane, after adding the plane if it is new.
Mirror& mirror_of(Project& project, const MirrorPlane& plane) {
  for (Mirror& mirror : project.mirrors)
    if (mirror.plane == plane) return mirror;
  return project.mirrors.emplace_back(Mirror{plane, {}});
}

/// Returns a taxel that nearly covers its own image, moved into the plane. Empty for all other taxels.
std::optional<Taxel> in_plane_of(const Taxel& taxel, const MirrorPlane& plane) {
  const dvec3 n = glm::normalize(plane.normal);
  const double away = glm::dot(taxel.center - plane.point, n);
  if (!(disc_overlap(taxel.radius, taxel.radius, 2.0 * std::abs(away)) > kLargeOverlap)) return std::nullopt;
  const dvec3 along = taxel.normal - glm::dot(taxel.normal, n) * n;
  const double least = 0.5 * std::numbers::sqrt2 * glm::length(taxel.normal);  // 45 degrees from the plane
  if (!(glm::length(along) > least)) return std::nullopt;  // the normal points across the plane: a pair
  Taxel moved = taxel;
  moved.center -= away * n;
  moved.normal = glm::normalize(along);
  for (Subtaxel& subtaxel : moved.subtaxels) subtaxel.center -= away * n;
  return moved;
}

/// Returns true if a taxel is on the skin with the skin's normal, up to 1 micrometre and 0.1 degrees.
bool is_on(const MeshIndex& skin, const Taxel& taxel) {
  constexpr double kNear = 1e-6, kCosine = 1 - 1.5e-6;
  const Taxel put = onto_skin({taxel}, skin).front();
  return glm::distance(put.center, taxel.center) <= kNear &&
         glm::dot(put.normal, glm::normalize(taxel.normal)) >= kCosine;
}

/// Returns a taxel made from another one: on the skin if the other one is on the skin and the skin is near.
Taxel as_on(const MeshIndex* skin, const Taxel& of, Taxel made) {
  if (skin == nullptr || !is_on(*skin, of) || is_on(*skin, made)) return made;
  Taxel put = onto_skin({made}, *skin).front();
  // Without skin within the radius, the taxel remains at the mirrored place.
  return glm::distance(put.center, made.center) <= made.radius ? put : made;
}

void check_plane(const MirrorPlane& plane) {
  require_finite("mirror", "point", plane.point);
  require_direction("mirror", "normal", plane.normal);
}

/// The taxels of a layout by place, without those that have a mirrored taxel across a plane.
class FreeTaxels {
 public:
  FreeTaxels(const Layout& layout, const Mirror& mirror, double tolerance)
      : layout_(layout), tolerance_(tolerance), grid_(centers_of(layout), cell_of(layout, tolerance)) {
    for (const MirrorLink& link : mirror.links) linked_.insert({link.taxel, link.image});
  }
  [[nodiscard]] bool linked(int id) const { return linked_.contains(id); }
  void link(int id) { linked_.insert(id); }

  /// Returns the nearest taxel within the tolerance except `self`, the first of equally near ones, or null.
  [[nodiscard]] const Taxel* at(const dvec3& place, int self) const {
    const Taxel* nearest = nullptr;
    double least = tolerance_;
    if (!is_finite(place)) return nullptr;
    grid_.visit_near(place, tolerance_, [&](int index) {
      const Taxel& taxel = layout_.taxels[static_cast<std::size_t>(index)];
      const double distance = glm::distance(taxel.center, place);
      if (taxel.id == self || !(distance <= least) || linked(taxel.id)) return;
      if (nearest != nullptr && distance == least && &taxel > nearest) return;
      nearest = &taxel;
      least = distance;
    });
    return nearest;
  }

 private:
  static std::vector<dvec3> centers_of(const Layout& layout) {
    std::vector<dvec3> centers;
    for (const Taxel& taxel : layout.taxels) centers.push_back(taxel.center);
    return centers;
  }
  static double cell_of(const Layout& layout, double tolerance) {
    Aabb box;
    for (const Taxel& taxel : layout.taxels) box.include(taxel.center);
    constexpr double kLeastPart = 1e-6;  // relative to the size of the layout, for a tolerance of 0
    const double cell = std::max(tolerance, box.empty() ? 0.0 : kLeastPart * box.diagonal());
    return cell > 0 && std::isfinite(cell) ? cell : 1.0;
  }

  const Layout& layout_;
  double tolerance_;
  PointGrid grid_;
  std::unordered_set<int> linked_;
};

}  // namespace

void follow_links(Project& project, const std::vector<ChangedFields>& changed) {
  if (project.mirrors.empty()) return;
  const auto indices = taxel_indices(project.layout);
  std::vector<std::unordered_map<int, int>> twins;
  for (const Mirror& mirror : project.mirrors) twins.push_back(twins_across(mirror));
  std::set<int> done;
  for (const ChangedFields& fields : changed) done.insert(fields.id);
  std::vector<ChangedFields> queue = changed;  // grows; breadth-first search
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const ChangedFields fields = queue[next];
    const Taxel& taxel = project.layout.taxels[indices.at(fields.id)];
    for (std::size_t m = 0; m < twins.size(); ++m) {
      const auto twin = twins[m].find(fields.id);
      if (twin == twins[m].end() || !done.insert(twin->second).second) continue;
      take_image(taxel, project.mirrors[m].plane, fields, project.layout.taxels[indices.at(twin->second)]);
      queue.push_back(fields);
      queue.back().id = twin->second;
    }
  }
}

void mirror_taxels(Project& project, const MirrorTaxels& edit) {
  check_plane(edit.plane);
  if (!(edit.tolerance >= 0.0) || !std::isfinite(edit.tolerance))
    throw Error("mirror", "tolerance", fmt::format("must be finite and 0 or more, is {}", edit.tolerance));
  const dvec3 n = glm::normalize(edit.plane.normal);
  Mirror& mirror = mirror_of(project, edit.plane);
  const auto indices = taxel_indices(project.layout);
  FreeTaxels free(project.layout, mirror, edit.tolerance);
  std::vector<Taxel> images;
  std::vector<std::size_t> links_of_images;
  std::vector<std::pair<std::size_t, Taxel>> into_plane;  // index and new values of the taxel
  for (const int id : edit.ids) {
    const auto found = indices.find(id);
    if (found == indices.end()) throw Error("", fmt::format("taxel {}", id), "is not in the layout");
    const Taxel& taxel = project.layout.taxels[found->second];
    const bool in_plane = 2.0 * std::abs(glm::dot(taxel.center - edit.plane.point, n)) <= edit.tolerance;
    if (in_plane || free.linked(id)) continue;
    Taxel image = mirror_images({taxel}, edit.plane).front();
    if (const Taxel* partner = free.at(image.center, id)) {
      free.link(id);
      mirror.links.push_back({id, partner->id});
      free.link(partner->id);
      continue;
    }
    if (std::optional<Taxel> moved = in_plane_of(taxel, edit.plane)) {
      into_plane.emplace_back(found->second, as_on(edit.skin.get(), taxel, std::move(*moved)));
      continue;
    }
    free.link(id);
    images.push_back(as_on(edit.skin.get(), taxel, std::move(image)));
    links_of_images.push_back(mirror.links.size());
    mirror.links.push_back({id, -1});
  }
  std::vector<ChangedFields> moved;
  for (auto& [index, taxel] : into_plane) {
    moved.push_back({taxel.id, true, true, false, true});
    project.layout.taxels[index] = std::move(taxel);
  }
  const std::vector<int> ids = unused_ids(project.layout, images.size());
  for (std::size_t i = 0; i < images.size(); ++i) {
    images[i].id = ids[i];
    images[i].name = mirrored_name(images[i].name);
    mirror.links[links_of_images[i]].image = ids[i];
    project.layout.taxels.push_back(std::move(images[i]));
  }
  drop_links(project.mirrors, [](int) { return false; });
  follow_links(project, moved);
}

void link_taxels(Project& project, const LinkTaxels& edit) {
  check_plane(edit.plane);
  Mirror& mirror = mirror_of(project, edit.plane);
  for (const MirrorLink& link : edit.links) {
    for (const int id : {link.taxel, link.image}) {
      taxel_index(project.layout, id);
      if (link.taxel == link.image) throw Error("", fmt::format("taxel {}", id), "cannot be its own mirror image");
      if (const auto twin = twin_across(mirror, id))
        throw Error("", fmt::format("taxel {}", id), fmt::format("is already linked with taxel {}", *twin));
    }
    mirror.links.push_back(link);
  }
  drop_links(project.mirrors, [](int) { return false; });
}

void unlink_taxels(Project& project, const UnlinkTaxels& edit) {
  std::set<int> ids;
  for (const int id : edit.ids) {
    taxel_index(project.layout, id);
    ids.insert(id);
  }
  drop_links(project.mirrors, [&](int id) { return ids.contains(id); });
}

}  // namespace taxel
