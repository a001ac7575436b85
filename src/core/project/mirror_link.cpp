#include "core/project/mirror_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <unordered_map>

#include "core/base/error.h"
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
}

/// The links across this plane, made where there are none.
Mirror& mirror_of(Project& project, const MirrorPlane& plane) {
  for (Mirror& mirror : project.mirrors)
    if (mirror.plane == plane) return mirror;
  return project.mirrors.emplace_back(Mirror{plane, {}});
}

void check_plane(const MirrorPlane& plane) {
  require_finite("mirror", "point", plane.point);
  require_direction("mirror", "normal", plane.normal);
}

/// The nearest taxel within `tolerance` of a place that has no twin across the plane yet, other than `self`.
const Taxel* free_taxel_at(const Layout& layout, const Mirror& mirror, const dvec3& place, double tolerance, int self) {
  const Taxel* nearest = nullptr;
  for (const Taxel& taxel : layout.taxels) {
    const double distance = glm::distance(taxel.center, place);
    if (taxel.id == self || !(distance <= tolerance) || twin_across(mirror, taxel.id)) continue;
    if (nearest == nullptr || distance < glm::distance(nearest->center, place)) nearest = &taxel;
  }
  return nearest;
}

}  // namespace

void follow_links(Project& project, const std::vector<ChangedFields>& changed) {
  if (project.mirrors.empty()) return;
  const auto indices = taxel_indices(project.layout);
  std::vector<std::unordered_map<int, int>> twins;
  for (const Mirror& mirror : project.mirrors) twins.push_back(twins_across(mirror));
  std::set<int> done;
  for (const ChangedFields& fields : changed) done.insert(fields.id);
  std::vector<ChangedFields> queue = changed;  // grows: breadth first
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
  for (const int id : edit.ids) {
    const Taxel taxel = project.layout.taxels[taxel_index(project.layout, id)];
    const bool in_plane = 2.0 * std::abs(glm::dot(taxel.center - edit.plane.point, n)) <= edit.tolerance;
    if (in_plane || twin_across(mirror, id)) continue;
    Taxel image = mirror_images({taxel}, edit.plane).front();
    if (const Taxel* there = free_taxel_at(project.layout, mirror, image.center, edit.tolerance, id)) {
      mirror.links.push_back({id, there->id});
      continue;
    }
    image.id = unused_ids(project.layout, 1).front();
    image.name = mirrored_name(image.name);
    mirror.links.push_back({id, image.id});
    project.layout.taxels.push_back(std::move(image));
  }
  drop_links(project.mirrors, [](int) { return false; });
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
