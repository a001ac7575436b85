// Contact surface of two bodies: planar polygons with a linear pressure on each.
#pragma once

#include <array>
#include <memory>
#include <type_traits>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// Polygon i owns vertices [first, first + count), counter-clockwise about `normal`.
struct ContactPolygon {
  int first = 0, count = 0;
  dvec3 normal{0};      ///< unit; the direction in which the surface pushes body A
  double area = 0;      ///< [m^2]
  dvec3 centroid{0};    ///< centroid of the area
  double pressure = 0;  ///< elastic pressure p0 at the centroid [Pa]
  dvec3 gradient{0};    ///< gradient of p0 [Pa/m]; p0(x) = pressure + dot(gradient, x - centroid)
  int tet = -1;         ///< tet of the soft body, of A if both are soft; -1 outside of all tets
  int tet_b = -1;       ///< tet of B if both bodies are soft, otherwise -1
  int face = -1;        ///< face of the rigid mesh, the lower one of a parallelogram, or -1 on a half-space
  float weight = 1;     ///< factor of surface_writer.h that pressure and gradient contain
};

/// Vector of plain numbers that does not initialise new elements, so that growing costs nothing.
template <class T>
struct UninitializedAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UninitializedAllocator<U>;
  };
  template <class U>
  void construct(U* p) noexcept {
    static_assert(std::is_trivially_default_constructible_v<U>);
    ::new (static_cast<void*>(p)) U;
  }
  template <class U, class... Args>
  void construct(U* p, Args&&... args) {
    std::construct_at(p, std::forward<Args>(args)...);
  }
};
template <class T>
using NumberBuffer = std::vector<T, UninitializedAllocator<T>>;

/// Reason why a part of the overlap is not part of the surface.
enum class Rejection {
  sliver,    ///< too thin to have a normal
  touching,  ///< in the skin, where the pressure is 0
  /// The hole behind a field that ends with its tets. Only steps that were saved before depth pieces existed have it.
  beyond_core,
  back_face  ///< against the gradient, as the far face of a thin plate (intersect.cpp)
};
inline constexpr std::size_t kRejections = 4;
/// Returns a stable word: "sliver", "touching", "beyond_core", "back_face".
const char* to_string(Rejection reason);

/// Polygons that were left out of the surface for one reason.
struct RejectedPolygons {
  int count = 0;    ///< number of polygons; for beyond_core the polygons that end on the core
  double area = 0;  ///< [m^2]; of a back face that counts in part, the part that is left out
  /// Integral of the pressure over the area [N]. For beyond_core it is taken with the mean pressure of the core's rim.
  double force = 0;
};

/// A polygon that was left out, for display: vertices [first, first + count) of filtered_vertices.
struct FilteredPolygon {
  Rejection reason = Rejection::sliver;
  int first = 0, count = 0;
};

/// All values are in the frame of body A. The object is reused from step to step: clear() keeps the memory.
struct ContactSurface {
  NumberBuffer<dvec3> vertices;
  NumberBuffer<double> pressure;  ///< p0 at each vertex, never negative [Pa]
  std::vector<ContactPolygon> polygons;
  std::array<RejectedPolygons, kRejections> rejected;  ///< indexed by Rejection
  std::vector<dvec3> filtered_vertices;
  std::vector<FilteredPolygon> filtered;

  void clear();
  [[nodiscard]] const RejectedPolygons& left_out(Rejection reason) const {
    return rejected[static_cast<std::size_t>(reason)];
  }
  /// Number of polygons that end where the field ends although the overlap is deeper; 0 for fields that continue
  /// (depth_field.h).
  [[nodiscard]] int at_core() const { return left_out(Rejection::beyond_core).count; }
  [[nodiscard]] bool empty() const { return polygons.empty(); }
  [[nodiscard]] double area() const;
  [[nodiscard]] double max_pressure() const;
  [[nodiscard]] int triangle_count() const;  ///< sum of (count - 2)
};

/// Writes the surface as seen by body B to `out`: in the frame of B, with normals that push B, reversed polygons, and
/// the tets of two soft bodies exchanged. Keeps the memory of `out`.
void mirror(const ContactSurface& surface, const RigidTransform& X_BA, ContactSurface& out);

}  // namespace taxel
