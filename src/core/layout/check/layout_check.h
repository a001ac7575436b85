// Checks the rules of layouts, and returns lists of problems with JSON pointers. The mesh is optional.
#pragma once

#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/repair/repair.h"

namespace taxel {

/// Checks the rules that need only values: positive radii, non-zero finite normals, density, words, duplicate ids and
/// places, and so on.
Problems check_layout_values(const Layout& layout, const std::string& file);

/// Checks the rules that need the mesh: distance of centres from the surface, direction of normals, taxels without
/// samples nearby, radii larger than the body, hash of the mesh. `sha256` is the hash of the mesh file.
Problems check_layout_on_mesh(const Layout& layout, const MeshIndex& index, const std::string& sha256,
                              const std::string& file);

/// The mesh on which a layout is checked.
struct LayoutMesh {
  const TriMesh& loaded;  ///< mesh as read from the file: /sampling/region counts its faces
  const RepairedMesh& repaired;
  const MeshIndex& skin;  ///< the shells of the repaired mesh that are sampled
};
/// Checks the rules of check_layout_on_mesh() if the repaired mesh and the sampled shells are known.
Problems check_layout_on_skin(const Layout& layout, const LayoutMesh& mesh, const std::string& sha256,
                              const std::string& file);

/// Returns notes on the mesh file if the mesh was repaired: that the file's mesh is open, not a manifold or not wound
/// alike. Empty if nothing was repaired.
Problems check_loaded_mesh(const TriMesh& loaded, const RepairedMesh& repaired, const std::string& file);

/// Reports faces of a layout's mesh that cut through each other and a size that is probably not in metres. Not part of
/// the rules above, because editing a layout changes neither. Cost: a search for intersections, unless the repair did
/// it.
Problems check_layout_mesh(const RepairedMesh& repaired, const std::string& file);

/// Returns the index of the taxel in a JSON pointer such as /taxels/3/radius, or nothing for other pointers.
std::optional<std::size_t> taxel_of_pointer(std::string_view pointer);

/// Adds the id of its taxel to the message of each problem that points into /taxels: users know taxels by their ids,
/// not by their indices.
void name_taxels(const Layout& layout, Problems& problems);

/// Throws Error with the first problem of severity error.
void throw_first_error(const Problems& problems);

}  // namespace taxel
