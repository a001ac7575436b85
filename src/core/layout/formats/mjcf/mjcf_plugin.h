// The layouts of the plugin taxel.sensor in a MuJoCo scene.
#pragma once

#include <string>
#include <vector>

#include "core/layout/file/imported_layout.h"
#include "core/layout/formats/text/xml_node.h"

namespace taxel {

/// Returns the layout of each instance of the plugin, in the order of the files. `roots` are the root elements of the
/// scene and of the files that it includes; layouts and meshes are searched in the folders that any of them names, from
/// the folder of `scene`. Throws Error naming file and line.
std::vector<ImportedLayout> plugin_layouts(const std::vector<XmlNode>& roots, const std::string& scene);

}  // namespace taxel
