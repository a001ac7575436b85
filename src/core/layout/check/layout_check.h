// Every rule a layout can break, as a list of problems with JSON pointers; the mesh is optional.
#pragma once

#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/repair/repair.h"

namespace taxel {

/// Rules of values alone: positive radii, non-zero finite normals, density, words, duplicate ids and places, ...
Problems check_layout_values(const Layout& layout, const std::string& file);

/// Rules that need the mesh: centre far from the surface (how far), normal against the surface's, taxel without
/// samples nearby, radius larger than the body, hash differs. `sha256` is that of the mesh file read.
Problems check_layout_on_mesh(const Layout& layout, const MeshIndex& index, const std::string& sha256,
                              const std::string& file);

/// The mesh that a layout is checked on.
struct LayoutMesh {
  const TriMesh& loaded;  ///< mesh as read from the file: /sampling/region counts its faces
  const RepairedMesh& repaired;
  const MeshIndex& skin;  ///< the shells of the repaired mesh that are sampled
};
/// The rules of check_layout_on_mesh() if the repaired mesh and the shells that are sampled are known.
Problems check_layout_on_skin(const Layout& layout, const LayoutMesh& mesh, const std::string& sha256,
                              const std::string& file);

/// Returns notes on the mesh file if the mesh was repaired: that the file's mesh is open, not a manifold or not wound
/// alike. Empty if nothing was repaired.
Problems check_loaded_mesh(const TriMesh& loaded, const RepairedMesh& repaired, const std::string& file);

/// Reports faces of a layout's mesh that cut through each other and a size that is hardly metres. Not part of the rules
/// above, because editing a layout changes neither. Cost: a search for intersections, unless the repair did it.
Problems check_layout_mesh(const RepairedMesh& repaired, const std::string& file);

/// Index of the taxel that a JSON pointer such as /taxels/3/radius leads into; nothing where it leads elsewhere.
std::optional<std::size_t> taxel_of_pointer(std::string_view pointer);

/// Adds the id of its taxel to the message of each problem that points into /taxels: users know taxels by their ids,
/// not by their indices.
void name_taxels(const Layout& layout, Problems& problems);

/// Throws Error with the first problem of severity error.
void throw_first_error(const Problems& problems);

}  // namespace taxel
