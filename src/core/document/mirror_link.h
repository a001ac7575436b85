// Twins: taxels that are mirror images of each other and stay so.
#pragma once

#include <vector>

#include "core/document/edit.h"

namespace taxel {

/// Which fields of a taxel an edit has changed.
struct ChangedFields {
  int id = 0;
  bool center = false, normal = false, radius = false, subtaxels = false;
};

/// Gives the twins of the changed taxels the mirror image of what was changed, and of nothing else; twins of twins too.
/// Changed taxels keep their own values. Across several planes each twin is reached once, by the fewest planes.
void follow_links(Project& project, const std::vector<ChangedFields>& changed);

/// As MirrorTaxels, LinkTaxels and UnlinkTaxels say.
void mirror_taxels(Project& project, const MirrorTaxels& edit);
void link_taxels(Project& project, const LinkTaxels& edit);
void unlink_taxels(Project& project, const UnlinkTaxels& edit);

/// Drops links for which `gone(id)` holds at either end, and planes without links.
template <class Gone>
void drop_links(std::vector<Mirror>& mirrors, const Gone& gone) {
  for (Mirror& mirror : mirrors)
    std::erase_if(mirror.links, [&](const MirrorLink& link) { return gone(link.taxel) || gone(link.image); });
  std::erase_if(mirrors, [](const Mirror& mirror) { return mirror.links.empty(); });
}

}  // namespace taxel
