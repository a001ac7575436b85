// A repaired mesh with a report of every change, and the loaded faces that its faces come from.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/query/self_intersection.h"
#include "core/mesh/repair/repair_recipe.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Changes made by one step of a repair. Only steps that changed something are listed.
struct RepairStep {
  std::string code;   ///< stable word, such as "repair_fin"
  int count = 0;      ///< number of places: fins, joined vertices, holes, shells
  int faces = 0;      ///< faces added, removed or turned
  double area = 0;    ///< area of these faces [m^2]
  double length = 0;  ///< largest distance moved, or width of the widest hole [m]
  dvec3 place{0};     ///< first place, frame of the mesh [m]
  Severity severity = Severity::note;
  std::string message;  ///< one sentence: the change, its size and its first place
};

/// All changes of a repair. Lengths in metres, areas in square metres.
struct RepairReport {
  RepairLevel level = RepairLevel::keep;  ///< how far it went: keep (nothing changed), exact, or wrap
  bool closed = false;                    ///< the repaired mesh is a closed solid
  int faces_before = 0, faces_after = 0;
  int shells_before = 0, shells_after = 0;
  int vertices_moved = 0;
  double largest_move = 0;
  double distance_max = 0, distance_rms = 0;  ///< between the two outer surfaces, both ways; 0 if nothing was wrapped
  double wrap_edge = 0;                       ///< edge length of the wrap; 0 if nothing was wrapped
  bool is_coarser = false;                    ///< the default edge would have taken too long, so a larger one was used
  bool has_sheets = false;                    ///< some of its faces have two sides and enclose nothing
  double area_before = 0;                     ///< area of the loaded faces
  double area_added = 0, area_removed = 0;
  double seconds = 0;  ///< wall time
  std::vector<RepairStep> steps;
};

/// The changed places, for display.
struct RepairChanges {
  std::vector<int> filled_faces;                      ///< faces of the repaired mesh, ascending
  std::vector<int> removed_faces;                     ///< faces of the loaded mesh, ascending
  std::vector<std::pair<dvec3, dvec3>> parted_edges;  ///< ends of edges at which surfaces were parted [m]
  /// Largest distance between the surfaces around each repaired vertex [m]; empty if nothing was wrapped.
  std::vector<float> distance;
};

/// A repaired mesh. Immutable.
struct RepairedMesh {
  TriMeshPtr mesh;  ///< the loaded mesh itself if nothing was changed
  /// For each repaired face the loaded face that it comes from: -1 if it was filled in, the nearest one if it was
  /// wrapped. Empty if nothing was changed: the numbers are the same.
  std::vector<int> loaded_face_of;
  RepairReport report;
  RepairChanges changes;
  /// Faces of `mesh` that cut through each other. Empty if they were not searched in this very mesh.
  std::optional<SelfIntersections> crossings;

  [[nodiscard]] int loaded_face(int face) const {
    return loaded_face_of.empty() ? face : loaded_face_of[static_cast<std::size_t>(face)];
  }
};
using RepairedMeshPtr = std::shared_ptr<const RepairedMesh>;

/// Returns the loaded mesh as a repaired mesh without changes.
RepairedMeshPtr as_loaded(const TriMeshPtr& loaded);

/// Returns the faces of the repaired mesh that come from `loaded_faces`. Both lists are ascending.
std::vector<int> repaired_faces(const RepairedMesh& repaired, const std::vector<int>& loaded_faces);

/// Returns the loaded faces that `faces` of the repaired mesh come from, each once, ascending. Filled-in faces have no
/// loaded face.
std::vector<int> loaded_faces(const RepairedMesh& repaired, const std::vector<int>& faces);

}  // namespace taxel
