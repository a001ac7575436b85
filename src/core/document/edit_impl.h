// The part of apply_edit() that follows mirrored taxels: pairs that remain mirror images of each other when one is
// edited.
#pragma once

#include <vector>

#include "core/document/edit.h"

namespace taxel {

/// The fields of a taxel that an edit has changed.
struct ChangedFields {
  int id = 0;
  bool center = false, normal = false, radius = false, subtaxels = false, density = false;
};

/// Copies the mirror image of the changed fields to the mirrored taxels of the changed taxels, and on to their mirrored
/// taxels. Changed taxels keep their own values. Each mirrored taxel is reached once, across the fewest planes.
void follow_links(Project& project, const std::vector<ChangedFields>& changed);

// Apply the edits of these names. Throw Error if a taxel does not exist, or a pair cannot be linked.
void mirror_taxels(Project& project, const MirrorTaxels& edit);
void link_taxels(Project& project, const LinkTaxels& edit);
void unlink_taxels(Project& project, const UnlinkTaxels& edit);

/// Removes links with a taxel for which `is_removed(id)` is true, and then planes without links.
template <class IsRemoved>
void drop_links(std::vector<Mirror>& mirrors, const IsRemoved& is_removed) {
  for (Mirror& mirror : mirrors)
    std::erase_if(mirror.links,
                  [&](const MirrorLink& link) { return is_removed(link.taxel) || is_removed(link.image); });
  std::erase_if(mirrors, [](const Mirror& mirror) { return mirror.links.empty(); });
}

}  // namespace taxel
