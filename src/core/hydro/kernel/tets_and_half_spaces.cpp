// Soft tets against a rigid or a soft half-space: one slice per tet, eight tets at a time.
//
// The surface is a plane in each tet: the plane of a rigid half-space, or, for a soft one, the plane on which the
// pressure of the tet equals that of the half-space, whose normal differs from tet to tet. A slice of a tet by a plane
// is a triangle or a quadrangle and needs no clipping, so eight tets go through the same operations in the lanes of
// vectors (eight_slices_inl.h).
//
// 1. The tree gives the tets that the plane may cross (rigid), or that may be behind it (soft).
// 2. A first pass keeps the tets with corners on both sides, in their order.
// 3. A second pass slices eight of them and stores the polygons.
//
// A slice that is merged, rejected, or may end on a pad's core is made again by the code for one tet, which gives the
// same bits where both apply. Lanes beyond the last tet repeat the first tet of their group. Theory:
// docs/theory/hydro.md, "Contact surface".
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/hydro/kernel/tets_and_half_spaces.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include "core/hydro/kernel/kernels.h"
#include "core/hydro/kernel/simd/eight_slices_inl.h"
#include "core/hydro/kernel/simd/emit_inl.h"
#include "core/hydro/kernel/simd/slice_inl.h"
#include "core/hydro/kernel/simd/tree_query_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// The plane of a rigid half-space, frame S.
struct RigidPlane {
  static constexpr bool kNeedsPressure = false;
  dvec3 normal;
  double offset;

  HWY_INLINE void find(const EightTets& tets, EightDistances& out) const {
    out.normal = set_points(normal);
    for (std::size_t i = 0; i < 4; ++i) out.at[i] = inner(out.normal, load_points(tets.corner[i])) + set_eight(offset);
  }
  /// Returns false if the surface is not in the tet.
  HWY_INLINE bool find(const FieldIndex&, std::int32_t, const std::array<dvec3, 4>& corners,
                       std::array<double, 4>& distances, dvec3& out) const {
    for (std::size_t i = 0; i < 4; ++i) distances[i] = glm::dot(normal, corners[i]) + offset;
    out = normal;
    return true;
  }
};

/// The pressure of a soft half-space, frame S. Distances are (p - p of the half-space)/|gradient|: in metres from the
/// plane where the two agree.
struct SoftPressure {
  static constexpr bool kNeedsPressure = true;
  LinearPressure pressure;

  HWY_INLINE void find(const EightTets& tets, EightDistances& out) const {
    const EightPoints gradient = set_points(pressure.gradient);
    const EightPoints difference = load_points(tets.gradient) - gradient;
    const Eight steepness = square_root(inner(difference, difference));
    for (std::size_t i = 0; i < 4; ++i) {
      const Eight other = inner(gradient, load_points(tets.corner[i])) + set_eight(pressure.constant);
      out.at[i] = (load_eight(tets.pressure[i]) - other) / steepness;  // no number where the two grow alike
    }
    out.normal = difference / steepness;
  }
  HWY_INLINE bool find(const FieldIndex& field, std::int32_t index, const std::array<dvec3, 4>& corners,
                       std::array<double, 4>& distances, dvec3& out) const {
    const std::array<double, 4> own = field.corner_pressures(index);
    const dvec3 difference = field.tets()[static_cast<std::size_t>(index)].pressure().gradient - pressure.gradient;
    const double steepness = glm::length(difference);
    if (!(steepness > 0)) return false;
    for (std::size_t i = 0; i < 4; ++i)
      distances[i] = (own[i] - (glm::dot(pressure.gradient, corners[i]) + pressure.constant)) / steepness;
    out = difference / steepness;
    return true;
  }
};

/// Adds the slices of tets in the order in which they are given, eight at a time.
template <class Surface>
class HalfSpaceSlices {
 public:
  HalfSpaceSlices(const FieldIndex& field, const Surface& surface, SurfaceWriter& writer)
      : field_(field), surface_(surface), writer_(writer) {}

  /// Removes those of `tets` that the surface does not cut, and adds the slices of the others.
  void run(std::vector<std::int32_t>& tets) {
    keep_cut(tets);
    for_each_eight(tets, true, [&](const EightTets& eight, std::size_t count) HWY_ATTR { add(eight, count); });
  }

 private:
  /// Calls f for eight tets at a time, and with their number at the end. Loads some before the first call: a vector
  /// that is read just after its lanes were written has to wait.
  template <class F>
  HWY_INLINE void for_each_eight(const std::vector<std::int32_t>& tets, bool whole, const F& f) {
    constexpr std::size_t kTogether = 4;
    EightTets eights[kTogether];
    for (std::size_t first = 0; first < tets.size();) {
      std::size_t loaded = 0;
      std::array<std::size_t, kTogether> counts{};
      for (; loaded < kTogether && first < tets.size(); ++loaded) {
        counts[loaded] = std::min<std::size_t>(8, tets.size() - first);
        load(tets.data() + first, counts[loaded], eights[loaded]);
        if (whole) load_rest(eights[loaded]);
        first += counts[loaded];
      }
      for (std::size_t i = 0; i < loaded; ++i) f(eights[i], counts[i]);
    }
  }

  /// Loads `count` tets; further lanes repeat the first.
  HWY_INLINE void load(const std::int32_t* indices, std::size_t count, EightTets& tets) const {
    const dvec3* vertices = field_.field().vertices().data();
    const double* pressure = field_.field().vertex_pressure().data();
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const std::int32_t index = indices[lane < count ? lane : 0];
      const ivec4& v = field_.vertices_of(index);
      tets.tet[lane] = index;
      for (int i = 0; i < 4; ++i) {
        const auto k = static_cast<std::size_t>(i);
        tets.corner[k].set(lane, vertices[v[i]]);
        if constexpr (Surface::kNeedsPressure) tets.pressure[k][lane] = pressure[v[i]];
      }
      if constexpr (Surface::kNeedsPressure)
        tets.gradient.set(lane, field_.tets()[static_cast<std::size_t>(index)].pressure().gradient);
    }
  }

  /// Loads the values that slices need and distances do not.
  HWY_INLINE void load_rest(EightTets& tets) const {
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const PackedTet& tet = field_.tets()[static_cast<std::size_t>(tets.tet[lane])];
      const ivec4& v = field_.vertices_of(tets.tet[lane]);
      for (int i = 0; i < 4; ++i) tets.number[static_cast<std::size_t>(i)][lane] = v[i];
      tets.gradient.set(lane, tet.pressure().gradient);
      tets.constant[lane] = tet.constant;
      tets.size[lane] = tet.size;
    }
  }

  void keep_cut(std::vector<std::int32_t>& tets) {
    std::size_t kept = 0;
    for_each_eight(tets, false, [&](const EightTets& eight, std::size_t count) HWY_ATTR {
      EightDistances distances;
      surface_.find(eight, distances);
      unsigned any = 0, all = 0xff;
      for (const Eight& at : distances.at) {
        const unsigned negative = less(at, set_eight(0.0));
        any |= negative;
        all &= negative;
      }
      for (unsigned rest = any & ~all & ((1u << count) - 1); rest != 0; rest &= rest - 1)
        tets[kept++] = eight.tet[static_cast<std::size_t>(std::countr_zero(rest))];
    });
    tets.resize(kept);
  }

  HWY_INLINE void add(const EightTets& tets, std::size_t count) {
    EightDistances distances;
    surface_.find(tets, distances);
    if constexpr (Surface::kNeedsPressure) {
      const EightPoints gradient = set_points(surface_.pressure.gradient);
      if (less(set_eight(0.0), inner(distances.normal, gradient)) != 0) writer_.back_faces().any = true;
    }
    const std::uint64_t sides = find_sides(distances);
    StoredSlices slices;
    slice_eight(tets, distances, sides, writer_.X_AS(), writer_.reverse(), slices);
    for (std::size_t lane = 0; lane < count; ++lane) {
      if ((slices.plain >> lane & 1u) != 0 && !may_end_at_core(tets.tet[lane], sides >> (8 * lane) & 15u)) {
        add_slice(slices, lane, tets.tet[lane], writer_);
      } else {
        add_alone(tets.tet[lane]);
      }
    }
  }

  /// Returns true if an edge of the slice is on a face of a pad's core.
  [[nodiscard]] HWY_INLINE bool may_end_at_core(std::int32_t index, std::size_t side) const {
    const std::uint32_t core = field_.tets()[static_cast<std::size_t>(index)].core_faces;
    if (core == 0) return false;
    const SliceRing& ring = kSliceRings[side];
    for (std::size_t e = 0; e < static_cast<std::size_t>(ring.count); ++e) {
      if ((core >> ring.face[e] & 1u) != 0) return true;
    }
    return false;
  }

  /// Adds the slice of one tet by itself: where vertices are merged, a polygon is left out, or ends on a core.
  HWY_NOINLINE void add_alone(std::int32_t index) {
    const PackedTet& tet = field_.tets()[static_cast<std::size_t>(index)];
    const std::array<dvec3, 4> corners = field_.corners(index);
    std::array<double, 4> distances;
    dvec3 normal;
    if (!surface_.find(field_, index, corners, distances, normal)) return;
    TetSlice slice;
    slice_tet(corners, field_.vertices_of(index), distances, slice);
    if (slice.count == 0) return;
    const std::array<int, 3> basis = basis_of(slice, normal);
    const SurfaceTriangle triangle = writer_.triangle(
        {slice.points[static_cast<std::size_t>(basis[0])], slice.points[static_cast<std::size_t>(basis[1])],
         slice.points[static_cast<std::size_t>(basis[2])]},
        normal);
    SliceInPlane in_plane;
    if (!to_plane(slice, basis, triangle.x_S, normal, in_plane)) return;
    emit(in_plane.polygon, tet.core_faces << kOwnEdge, triangle, tet.pressure(), {index, -1, tet.size}, writer_);
  }

  const FieldIndex& field_;
  const Surface& surface_;
  SurfaceWriter& writer_;
};

void run_plane(const FieldIndex& field, const dvec3& normal, double offset, SurfaceWriter& writer,
               KernelMemory& workspace) {
  ThroughPlane query;
  query.plane.set(normal, glm::dot(normal, field.tree().origin()) + offset, field.tree());
  workspace.tets.clear();
  collect(field.tree(), query, workspace.tets);
  const RigidPlane surface{normal, offset};
  HalfSpaceSlices(field, surface, writer).run(workspace.tets);
}

void run_soft_half_space(const FieldIndex& field, const LinearPressure& pressure, SurfaceWriter& writer,
                         KernelMemory& workspace) {
  const double stiffness = glm::length(pressure.gradient);
  const dvec3 inward = pressure.gradient / stiffness;
  BehindPlane query;
  query.plane.set(-inward, -(glm::dot(inward, field.tree().origin()) + pressure.constant / stiffness), field.tree());
  workspace.tets.clear();
  collect(field.tree(), query, workspace.tets);
  const SoftPressure surface{pressure};
  HalfSpaceSlices(field, surface, writer).run(workspace.tets);
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_plane);
HWY_EXPORT(run_soft_half_space);

void intersect_plane(const FieldIndex& field, const dvec3& normal, double offset, SurfaceWriter& writer,
                     KernelMemory& workspace) {
  HWY_DYNAMIC_DISPATCH(run_plane)(field, normal, offset, writer, workspace);
}
void intersect_soft_half_space(const FieldIndex& field, const LinearPressure& pressure, SurfaceWriter& writer,
                               KernelMemory& workspace) {
  HWY_DYNAMIC_DISPATCH(run_soft_half_space)(field, pressure, writer, workspace);
}
}  // namespace taxel
#endif
