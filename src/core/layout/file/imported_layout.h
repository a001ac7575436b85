// A layout from a file of any format: the check that its lengths are those of a sensor in metres, because files seldom
// name their unit, and the values from the skin that the file does not have.
#pragma once

#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// A layout as read. The values that the file does not have come from a skin: put_on_skin().
struct ImportedLayout {
  Layout layout;
  std::vector<std::string> notes;             ///< sentences on values that are not from the file
  std::string geom = {};                      ///< geom or link that the file puts the sensor on, or empty
  std::string geom_place = {};                ///< place of that name for messages, such as "line 8, key geomName"
  std::vector<std::string> other_geoms = {};  ///< geoms of the file's other sensors
  /// Indices into layout.taxels, ascending, of the taxels whose radius the file does not give: it is Taxel's default.
  std::vector<std::size_t> missing_radii = {};
  bool has_normals = true;  ///< false if the skin gives the normals of the taxels whose normal is zero
  bool has_units = false;   ///< true if the file or its format names the unit of lengths
  /// Edge length of the square cells that cover the top of the skin if the file lists no taxels, otherwise 0 [m].
  double cell = 0;
  bool has_density = true;   ///< true if the file gives layout.sampling.density
  bool has_material = true;  ///< true if the file gives layout.material
  bool has_frame = true;     ///< true if the file gives layout.frame

  [[nodiscard]] bool has_radii() const { return missing_radii.empty(); }
  /// Sets that the file gives the normal of no taxel. Call it when all taxels are in the layout.
  void set_all_normals_missing() {
    has_normals = false;
    for (Taxel& taxel : layout.taxels) taxel.normal = dvec3(0);
  }
  /// Sets that the file gives the radius of no taxel. Call it when all taxels are in the layout.
  void set_all_radii_missing() {
    missing_radii.resize(layout.taxels.size());
    std::iota(missing_radii.begin(), missing_radii.end(), std::size_t{0});
  }
};

/// Multiplies all lengths by `unit` [m]. Throws Error naming `file` if the file names its unit.
void apply_unit(ImportedLayout& imported, double unit, const std::string& file);

/// Throws Error naming `file` and the unit that would help if the taxels are more than 1 m apart, are more than 10 m
/// from the origin or have a radius of more than 1 m, or if a normal has neither length 1 nor 0.
void check_lengths(const ImportedLayout& imported, const std::string& file);

/// Throws Error naming `file` and the unit that would help unless the skin is 1 mm to 1 m large and half of the taxels
/// are within a quarter of that size from its surface.
void check_near_skin(const ImportedLayout& imported, const MeshIndex& skin, const std::string& file);

/// Guesses the factor from the units of a mesh file to metres: of 1, 0.001, 0.01 and 0.0254 the one with the smallest
/// mean distance between the taxels and the surface. Decides by the size of the mesh if the file lists no taxels.
double guess_scale(const ImportedLayout& imported, const TriMesh& unscaled);

/// Adds the values that the file does not give, with a note for each: normals of the nearest points of the skin, the
/// cells of a flat array over the top (+z) of the skin, the frame, and a density of at most 100000 samples.
/// `skin` is the scaled mesh. Normals that all point into the skin are turned over. Throws Error naming `file` if no
/// cell of an array is on the skin, or as check_near_skin() does.
void put_on_skin(ImportedLayout& imported, const TriMeshPtr& skin, const std::string& file);

/// Guesses the directions of the sensor: of a planar array by its taxels, of a finger by its shape and taxels
/// (guess_frame). Keeps the layout's frame if both fail. Returns a note for the user.
std::string take_frame_of(const TriMesh& skin, Layout& layout);

}  // namespace taxel
