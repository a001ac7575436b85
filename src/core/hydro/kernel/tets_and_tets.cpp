// Two soft bodies: the surface on which their pressures are equal. All is in the frame of A.
//
// In a pair of tets both pressures are linear, so the surface is the plane on which their difference is 0, inside of
// both tets: the tet of B is sliced by this plane, and the slice is clipped by the tet of A. The task is to find the
// pairs without testing all of them.
//
// 1. Seeds: where the surface ends, it ends on both skins at once, or on a face of one body's boundary that has
//    pressure, such as a pad's core. So every connected part of the surface passes through a tet of B and a tet of A
//    whose skins cross, or through a tet at such a face. Trees find these pairs; a face of B that is wholly inside or
//    outside of a convex A has none.
// 2. Flood fill: an edge of a polygon is on a face of the tet of A or of B. The pair across this face comes next. Pairs
//    that were found are kept per tet of B (workspace.h).
//
// Pitfalls. If one body is wholly inside of the other, there is no seed, and a surface through an edge or along a face
// of tets leaves the flood fill without a way to continue. In these cases, and for the tests, every tet of B near A is
// paired with the tets of A in its box. The two tets at a shared face see its distance with different rounding, so a
// surface within 1e-12 of the tet's size counts as in the face, which belongs to the tet with the lower number. Theory:
// docs/theory/hydro.md, "Contact surface".
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/hydro/kernel/tets_and_tets.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include "core/base/math.h"
#include "core/hydro/kernel/kernels.h"
#include "core/hydro/kernel/simd/emit_inl.h"
#include "core/hydro/kernel/simd/locate_inl.h"
#include "core/hydro/kernel/simd/slice_inl.h"
#include "core/hydro/kernel/simd/tree_query_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

class TetsAndTets {
 public:
  TetsAndTets(const FieldIndex& a, const FieldIndex& b, const RigidTransform& X_AB, SurfaceWriter& writer,
              KernelMemory& workspace)
      : a_(a), b_(b), X_AB_(X_AB), writer_(writer), w_(workspace) {
    no_pressure_ = kNearlyFlat * std::max(a.field().max_pressure(), b.field().max_pressure());
  }

  void run() {
    w_.begin_call(b_.field().vertices().size());
    const SurfaceWriter::Mark nothing = writer_.mark();
    if (!w_.tree_form) {
      w_.met.begin(w_.call, b_.tets().size());
      seed_from_boundary_of_b();
      if (a_.ends_inside()) seed_from_inner_boundary_of_a();
      flood();
      if (writer_.polygon_count() > 0 && !degenerate_) return;
      writer_.forget_since(nothing);
    }
    GridQuery near;
    near.set(a_.grid(), X_AB_, b_.tree());
    w_.facets.clear();
    collect(b_.tree(), near, w_.facets);
    for (const std::int32_t k : w_.facets) add_by_tree(k);
  }

 private:
  /// A tet of B, frame A.
  struct TetOfB {
    std::int32_t index;
    std::array<dvec3, 4> corners;
    std::array<double, 4> pressure;
    dvec3 gradient;
    alignas(32) double x[4], y[4], z[4];
  };

  static constexpr std::int32_t kNotLocated = std::numeric_limits<std::int32_t>::min();

  HWY_INLINE const dvec3& position(int vertex) {
    PlacedVertex& placed = w_.placed[at(vertex)];
    if (placed.call != w_.call) {
      placed.call = w_.call;
      placed.x = X_AB_(b_.field().vertices()[at(vertex)]);
      placed.tet = kNotLocated;
    }
    return placed.x;
  }

  /// Returns true if A has pressure at x, which its tet `index` holds: x is not in its skin.
  [[nodiscard]] HWY_INLINE bool pushes_at(std::int32_t index, const dvec3& x) const {
    const LinearPressure p = a_.tets()[at(index)].pressure();
    return glm::dot(p.gradient, x) + p.constant > no_pressure_;
  }

  /// Seeds the surface where a face of B's skin, at x, crosses the skin of A, which is convex. Returns false if only a
  /// query finds the seeds. The skin of A cuts a face that has corners on both sides along one arc or two. Each of them
  /// ends on an edge with ends on both sides, two arcs on different ones, and there one corner is inside.
  HWY_INLINE bool seed_from_corners(const FieldIndex::BoundaryFace& face, const std::array<dvec3, 3>& x) {
    std::array<std::int32_t, 3> held;
    unsigned inside = 0, outside = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      PlacedVertex& placed = w_.placed[at(face.vertices[i])];
      if (placed.tet == kNotLocated) placed.tet = locate(a_, placed.x);
      held[i] = placed.tet;
      if (held[i] < 0) {
        outside |= 1u << i;
      } else if (pushes_at(held[i], x[i])) {
        inside |= 1u << i;
      }
    }
    if (inside == 7 || beyond_a_face(a_, x, held)) return true;
    if (inside == 0 || (inside | outside) != 7) return false;
    const auto from = static_cast<std::size_t>(std::countr_zero(inside));
    const bool one_arc = (inside & (inside - 1)) != 0;
    for (; outside != 0; outside &= outside - 1) {
      const std::int32_t tet = leave(a_, held[from], x[from], x[static_cast<std::size_t>(std::countr_zero(outside))]);
      if (tet < 0) return false;
      meet(face.tet, tet);
      if (one_arc) break;
    }
    return true;
  }

  HWY_INLINE void load(std::int32_t index, TetOfB& k) {
    k.index = index;
    k.gradient = X_AB_.R * b_.tets()[at(index)].pressure().gradient;
    const ivec4& v = b_.vertices_of(index);
    for (int i = 0; i < 4; ++i) {
      const dvec3& c = position(v[i]);
      k.corners[at(i)] = c;
      k.pressure[at(i)] = b_.field().vertex_pressure()[at(v[i])];
      k.x[i] = c.x, k.y[i] = c.y, k.z[i] = c.z;
    }
  }

  void seed_from_boundary_of_b() {
    GridQuery near;
    near.set(a_.grid(), X_AB_, b_.boundary_tree());
    w_.facets.clear();
    collect(b_.boundary_tree(), near, w_.facets);
    for (const std::int32_t number : w_.facets) {
      const FieldIndex::BoundaryFace& face = b_.boundary_faces()[at(number)];
      const std::array<dvec3, 3> x{position(face.vertices[0]), position(face.vertices[1]), position(face.vertices[2])};
      if (face.skin && a_.convex() && seed_from_corners(face, x)) continue;
      FacetQuery query;
      const WideBvh& tree = face.skin ? a_.boundary_tree() : a_.tree();
      const dvec3 normal = glm::normalize(glm::cross(x[1] - x[0], x[2] - x[0]));
      query.set(x, normal, tree);
      w_.found.clear();
      collect(tree, query, w_.found);
      for (const std::int32_t other : w_.found) {
        if (!face.skin) {
          meet(face.tet, other);
        } else if (const FieldIndex::BoundaryFace& skin = a_.boundary_faces()[at(other)]; may_cross(x, normal, skin)) {
          meet(face.tet, skin.tet);
        }
      }
    }
  }

  /// Returns true if a triangle and a face of A reach both sides of each other's plane, or touch it.
  [[nodiscard]] HWY_INLINE bool may_cross(const std::array<dvec3, 3>& x, const dvec3& normal,
                                          const FieldIndex::BoundaryFace& face) const {
    const PackedTet& tet = a_.tets()[at(face.tet)];
    const std::size_t i = at(face.side);
    const dvec3 n(tet.nx[i], tet.ny[i], tet.nz[i]);
    const double touching = kNearlyFlat * tet.size;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const dvec3& corner : x) {
      const double d = glm::dot(n, corner) + tet.offset[i];
      least = std::min(least, d), most = std::max(most, d);
    }
    if (least > touching || most < -touching) return false;
    least = std::numeric_limits<double>::infinity(), most = -least;
    for (const std::int32_t v : face.vertices) {
      const double d = glm::dot(normal, a_.field().vertices()[at(v)] - x[0]);
      least = std::min(least, d), most = std::max(most, d);
    }
    return !(least > touching || most < -touching);
  }

  void seed_from_inner_boundary_of_a() {
    RigidTransform X_BA;
    X_BA.R = glm::transpose(X_AB_.R);
    X_BA.p = -(X_BA.R * X_AB_.p);
    GridQuery near;
    near.set(b_.grid(), X_BA, a_.boundary_tree());
    w_.facets.clear();
    collect(a_.boundary_tree(), near, w_.facets);
    for (const std::int32_t number : w_.facets) {
      const FieldIndex::BoundaryFace& face = a_.boundary_faces()[at(number)];
      if (face.skin) continue;
      std::array<dvec3, 3> x;
      for (std::size_t i = 0; i < 3; ++i) x[i] = X_BA(a_.field().vertices()[at(face.vertices[i])]);
      FacetQuery query;
      query.set(x, glm::normalize(glm::cross(x[1] - x[0], x[2] - x[0])), b_.tree());
      w_.found.clear();
      collect(b_.tree(), query, w_.found);
      for (const std::int32_t other : w_.found) meet(other, face.tet);
    }
  }

  void flood() {
    TetOfB k;
    for (std::int32_t tet_b = w_.met.next(); tet_b >= 0; tet_b = w_.met.next()) {
      load(tet_b, k);
      w_.met.for_each_new(tet_b, [&](std::int32_t tet_a) HWY_ATTR {
        const unsigned edges = add_pair(k, tet_a);
        for (unsigned bits = edges & 0xF; bits != 0; bits &= bits - 1)
          meet(tet_b, a_.tets()[at(tet_a)].neighbour[static_cast<std::size_t>(std::countr_zero(bits))]);
        for (unsigned bits = edges >> kOwnEdge; bits != 0; bits &= bits - 1)
          meet(b_.tets()[at(tet_b)].neighbour[static_cast<std::size_t>(std::countr_zero(bits))], tet_a);
      });
    }
  }

  HWY_INLINE void meet(std::int32_t tet_b, std::int32_t tet_a) {
    if (tet_b >= 0 && tet_a >= 0) w_.met.insert(tet_b, tet_a);
  }

  void add_by_tree(std::int32_t index) {
    TetOfB k;
    load(index, k);
    Aabb box;
    for (const dvec3& c : k.corners) box.include(c);
    BoxQuery query;
    query.set(box, a_.tree());
    w_.tets.clear();
    collect(a_.tree(), query, w_.tets);
    for (const std::int32_t l : w_.tets) add_pair(k, l);
  }

  /// pB - pA at the corners of k, with the linear pressure of tet l, and which are negative.
  HWY_INLINE unsigned differences(const TetOfB& k, const PackedTet& l, std::array<double, 4>& difference) {
    const TagD d;
    const VecD small = hn::Set(d, no_pressure_);
    unsigned negative = 0, zero = 0;
    for (std::size_t i = 0; i < 4; i += kLanesD) {
      const VecD p =
          plane(hn::Set(d, l.gradient[0]), hn::Load(d, k.x + i), hn::Set(d, l.gradient[1]), hn::Load(d, k.y + i),
                hn::Set(d, l.gradient[2]), hn::Load(d, k.z + i), hn::Set(d, l.constant));
      const VecD value = hn::Sub(hn::LoadU(d, k.pressure.data() + i), p);
      hn::StoreU(value, d, difference.data() + i);
      negative |= mask_bits(d, hn::Lt(value, hn::Zero(d))) << i;
      zero |= mask_bits(d, hn::Le(hn::Abs(value), small)) << i;
    }
    degenerate_ = degenerate_ || (zero & (zero - 1)) != 0;
    return negative;
  }

  /// Returns the marks of the polygon's edges: those of l's planes and, from kOwnEdge on, of k's.
  unsigned add_pair(const TetOfB& k, std::int32_t index) {
    const PackedTet &l = a_.tets()[at(index)], &own = b_.tets()[at(k.index)];
    std::array<double, 4> difference;
    const unsigned negative = differences(k, l, difference);
    if (negative == 0 || negative == 15) return 0;
    const dvec3 steepest = k.gradient - l.pressure().gradient;
    const double steepness = glm::length(steepest);
    if (!(steepness > 0)) return 0;
    const dvec3 normal = steepest / steepness;
    TetSlice slice;
    slice_tet(k.corners, b_.vertices_of(k.index), difference, slice);
    const std::array<int, 3> basis = basis_of(slice, normal);
    std::array<dvec3, 3> x;
    for (std::size_t i = 0; i < 3; ++i) x[i] = slice.points[at(basis[i])];
    const double corners[3][3] = {{x[0].x, x[0].y, x[0].z}, {x[1].x, x[1].y, x[1].z}, {x[2].x, x[2].y, x[2].z}};
    FacetInTet in_tet;
    classify(corners, 3, l, index, in_tet);  // for the distances: the basis is not the whole slice
    SliceInPlane in_plane;
    if (!to_plane(slice, basis, x, normal, in_plane) || !find_cuts(in_plane, l, index, in_tet)) return 0;
    PlanePolygon& polygon = in_plane.polygon;
    if (!clip(in_tet, polygon)) return 0;
    writer_.back_faces().note(glm::dot(k.gradient, normal), k.gradient);  // that of A is noted with the polygon
    emit(polygon, l.core_faces | own.core_faces << kOwnEdge, writer_.triangle(x, normal), l.pressure(),
         {index, -1, std::min(own.size, l.size), k.index}, writer_);
    return edge_bits(polygon);
  }

  /// Sets which planes of l to cut by. Returns false if l does not hold the polygon.
  HWY_INLINE bool find_cuts(const SliceInPlane& slice, const PackedTet& l, std::int32_t index, FacetInTet& in_tet) {
    const TagD d;
    const VecD tolerance = hn::Set(d, 1e-12 * l.size), u = hn::Set(d, slice.fourth.x), v = hn::Set(d, slice.fourth.y);
    const VecD w = hn::Sub(hn::Sub(hn::Set(d, 1.0), u), v);
    unsigned in_face = 0, outside = 0, below = 0;
    for (std::size_t i = 0; i < 4; i += kLanesD) {
      const VecD d0 = hn::Load(d, in_tet.corner[0] + i), d1 = hn::Load(d, in_tet.corner[1] + i);
      const VecD d2 = hn::Load(d, in_tet.corner[2] + i);
      VecD least = hn::Min(hn::Min(d0, d1), d2), most = hn::Max(hn::Max(d0, d1), d2);
      if (slice.polygon.count == 4) {
        const VecD fourth = hn::Add(hn::Add(hn::Mul(w, d0), hn::Mul(u, d1)), hn::Mul(v, d2));
        least = hn::Min(least, fourth);
        most = hn::Max(most, fourth);
      }
      in_face |= mask_bits(d, hn::Le(hn::Max(most, hn::Neg(least)), tolerance)) << i;
      outside |= mask_bits(d, hn::Lt(most, hn::Zero(d))) << i;
      below |= mask_bits(d, hn::Lt(least, hn::Zero(d))) << i;
    }
    degenerate_ = degenerate_ || in_face != 0;
    for (unsigned faces = in_face; faces != 0; faces &= faces - 1) {
      const std::int32_t neighbour = l.neighbour[static_cast<std::size_t>(std::countr_zero(faces))];
      if (neighbour >= 0 && neighbour < index) return false;
    }
    in_tet.cut = below & ~in_face;
    return (outside & ~in_face) == 0;
  }

  const FieldIndex &a_, &b_;
  const RigidTransform& X_AB_;
  SurfaceWriter& writer_;
  KernelMemory& w_;
  double no_pressure_;       ///< a smaller one, and a smaller difference, is rounding [Pa]
  bool degenerate_ = false;  ///< the surface passes through an edge or along a face of tets
};

void run_tets(const FieldIndex& a, const FieldIndex& b, const RigidTransform& X_AB, SurfaceWriter& writer,
              KernelMemory& workspace) {
  TetsAndTets(a, b, X_AB, writer, workspace).run();
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_tets);

void intersect_tets(const FieldIndex& a, const FieldIndex& b, const RigidTransform& X_AB, SurfaceWriter& writer,
                    KernelMemory& workspace) {
  HWY_DYNAMIC_DISPATCH(run_tets)(a, b, X_AB, writer, workspace);
}
}  // namespace taxel
#endif
