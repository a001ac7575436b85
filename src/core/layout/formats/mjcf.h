// Layouts in MuJoCo scenes: those of the plugin taxel.sensor, and touch sites as taxels.
#pragma once

#include <string>
#include <vector>

#include "core/layout/file/imported_layout.h"
#include "core/layout/formats/text.h"

namespace taxel {

/// Returns the layout of each instance of the plugin, in the order of the files. `roots` are the root elements of the
/// scene and of the files that it includes; layouts and meshes are searched in the folders that any of them names, from
/// the folder of `scene`. Throws Error naming file and line.
std::vector<ImportedLayout> plugin_layouts(const std::vector<XmlNode>& roots, const std::string& scene);

/// Returns one layout for each body with touch sensors: a taxel at each of their sites, in the frame of the body. The
/// radius is the first size of the site. The z axis of the site is the normal if all sites of the body have an
/// orientation, otherwise the skin gives the normals. Throws Error naming file and line for what only the compiled
/// scene has: a site of a class, in a <frame> with a pose, or with another orientation than quat, xyaxes or zaxis.
std::vector<ImportedLayout> touch_sites(const XmlNode& mujoco);

/// Returns the name of the site of a taxel without a name.
std::string name_of_site(const std::string& body, int id);

/// Gives the taxels of a body the first user values of their sites as ids, if each is a whole number that no other site
/// has, and takes away the names that name_of_site() gives. An empty vector keeps the rows as ids.
void take_site_ids(ImportedLayout& imported, const std::vector<double>& first_user);

}  // namespace taxel
