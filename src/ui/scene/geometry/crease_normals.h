// Normals for drawing: smooth over round parts, sharp at creases.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel::ui {

/// Vertices as drawn: one per mesh vertex and smooth neighbourhood.
struct RenderMesh {
  struct Vertex {
    glm::vec3 position{0};  ///< [m], frame of the mesh
    glm::vec3 normal{0};    ///< unit
  };
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three per face, in the mesh's face order
};

/// A corner's normal is the angle-weighted mean over the faces around its vertex that lie within `crease_deg` of its
/// own face. Linear in the number of faces for meshes of bounded valence.
RenderMesh make_render_mesh(const TriMesh& mesh, double crease_deg = 40.0);

}  // namespace taxel::ui
