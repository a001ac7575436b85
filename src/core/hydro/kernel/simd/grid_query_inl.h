// Finds the boxes of a tree that may touch a field in another frame. The sphere around a box replaces the box; its
// distance comes from the field's grid. Included once per target.
#if defined(TAXEL_GRID_QUERY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_GRID_QUERY_INL_H
#undef TAXEL_GRID_QUERY_INL_H
#else
#define TAXEL_GRID_QUERY_INL_H
#endif

#include <bit>

#include "core/hydro/kernel/index/distance_grid.h"
#include "core/hydro/kernel/simd/tree_query_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// Finds the boxes whose spheres reach the part of the grid that the field covers.
struct GridQuery {
  const DistanceGrid* grid;
  float R[3][3], t[3], top[3], slack, edge;

  /// X_GT: pose of the tree's frame in the grid's.
  HWY_INLINE void set(const DistanceGrid& g, const RigidTransform& X_GT, const WideBvh& tree) {
    grid = &g;
    const dvec3 shift = X_GT(tree.origin()) - g.low();
    edge = static_cast<float>(1.0 / g.cells_per_metre());
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) R[i][k] = static_cast<float>(X_GT.R[k][i]);
      t[i] = static_cast<float>(shift[i]);
      top[i] = static_cast<float>(g.dims()[i]) * edge;
    }
    const double size = tree.size() + static_cast<double>(top[0] + top[1] + top[2]);
    slack = static_cast<float>(4e-6 * size);
  }

  HWY_INLINE VecF coordinate(int i, VecF x, VecF y, VecF z) const {
    const TagF f;
    return hn::Add(hn::Add(hn::Mul(hn::Set(f, R[i][0]), x), hn::Mul(hn::Set(f, R[i][1]), y)),
                   hn::Add(hn::Mul(hn::Set(f, R[i][2]), z), hn::Set(f, t[i])));
  }

  HWY_INLINE unsigned meets(const WideBvh::Node& node) const {
    const TagF f;
    alignas(32) float place[3][kWide], clamped[3][kWide], radius[kWide];
    unsigned bits = 0;
    const VecF zero = hn::Zero(f);
    for (std::size_t i = 0; i < kWide; i += kLanesF) {
      const BoxLanes b = load_boxes(node, i);
      const VecF r = hn::Sqrt(hn::Add(hn::Add(hn::Mul(b.ex, b.ex), hn::Mul(b.ey, b.ey)), hn::Mul(b.ez, b.ez)));
      const VecF reach = hn::Add(r, hn::Set(f, slack));
      hn::Store(reach, f, radius + i);
      VecF squared = zero;
      for (int axis = 0; axis < 3; ++axis) {
        const VecF p = coordinate(axis, b.cx, b.cy, b.cz);
        const VecF inside = hn::Min(hn::Max(p, zero), hn::Set(f, top[axis]));
        const VecF beyond = hn::Sub(p, inside);
        squared = hn::Add(squared, hn::Mul(beyond, beyond));
        hn::Store(p, f, place[axis] + i);
        hn::Store(inside, f, clamped[axis] + i);
      }
      const auto near = hn::And(hn::Le(squared, hn::Mul(reach, reach)), hn::Le(b.lx, b.hx));  // unused lanes are empty
      bits |= mask_bits(f, near) << i;
    }
    unsigned kept = 0;
    const ivec3 most = grid->dims() - 1;
    const float scale = 1.0f / edge;
    for (unsigned rest = bits; rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
      const int x = std::min(static_cast<int>(clamped[0][lane] * scale), most.x);
      const int y = std::min(static_cast<int>(clamped[1][lane] * scale), most.y);
      const int z = std::min(static_cast<int>(clamped[2][lane] * scale), most.z);
      const DistanceGrid::Cell& cell =
          grid->cells()[static_cast<std::size_t>(x + grid->dims().x * (y + grid->dims().y * z))];
      if (cell.distance > radius[lane]) continue;
      if (cell.face >= 0) {
        const DistanceGrid::Face& face = grid->faces()[static_cast<std::size_t>(cell.face)];
        const dvec3 center(place[0][lane], place[1][lane], place[2][lane]);
        if (glm::dot(face.n, center + grid->low()) + face.offset < -radius[lane]) continue;
      }
      kept |= 1u << lane;
    }
    return kept;
  }
};

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
