// Taxels that are links of a URDF, as XELA describes its sensors.
#pragma once

#include <string>
#include <vector>

#include "core/layout/file/imported_layout.h"
#include "core/layout/formats/text/xml_node.h"

namespace taxel {

/// Returns one layout for each group of taxel links, none if there are no such links. A taxel link has no links below
/// it, and its name has a number: x_taxel_0_uSPa44_07_link. It is joined to the link with the sensor's mesh by fixed
/// joints, or by sliding ones of at most 5 mm, of which XELA's models have one or three for each taxel; they are taken
/// at 0. Links whose names differ only in numbers are a group. A name without the word "taxel" is of a taxel if the
/// link is a sphere and its group has four links or more.
///
/// Positions are in the frame of the mesh, after its scale, or in that of the link that carries the group if no mesh is
/// there. Ids are the numbers in the names. The z axis of a taxel's link is its normal. Throws Error naming file and
/// line: a joint names no link, a link hangs on two joints, or joints form a circle.
std::vector<ImportedLayout> layouts_of_taxel_links(const XmlNode& robot, const std::string& file);

}  // namespace taxel
