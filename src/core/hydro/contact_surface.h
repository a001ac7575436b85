// The surface two bodies share: planar polygons with a linear pressure on each.
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
  dvec3 centroid{0};    ///< of the area
  double pressure = 0;  ///< elastic pressure p0 at the centroid [Pa]
  dvec3 gradient{0};    ///< of p0 [Pa/m]; p0(x) = pressure + dot(gradient, x - centroid)
  int tet = -1;         ///< tet of the soft body (of A if both are soft); -1 in a half-space and beyond a pad's tets
  int tet_b = -1;       ///< of B where both are soft
  int face = -1;        ///< of the rigid mesh; -1 on a half-space
};

/// Of plain numbers, whose new elements hold anything: growing costs nothing.
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

/// Why something of the overlap is not part of the surface.
enum class Rejection {
  sliver,      ///< too thin to have a normal
  touching,    ///< in the skin: no pressure
  beyond_core  ///< the hole behind a field that ends with its tets: steps saved before depth pieces were there
};
inline constexpr std::size_t kRejections = 3;
/// A stable word: "sliver", "touching", "beyond_core".
const char* to_string(Rejection reason);

/// What was not taken into the surface for one reason.
struct RejectedPolygons {
  int count = 0;     ///< polygons; for beyond_core those that end on the core
  double area = 0;   ///< [m^2]
  double force = 0;  ///< integral of the pressure over that area [N]; behind a core, with the mean pressure of its rim
};

/// A polygon that was kept out, for display: vertices [first, first + count) of filtered_vertices.
struct FilteredPolygon {
  Rejection reason = Rejection::sliver;
  int first = 0, count = 0;
};

/// Everything in the frame of body A. Reused from step to step: clear() keeps the memory.
struct ContactSurface {
  NumberBuffer<dvec3> vertices;
  NumberBuffer<double> pressure;  ///< p0 at each vertex, never negative [Pa]
  std::vector<ContactPolygon> polygons;
  std::array<RejectedPolygons, kRejections> rejected;  ///< by reason
  std::vector<dvec3> filtered_vertices;
  std::vector<FilteredPolygon> filtered;

  void clear();
  [[nodiscard]] const RejectedPolygons& left_out(Rejection reason) const {
    return rejected[static_cast<std::size_t>(reason)];
  }
  /// Polygons that end where the field does although the overlap is deeper; 0 for fields that go on (depth_field.h).
  [[nodiscard]] int at_core() const { return left_out(Rejection::beyond_core).count; }
  [[nodiscard]] bool empty() const { return polygons.empty(); }
  [[nodiscard]] double area() const;
  [[nodiscard]] double max_pressure() const;
  [[nodiscard]] int triangle_count() const;  ///< sum of (count - 2)
};

/// The surface as body B sees it: in the frame of B, with the normals that push B, polygons turned round, and the tets
/// of two soft bodies exchanged. Keeps the memory of `out`.
void mirror(const ContactSurface& surface, const RigidTransform& X_BA, ContactSurface& out);

}  // namespace taxel
