// Meshes prepared for drawing: normals that are smooth over round parts and sharp at creases, simplified meshes,
// visible edges, and faces sorted from back to front.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
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
  std::vector<glm::vec2> texture_coords;  ///< one for each vertex, or empty
  std::vector<std::uint32_t> indices;     ///< three per face, in the mesh's face order
};

/// Builds a mesh for drawing. The normal of a corner is the angle-weighted mean over the faces around its vertex whose
/// normals are within `crease_deg` of the normal of the corner's face. Cost: linear in the number of faces if the
/// valence is bounded. `texture_coords` are places in a texture, of the corners of all faces, or empty.
RenderMesh make_render_mesh(const TriMesh& mesh, double crease_deg = 40.0,
                            std::span<const glm::vec2> texture_coords = {});

/// Returns a coarser mesh, for a mesh whose drawing would take too long (Rossignac, Borrel 1993, "Multi-resolution 3D
/// approximations for rendering complex scenes"). All vertices within a cell of a grid are replaced by their mean.
/// Faces that lose a corner are removed, only the first of equal faces remains, and the orientation of faces is
/// preserved. The size of the cells gives about `faces` triangles on an evenly meshed surface; no point moves farther
/// than the diagonal of a cell. Returns the mesh itself if no face would remain. Cost: O(faces log faces).
TriMeshPtr simplify(const TriMeshPtr& mesh, int faces);

struct MeshEdge {
  int a = 0, b = 0;           ///< vertices, a < b
  int left = -1, right = -1;  ///< faces; right is -1 at a border
  bool crease = false;        ///< a border, or the faces meet at more than the crease angle
};

/// Returns every edge once, ordered by (a, b). An edge of more than two faces has the first two of them and is a
/// crease.
std::vector<MeshEdge> mesh_edges(const TriMesh& mesh, double crease_deg = 30.0);

/// The visible edges as ascending indices: outline edges separate faces that look towards `eye` from faces that look
/// away, and visible creases touch a face that looks towards `eye`. `eye` is in the frame of the mesh.
struct VisibleEdges {
  std::vector<int> outline, creases;
};
VisibleEdges visible_edges(const TriMesh& mesh, const std::vector<MeshEdge>& edges, const dvec3& eye);

/// Sorts triangles (given by three indices each into `corner positions`) by the depth of their centroids along
/// `direction` (from the eye into the scene, in the mesh's frame), farthest first. A counting sort over 4096 depths:
/// linear, stable and the same everywhere. `centroids` one per face; writes three indices per face into `out`.
void order_back_to_front(std::span<const glm::vec3> centroids, std::span<const std::uint32_t> indices,
                         const glm::vec3& direction, std::vector<std::uint32_t>& out);

}  // namespace taxel::ui
