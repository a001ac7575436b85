// Computes normals for drawing: smooth over round parts, sharp at creases.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel::ui {

/// Mesh for drawing, with one vertex for each smooth neighbourhood of a vertex of the mesh.
struct RenderMesh {
  struct Vertex {
    glm::vec3 position{0};  ///< [m], frame of the mesh
    glm::vec3 normal{0};    ///< unit
  };
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three per face, in the mesh's face order
};

/// Builds a mesh for drawing. The normal of a corner is the angle-weighted mean over the faces around its vertex whose
/// normals are within `crease_deg` of the normal of the corner's face. Cost: linear in the number of faces if the
/// valence is bounded.
RenderMesh make_render_mesh(const TriMesh& mesh, double crease_deg = 40.0);

}  // namespace taxel::ui
