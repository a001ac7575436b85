// Two soft bodies: the surface on which their pressures are equal.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/hydro/kernel/tets_and_tets.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include "core/hydro/kernel/emit_inl.h"
#include "core/hydro/kernel/grid_query_inl.h"
#include "core/hydro/kernel/kernels.h"
#include "core/hydro/kernel/slice_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// The tree form: every tet of A near B against the tets of B in its box. All in the frame of B.
class TetsAndTets {
 public:
  TetsAndTets(const FieldIndex& a, const FieldIndex& b, const RigidTransform& X_BA, SurfaceWriter& writer,
              IntersectWorkspace& workspace)
      : a_(a), b_(b), X_BA_(X_BA), writer_(writer), workspace_(workspace) {}

  void run() {
    GridQuery near;
    near.set(b_.grid(), X_BA_, a_.tree());
    workspace_.triangles.clear();
    collect(a_.tree(), near, workspace_.triangles);
    for (const std::int32_t k : workspace_.triangles) add(k);
  }

 private:
  /// A tet of A, frame B.
  struct TetOfA {
    std::int32_t index;
    std::array<dvec3, 4> corners;
    std::array<double, 4> pressure;
    dvec3 gradient;
    alignas(32) double x[4], y[4], z[4];
  };

  void add(std::int32_t index) {
    TetOfA k{index, a_.corners(index), a_.corner_pressures(index), {}, {}, {}, {}};
    Aabb box;
    for (std::size_t i = 0; i < 4; ++i) {
      dvec3& c = k.corners[i];
      c = X_BA_(c);
      box.include(c);
      k.x[i] = c.x, k.y[i] = c.y, k.z[i] = c.z;
    }
    k.gradient = X_BA_.R * a_.tets()[static_cast<std::size_t>(index)].pressure().gradient;
    BoxQuery query;
    query.set(box, b_.tree());
    workspace_.tets.clear();
    collect(b_.tree(), query, workspace_.tets);
    for (const std::int32_t l : workspace_.tets) add_pair(k, l);
  }

  /// pA - pB at the corners of k, with the linear pressure of tet l, and which are negative.
  static HWY_INLINE unsigned differences(const TetOfA& k, const PackedTet& l, std::array<double, 4>& difference) {
    const TagD d;
    unsigned negative = 0;
    for (std::size_t i = 0; i < 4; i += kLanesD) {
      const VecD p = plane(hn::Set(d, l.gradient[0]), hn::Load(d, k.x + i), hn::Set(d, l.gradient[1]),
                           hn::Load(d, k.y + i), hn::Set(d, l.gradient[2]), hn::Load(d, k.z + i), hn::Set(d, l.constant));
      const VecD value = hn::Sub(hn::LoadU(d, k.pressure.data() + i), p);
      hn::StoreU(value, d, difference.data() + i);
      negative |= mask_bits(d, hn::Lt(value, hn::Zero(d))) << i;
    }
    return negative;
  }

  void add_pair(const TetOfA& k, std::int32_t index) {
    const PackedTet& l = b_.tets()[static_cast<std::size_t>(index)];
    std::array<double, 4> difference;
    const unsigned negative = differences(k, l, difference);
    if (negative == 0 || negative == 15) return;
    const dvec3 steepest = k.gradient - l.pressure().gradient;
    const double steepness = glm::length(steepest);
    if (!(steepness > 0)) return;
    const dvec3 normal = steepest / steepness;
    TetSlice slice;
    slice_tet(k.corners, a_.vertices_of(k.index), difference, slice);
    const std::array<int, 3> basis = basis_of(slice, normal);
    std::array<dvec3, 3> x;
    for (std::size_t i = 0; i < 3; ++i) x[i] = slice.points[static_cast<std::size_t>(basis[i])];
    const double corners[3][3] = {{x[0].x, x[0].y, x[0].z}, {x[1].x, x[1].y, x[1].z}, {x[2].x, x[2].y, x[2].z}};
    TriangleInTet in_tet;
    classify(corners, l, index, in_tet);  // for the distances: the basis is not the whole slice
    const SurfaceTriangle triangle = writer_.triangle(x, normal);
    PlanePolygon polygon, other;
    std::memset(&polygon, 0, sizeof(polygon));
    std::memset(&other, 0, sizeof(other));
    const PackedTet& own = a_.tets()[static_cast<std::size_t>(k.index)];
    const bool own_core = to_plane(slice, basis, triangle, own.core_faces, polygon);
    if (polygon.count == 0 || !find_cuts(polygon, l, index, in_tet)) return;
    const ClipResult clipped = clip(in_tet, l, &polygon, &other);
    if (clipped.polygon == nullptr) return;
    const bool at_core = clipped.at_core || (own_core && clipped.polygon == &polygon && polygon.count == slice.count);
    emit(*clipped.polygon, at_core, triangle, l.pressure(), {k.index, -1, std::min(own.size, l.size), index}, writer_);
  }

  /// Sets which planes of l to cut by; false where l does not hold the polygon. One that lies in a face shared by two
  /// tets belongs to that of the lower number. The two see its distances with different rounding, since each has its own
  /// linear pressure: within a small part of the tet's size the polygon counts as in the face.
  static HWY_INLINE bool find_cuts(const PlanePolygon& polygon, const PackedTet& l, std::int32_t index,
                                   TriangleInTet& in_tet) {
    const double most = 1e-10 * l.size;
    in_tet.cut = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double d0 = in_tet.corner[0][i], d1 = in_tet.corner[1][i], d2 = in_tet.corner[2][i];
      bool in_face = true, outside = true, inside = true;
      for (int n = 0; n < polygon.count; ++n) {
        const double u = polygon.u[n], v = polygon.v[n], distance = (1 - u - v) * d0 + u * d1 + v * d2;
        in_face = in_face && std::abs(distance) <= most;
        outside = outside && distance < 0;
        inside = inside && !(distance < 0);
      }
      if (in_face && l.neighbour[i] >= 0 && l.neighbour[i] < index) return false;
      if (in_face || inside) continue;
      if (outside) return false;
      in_tet.cut |= 1u << i;
    }
    return true;
  }

  const FieldIndex &a_, &b_;
  const RigidTransform& X_BA_;
  SurfaceWriter& writer_;
  IntersectWorkspace& workspace_;
};

void run_tets(const FieldIndex& a, const FieldIndex& b, const RigidTransform& X_BA, SurfaceWriter& writer,
              IntersectWorkspace& workspace) {
  TetsAndTets(a, b, X_BA, writer, workspace).run();
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_tets);

void intersect_tets(const FieldIndex& a, const FieldIndex& b, const RigidTransform& X_BA, SurfaceWriter& writer,
                    IntersectWorkspace& workspace) {
  HWY_DYNAMIC_DISPATCH(run_tets)(a, b, X_BA, writer, workspace);
}
}  // namespace taxel
#endif
