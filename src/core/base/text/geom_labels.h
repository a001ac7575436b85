// Labels of geoms for messages and lists. Most robots name their bodies but no geom, so a geom without a name is called
// by its body, and by the class, mesh or type that distinguishes it in the body: "rh_ffdistal, plastic_visual".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace taxel {

/// The names around a geom. A text is empty if there is no such name.
struct GeomParts {
  std::string name;        ///< name of the geom itself
  std::string body;        ///< name of the body, or "body 5" for a body without a name
  std::string class_name;  ///< class of defaults that the geom names itself, not its body
  std::string mesh;        ///< name of the mesh asset
  std::string type;        ///< MJCF keyword: "box", "capsule", ...
  bool collides = true;    ///< false for a geom that is only drawn
};

/// Returns the first geoms of a body with each of its meshes, of geoms that are only drawn or of all.
std::vector<std::size_t> first_with_each_mesh(const std::vector<GeomParts>& geoms, const std::string& body,
                                              bool only_drawn);

/// Returns the geom with the mesh of a body: of several meshes the only one that is only drawn, and of several geoms
/// with the mesh the first one; empty if the body has no such mesh, or several.
std::optional<std::size_t> mesh_geom(const std::vector<GeomParts>& geoms, const std::string& body);

/// Returns a label for each geom: its name, or BODY, DETAILS. The details are the class, or the mesh if there is no
/// class, or the type; then the mesh or type and a number, as far as two geoms of the body would have the same label.
/// All labels differ, if all names differ. A label does not depend on whether other geoms of the body have names, so
/// that it remains when one of them gets a name.
std::vector<std::string> geom_labels(const std::vector<GeomParts>& geoms);

/// Returns the name that each geom has while a sensor is on it: its own name; or that of its body for its mesh_geom(),
/// or its only geom; or BODY_MESH for the first geom with another mesh, and BODY_3 for the third geom of the body. All
/// names differ, if all names of geoms differ. Spaces and commas become '_', because a name with them cannot be in a
/// list of geoms.
std::vector<std::string> geom_sensor_names(const std::vector<GeomParts>& geoms);

/// Returns the number in "geom 7", the former label of a geom without a name, or -1 for other texts.
int number_in_label(const std::string& label);

}  // namespace taxel
