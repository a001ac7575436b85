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

/// All in the frame of B. Where the surface ends, it ends on both skins at once, or on a face of one body's boundary
/// that has pressure, such as a pad's core. So every connected part of it passes through a tet of A and a tet of B
/// whose skins cross, or through a tet at such a face. From those pairs a flood reaches the rest, across the face of A
/// or of B that an edge of the polygon lies on. A body that lies wholly inside the other one leaves nothing to begin
/// with, and a surface through an edge or along a face of tets leaves the flood without a way on: then, and for the
/// tests, every tet of A near B meets the tets of B in its box (the tree form).
class TetsAndTets {
 public:
  TetsAndTets(const FieldIndex& a, const FieldIndex& b, const RigidTransform& X_BA, SurfaceWriter& writer,
              IntersectWorkspace& workspace)
      : a_(a), b_(b), X_BA_(X_BA), writer_(writer), w_(workspace) {}

  void run() {
    w_.begin_call(a_.field().vertices().size());
    const SurfaceWriter::Mark nothing = writer_.mark();
    if (!w_.tree_form) {
      w_.pairs.clear();
      seed_from_boundary_of_a();
      if (b_.ends_inside()) seed_from_inner_boundary_of_b();
      flood();
      if (writer_.polygon_count() > 0 && !degenerate_) return;
      writer_.forget_since(nothing);
    }
    GridQuery near;
    near.set(b_.grid(), X_BA_, a_.tree());
    w_.triangles.clear();
    collect(a_.tree(), near, w_.triangles);
    for (const std::int32_t k : w_.triangles) add_by_tree(k);
  }

 private:
  /// A tet of A, frame B.
  struct TetOfA {
    std::int32_t index;
    std::array<dvec3, 4> corners;
    std::array<double, 4> pressure;
    alignas(32) double x[4], y[4], z[4];
  };

  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

  HWY_INLINE const dvec3& position(int vertex) {
    PlacedVertex& placed = w_.placed[at(vertex)];
    if (placed.call != w_.call) {
      placed.call = w_.call;
      placed.x = X_BA_(a_.field().vertices()[at(vertex)]);
    }
    return placed.x;
  }

  HWY_INLINE void load(std::int32_t index, TetOfA& k) {
    k.index = index;
    const ivec4& v = a_.vertices_of(index);
    for (int i = 0; i < 4; ++i) {
      const dvec3& c = position(v[i]);
      k.corners[at(i)] = c;
      k.pressure[at(i)] = a_.field().vertex_pressure()[at(v[i])];
      k.x[i] = c.x, k.y[i] = c.y, k.z[i] = c.z;
    }
  }

  void seed_from_boundary_of_a() {
    GridQuery near;
    near.set(b_.grid(), X_BA_, a_.boundary_tree());
    w_.triangles.clear();
    collect(a_.boundary_tree(), near, w_.triangles);
    for (const std::int32_t number : w_.triangles) {
      const FieldIndex::BoundaryFace& face = a_.boundary_faces()[at(number)];
      const std::array<dvec3, 3> x{position(face.vertices[0]), position(face.vertices[1]), position(face.vertices[2])};
      TriangleQuery query;
      const WideBvh& tree = face.skin ? b_.boundary_tree() : b_.tree();
      query.set(x, glm::normalize(glm::cross(x[1] - x[0], x[2] - x[0])), tree);
      w_.found.clear();
      collect(tree, query, w_.found);
      for (const std::int32_t other : w_.found) meet(face.tet, face.skin ? b_.boundary_faces()[at(other)].tet : other);
    }
  }

  void seed_from_inner_boundary_of_b() {
    RigidTransform X_AB;
    X_AB.R = glm::transpose(X_BA_.R);
    X_AB.p = -(X_AB.R * X_BA_.p);
    GridQuery near;
    near.set(a_.grid(), X_AB, b_.boundary_tree());
    w_.triangles.clear();
    collect(b_.boundary_tree(), near, w_.triangles);
    for (const std::int32_t number : w_.triangles) {
      const FieldIndex::BoundaryFace& face = b_.boundary_faces()[at(number)];
      if (face.skin) continue;
      std::array<dvec3, 3> x;
      for (std::size_t i = 0; i < 3; ++i) x[i] = X_AB(b_.field().vertices()[at(face.vertices[i])]);
      TriangleQuery query;
      query.set(x, glm::normalize(glm::cross(x[1] - x[0], x[2] - x[0])), a_.tree());
      w_.found.clear();
      collect(a_.tree(), query, w_.found);
      for (const std::int32_t other : w_.found) meet(other, face.tet);
    }
  }

  void flood() {
    TetOfA k;
    while (!w_.pairs.empty()) {
      const auto [tet_a, tet_b] = w_.pairs.back();
      w_.pairs.pop_back();
      load(tet_a, k);
      const unsigned edges = add_pair(k, tet_b);
      for (unsigned bits = edges & 0xF; bits != 0; bits &= bits - 1)
        meet(tet_a, b_.tets()[at(tet_b)].neighbour[static_cast<std::size_t>(std::countr_zero(bits))]);
      for (unsigned bits = edges >> kOwnEdge; bits != 0; bits &= bits - 1)
        meet(a_.tets()[at(tet_a)].neighbour[static_cast<std::size_t>(std::countr_zero(bits))], tet_b);
    }
  }

  HWY_INLINE void meet(std::int32_t tet_a, std::int32_t tet_b) {
    if (tet_a >= 0 && tet_b >= 0 && w_.met.insert(tet_a, tet_b, w_.call)) w_.pairs.push_back({tet_a, tet_b});
  }

  void add_by_tree(std::int32_t index) {
    TetOfA k;
    load(index, k);
    Aabb box;
    for (const dvec3& c : k.corners) box.include(c);
    BoxQuery query;
    query.set(box, b_.tree());
    w_.tets.clear();
    collect(b_.tree(), query, w_.tets);
    for (const std::int32_t l : w_.tets) add_pair(k, l);
  }

  /// pA - pB at the corners of k, with the linear pressure of tet l, and which are negative.
  static HWY_INLINE unsigned differences(const TetOfA& k, const PackedTet& l, std::array<double, 4>& difference) {
    const TagD d;
    unsigned negative = 0;
    for (std::size_t i = 0; i < 4; i += kLanesD) {
      const VecD p =
          plane(hn::Set(d, l.gradient[0]), hn::Load(d, k.x + i), hn::Set(d, l.gradient[1]), hn::Load(d, k.y + i),
                hn::Set(d, l.gradient[2]), hn::Load(d, k.z + i), hn::Set(d, l.constant));
      const VecD value = hn::Sub(hn::LoadU(d, k.pressure.data() + i), p);
      hn::StoreU(value, d, difference.data() + i);
      negative |= mask_bits(d, hn::Lt(value, hn::Zero(d))) << i;
    }
    return negative;
  }

  /// Returns the marks of the polygon's edges: those of l's planes and, from kOwnEdge on, of k's.
  unsigned add_pair(const TetOfA& k, std::int32_t index) {
    const PackedTet &l = b_.tets()[at(index)], &own = a_.tets()[at(k.index)];
    std::array<double, 4> difference;
    const unsigned negative = differences(k, l, difference);
    const double most = kNearlyFlat * std::max(a_.field().max_pressure(), b_.field().max_pressure());
    int zeros = 0;
    for (const double d : difference) zeros += std::abs(d) <= most ? 1 : 0;
    degenerate_ = degenerate_ || zeros > 1;
    if (negative == 0 || negative == 15) return 0;
    const dvec3 steepest = X_BA_.R * own.pressure().gradient - l.pressure().gradient;
    const double steepness = glm::length(steepest);
    if (!(steepness > 0)) return 0;
    const dvec3 normal = steepest / steepness;
    TetSlice slice;
    slice_tet(k.corners, a_.vertices_of(k.index), difference, slice);
    const std::array<int, 3> basis = basis_of(slice, normal);
    std::array<dvec3, 3> x;
    for (std::size_t i = 0; i < 3; ++i) x[i] = slice.points[at(basis[i])];
    const double corners[3][3] = {{x[0].x, x[0].y, x[0].z}, {x[1].x, x[1].y, x[1].z}, {x[2].x, x[2].y, x[2].z}};
    TriangleInTet in_tet;
    classify(corners, l, index, in_tet);  // for the distances: the basis is not the whole slice
    PlanePolygon polygon;
    to_plane(slice, basis, x, polygon);
    if (polygon.count == 0 || !find_cuts(polygon, l, index, in_tet)) return 0;
    if (!clip(in_tet, polygon)) return 0;
    emit(polygon, l.core_faces | own.core_faces << kOwnEdge, writer_.triangle(x, normal), l.pressure(),
         {k.index, -1, std::min(own.size, l.size), index}, writer_);
    return edge_bits(polygon);
  }

  /// Sets which planes of l to cut by; false where l does not hold the polygon. One that lies in a face shared by two
  /// tets belongs to that of the lower number. The two see its distances with different rounding, since each has its
  /// own linear pressure: within a small part of the tet's size the polygon counts as in the face.
  HWY_INLINE bool find_cuts(const PlanePolygon& polygon, const PackedTet& l, std::int32_t index,
                            TriangleInTet& in_tet) {
    const double most = 1e-10 * l.size;
    const unsigned all = (1u << polygon.count) - 1;
    in_tet.cut = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Eight distance = distances_of(polygon, in_tet.corner[0][i], in_tet.corner[1][i], in_tet.corner[2][i]);
      const unsigned below = less(distance, set_eight(0.0)) & all;
      const bool in_face = ((less(distance, set_eight(-most)) | less(set_eight(most), distance)) & all) == 0;
      degenerate_ = degenerate_ || in_face;
      if (in_face && l.neighbour[i] >= 0 && l.neighbour[i] < index) return false;
      if (in_face || below == 0) continue;
      if (below == all) return false;
      in_tet.cut |= 1u << i;
    }
    return true;
  }

  const FieldIndex &a_, &b_;
  const RigidTransform& X_BA_;
  SurfaceWriter& writer_;
  IntersectWorkspace& w_;
  bool degenerate_ = false;  ///< the surface passes through an edge or along a face of tets
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
