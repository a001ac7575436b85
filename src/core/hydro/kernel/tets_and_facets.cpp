// Soft tets against the facets of a rigid mesh. Each part of a facet inside of a tet becomes a polygon of the contact
// surface.
//
// 1. The tree of the facets is searched for those that the field may reach, by its grid of distances.
// 2. Seeds are the tets that contain the corners of a facet (each vertex is located once per call), and the boundary
//    tets that the facet intersects. The second kind needs a search in a tree, which is left out where the corners show
//    that there is none to find.
// 3. From the seeds the traversal clips the facet by each tet and continues across each face of the tet that bounds the
//    clipped polygon.
//
// Every connected part of the intersection of a facet with the tets contains a corner of the facet or crosses the
// boundary, so the traversal reaches all parts, and it visits few tets that the facet does not intersect.
//
// Pitfalls. Rounding decides on which side of a plane a facet in that plane is, and the traversal may lose a part
// there. So a facet in a plane of some tet, and a facet inside of the field whose parts do not add up to its area, are
// done again with all tets that the tree finds. Facets longer than six mean tets begin with the tree. Facets that end
// at a core, or that have a corner inside of the skin in no tet, are listed for depth_pieces.h. Theory:
// docs/theory/hydro.md, "Contact surface".
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/hydro/kernel/tets_and_facets.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include <hwy/cache_control.h>

#include "core/base/math.h"
#include "core/hydro/kernel/kernels.h"
#include "core/hydro/kernel/simd/clip_inl.h"
#include "core/hydro/kernel/simd/emit_inl.h"
#include "core/hydro/kernel/simd/locate_inl.h"
#include "core/hydro/kernel/simd/tree_query_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

class TetsAndFacets {
 public:
  TetsAndFacets(const FieldIndex& field, const FacetTree& rigid, const RigidTransform& X_SR, SurfaceWriter& writer,
                KernelMemory& workspace)
      : field_(field), rigid_(rigid), X_SR_(X_SR), writer_(writer), w_(workspace) {}

  void run() {
    GridQuery query;
    query.set(field_.grid(), X_SR_, rigid_.tree());
    w_.facets.clear();
    collect(rigid_.tree(), query, w_.facets);
    w_.begin_call(rigid_.vertices().size(), field_.tets().size());
    w_.depth.facets.clear();
    any_beyond_ = w_.tree_form;
    if (!field_.goes_on()) {
      for (const std::int32_t f : w_.facets) add(rigid_.facets()[at(f)]);
      return;
    }
    for (const std::int32_t f : w_.facets) {
      const std::size_t first = writer_.polygon_count();
      const int at_core = writer_.core_count();
      add(rigid_.facets()[at(f)]);
      if (writer_.core_count() != at_core || (any_beyond_ && reaches_beyond(rigid_.facets()[at(f)])))
        w_.depth.facets.push_back({f, first, writer_.polygon_count()});
    }
  }

 private:
  static constexpr unsigned kPlanes = 0xF;  // marks of a tet's planes
  static constexpr double kLarge = 6.0;     // times a tet: the walk meets as many tets as the tree, and needs its seeds

  struct Current {
    SurfaceTriangle triangle;          ///< corners 0, 1 and 2 of the facet
    std::array<dvec3, 4> x;            ///< corners, frame S [m]
    std::array<std::int32_t, 4> held;  ///< results of locate() for the corners
    int count;                         ///< 3 or 4
    double corners[3][3];
    std::int32_t face;
    dvec3 normal;

    [[nodiscard]] HWY_INLINE std::array<dvec3, 3> first_three() const { return {x[0], x[1], x[2]}; }
    [[nodiscard]] HWY_INLINE std::span<const std::int32_t> all_held() const { return {held.data(), at(count)}; }
    [[nodiscard]] HWY_INLINE double area() const { return count == 3 ? triangle.area : 2 * triangle.area; }
  };

  /// Position and tet of a vertex of the mesh, found once per call.
  HWY_INLINE const PlacedVertex& place(std::int32_t vertex) {
    PlacedVertex& placed = w_.placed[at(vertex)];
    if (placed.call == w_.call) return placed;
    placed.call = w_.call;
    placed.x = X_SR_(rigid_.vertices()[at(vertex)]);
    placed.tet = w_.tree_form ? kOutside : locate(field_, placed.x);
    if (placed.tet < kOutside && may_be_beyond(field_, placed.tet, placed.x)) any_beyond_ = true;
    return placed;
  }

  void add(const FacetTree::Facet& source) {
    Current c;
    c.count = source.corners;
    for (std::size_t k = 0; k < at(c.count); ++k) {
      const PlacedVertex& placed = place(source.vertex[k]);
      c.x[k] = placed.x;
      c.held[k] = placed.tet;
    }
    for (std::size_t k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis) c.corners[k][axis] = c.x[k][axis];
    c.normal = X_SR_.R * source.normal;
    c.face = source.face;
    const dvec3 u = c.x[1] - c.x[0], v = c.x[2] - c.x[0];
    if (c.count == 4) c.x[3] = c.x[1] + v;
    const double large = kLarge * field_.mean_tet_size();
    if (w_.tree_form || std::max(glm::dot(u, u), glm::dot(v, v)) > large * large) {
      c.triangle = writer_.triangle(c.first_three(), c.normal);
      add_by_tree(c);
      return;
    }
    const auto held = c.all_held();
    const bool in_one = std::all_of(held.begin(), held.end(), [&](std::int32_t tet) { return tet == held[0]; });
    if (in_one && held[0] >= 0 && add_whole(c, held[0])) return;
    w_.tets.clear();
    ++w_.facet;
    for (const std::int32_t tet : held) meet(tet);
    const bool inside = std::all_of(held.begin(), held.end(), [](std::int32_t tet) { return tet >= 0; });
    const bool one_part = field_.convex() && !w_.tets.empty();
    if (!inside && !one_part && !(field_.convex() && beyond_a_face(field_, {c.x.data(), held.size()}, held)))
      add_seeds_at_boundary(c);
    if (w_.tets.empty()) return;
    c.triangle = writer_.triangle(c.first_three(), c.normal);
    const SurfaceWriter::Mark before = writer_.mark();
    flat_ = false;
    walk(c, 0);
    if (!inside && one_part && writer_.polygon_count() == before.polygons) {
      // A corner in a face between tets may be held by one that the facet only touches.
      const std::size_t walked = w_.tets.size();
      add_seeds_at_boundary(c);
      walk(c, walked);
    }
    constexpr double kWhole = 1e-12;
    if (flat_ || (inside && std::abs(writer_.area_since(before) - c.area()) > kWhole * c.area())) {
      writer_.forget_since(before);
      add_by_tree(c);
    }
  }

  /// Returns true if a corner lies, or may lie, inside of the body beyond all tets.
  [[nodiscard]] HWY_INLINE bool reaches_beyond(const FacetTree::Facet& source) {
    for (std::size_t k = 0; k < at(source.corners); ++k) {
      const PlacedVertex& placed = place(source.vertex[k]);
      if (may_be_beyond(field_, w_.tree_form ? locate(field_, placed.x) : placed.tet, placed.x)) return true;
    }
    return false;
  }

  /// A facet whose corners one tet holds is wholly inside of it. False where it lies in a plane of the tet.
  HWY_INLINE bool add_whole(Current& c, std::int32_t index) {
    const PackedTet& tet = field_.tets()[at(index)];
    FacetInTet in_tet;
    classify(c.corners, c.count, tet, index, in_tet);
    if (in_tet.flat || in_tet.disjoint || in_tet.cut != 0) return false;
    c.triangle = writer_.triangle(c.first_three(), c.normal);
    emit_whole(whole_facet(c.count), c.triangle, tet.pressure(), {index, c.face, tet.size}, writer_);
    return true;
  }

  HWY_INLINE void meet(std::int32_t tet) {
    if (tet < 0 || w_.seen_in[at(tet)] == w_.facet) return;
    w_.seen_in[at(tet)] = w_.facet;
    const char* lines = reinterpret_cast<const char*>(&field_.tets()[at(tet)]);
    hwy::Prefetch(lines), hwy::Prefetch(lines + 64), hwy::Prefetch(lines + 128);
    w_.tets.push_back(tet);
  }

  void add_seeds_at_boundary(const Current& c) {
    FacetQuery query;
    set(query, c, field_.boundary_tree());
    w_.found.clear();
    collect(field_.boundary_tree(), query, w_.found);
    for (const std::int32_t face : w_.found) meet(field_.boundary_faces()[at(face)].tet);
  }

  static HWY_INLINE void set(FacetQuery& query, const Current& c, const WideBvh& tree) {
    if (c.count == 3) return query.set({c.x.data(), 3}, c.normal, tree);
    const std::array<dvec3, 4> around{c.x[0], c.x[1], c.x[3], c.x[2]};
    query.set(around, c.normal, tree);
  }

  void walk(const Current& c, std::size_t first) {
    for (std::size_t next = first; next < w_.tets.size(); ++next) {
      const std::int32_t index = w_.tets[next];
      add_pair(c, index, [&](unsigned crossed) HWY_ATTR {
        for (; crossed != 0; crossed &= crossed - 1)
          meet(field_.tets()[at(index)].neighbour[static_cast<std::size_t>(std::countr_zero(crossed))]);
      });
    }
  }

  void add_by_tree(const Current& c) {
    FacetQuery query;
    set(query, c, field_.tree());
    w_.tets.clear();
    collect(field_.tree(), query, w_.tets);
    for (const std::int32_t index : w_.tets) add_pair(c, index, [](unsigned) {});
  }

  /// Calls go_on with the faces across which the facet continues.
  template <class F>
  HWY_INLINE void add_pair(const Current& c, std::int32_t index, const F& go_on) {
    const PackedTet& tet = field_.tets()[at(index)];
    FacetInTet in_tet;
    classify(c.corners, c.count, tet, index, in_tet);
    flat_ = flat_ || in_tet.flat;
    if (in_tet.disjoint) return;
    PlanePolygon polygon = whole_facet(c.count);
    if (!clip(in_tet, polygon)) return;
    go_on(edge_bits(polygon) & kPlanes);
    emit(polygon, tet.core_faces, c.triangle, tet.pressure(), {index, c.face, tet.size}, writer_);
  }

  const FieldIndex& field_;
  const FacetTree& rigid_;
  const RigidTransform& X_SR_;
  SurfaceWriter& writer_;
  KernelMemory& w_;
  bool any_beyond_ = false;  ///< some vertex placed so far may lie inside of the body beyond all tets
  bool flat_ = false;        ///< the current facet lies in a plane of some tet
};

void run_facets(const FieldIndex& field, const FacetTree& rigid, const RigidTransform& X_SR, SurfaceWriter& writer,
                KernelMemory& workspace) {
  TetsAndFacets(field, rigid, X_SR, writer, workspace).run();
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_facets);

void intersect_facets(const FieldIndex& field, const FacetTree& rigid, const RigidTransform& X_SR,
                      SurfaceWriter& writer, KernelMemory& workspace) {
  HWY_DYNAMIC_DISPATCH(run_facets)(field, rigid, X_SR, writer, workspace);
}
}  // namespace taxel
#endif
