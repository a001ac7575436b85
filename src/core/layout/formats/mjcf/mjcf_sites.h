// The touch sites of MuJoCo scenes as taxels.
#pragma once

#include <string>
#include <vector>

#include "core/layout/file/imported_layout.h"
#include "core/layout/formats/text/xml_node.h"

namespace taxel {

/// Returns one layout for each body with touch sensors: a taxel at each of their sites, in the frame of the body. The
/// radius is the first size of the site. The z axis of the site is the normal if all sites of the body have an
/// orientation, otherwise the skin gives the normals.
std::vector<ImportedLayout> touch_sites(const XmlNode& mujoco);

}  // namespace taxel
