// Finds the boxes of a WideBvh that a facet, a plane or a field in another frame may touch, by a conservative
// traversal, eight boxes at a time. Included once per target.
//
// A query tests eight boxes of a node in single precision and may only err by finding too many: exact tests in double
// precision follow. So it is widened by more than single precision loses (kBoxSlack). Facets use separating axes
// without those of crossed edges. A field in another frame uses the sphere around a box and the grid of distances, so
// that no box has to be turned.
#if defined(TAXEL_TREE_QUERY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_TREE_QUERY_INL_H
#undef TAXEL_TREE_QUERY_INL_H
#else
#define TAXEL_TREE_QUERY_INL_H
#endif

#include <bit>
#include <span>
#include <vector>

#include "core/hydro/kernel/index/field_index.h"
#include "core/hydro/kernel/index/wide_tree.h"
#include "core/hydro/kernel/simd/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// Boxes are widened by this part of the tree's size: more than single precision loses.
inline constexpr double kBoxSlack = 2e-6;

/// A half-space n . x + offset <= 0 relative to the tree's origin, in single precision; n of any length.
struct QueryPlane {
  float n[3], size[3], offset;  ///< size: absolute components of n
  float slack;                  ///< bound of the rounding error of n . x + offset

  HWY_INLINE void set(const dvec3& normal, double at_origin, const WideBvh& tree) {
    double length = 0;  // no less than |n|
    for (int i = 0; i < 3; ++i) {
      n[i] = static_cast<float>(normal[i]);
      size[i] = static_cast<float>(std::abs(normal[i]));
      length += std::abs(normal[i]);
    }
    offset = static_cast<float>(at_origin);
    slack = static_cast<float>(kBoxSlack * tree.size() * length);
  }
};

/// Some boxes of a node: bounds, centers c and half extents e.
struct BoxLanes {
  VecF lx, hx, ly, hy, lz, hz, cx, cy, cz, ex, ey, ez;
};
HWY_INLINE BoxLanes load_boxes(const WideBvh::Node& node, std::size_t i) {
  const TagF f;
  const VecF half = hn::Set(f, 0.5f);
  BoxLanes b;
  b.lx = hn::Load(f, &node.lo[0][i]), b.hx = hn::Load(f, &node.hi[0][i]);
  b.ly = hn::Load(f, &node.lo[1][i]), b.hy = hn::Load(f, &node.hi[1][i]);
  b.lz = hn::Load(f, &node.lo[2][i]), b.hz = hn::Load(f, &node.hi[2][i]);
  b.cx = hn::Mul(hn::Add(b.lx, b.hx), half), b.ex = hn::Sub(b.hx, b.cx);
  b.cy = hn::Mul(hn::Add(b.ly, b.hy), half), b.ey = hn::Sub(b.hy, b.cy);
  b.cz = hn::Mul(hn::Add(b.lz, b.hz), half), b.ez = hn::Sub(b.hz, b.cz);
  return b;
}

/// n . center + offset, and |n| . half: where a box lies and how far it reaches.
HWY_INLINE VecF box_position(const QueryPlane& q, const BoxLanes& b) {
  const TagF f;
  return hn::Add(hn::Add(hn::Mul(hn::Set(f, q.n[0]), b.cx), hn::Mul(hn::Set(f, q.n[1]), b.cy)),
                 hn::Add(hn::Mul(hn::Set(f, q.n[2]), b.cz), hn::Set(f, q.offset)));
}
HWY_INLINE VecF box_reach(const QueryPlane& q, const BoxLanes& b) {
  const TagF f;
  return hn::Add(hn::Add(hn::Mul(hn::Set(f, q.size[0]), b.ex), hn::Mul(hn::Set(f, q.size[1]), b.ey)),
                 hn::Add(hn::Mul(hn::Set(f, q.size[2]), b.ez), hn::Set(f, q.slack)));
}

/// Separating axes of a convex facet and a box: the box's three, the facet's normal, and in its plane the normals of
/// its edges. The axes of crossed edges are left out: the exact test that follows is cheaper than they are.
struct FacetQuery {
  float lo[3], hi[3];
  QueryPlane plane, edges[4];
  int corners;

  /// `x` holds the three or four corners, counter-clockwise about the normal.
  HWY_INLINE void set(std::span<const dvec3> x, const dvec3& normal, const WideBvh& tree) {
    const auto slack = static_cast<float>(kBoxSlack * tree.size());
    corners = static_cast<int>(x.size());
    Aabb box;
    for (const dvec3& corner : x) box.include(corner - tree.origin());
    for (int i = 0; i < 3; ++i) {
      lo[i] = static_cast<float>(box.lo[i]) - slack;
      hi[i] = static_cast<float>(box.hi[i]) + slack;
    }
    plane.set(normal, -glm::dot(normal, x[0] - tree.origin()), tree);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const dvec3& next = x[k + 1 < x.size() ? k + 1 : 0];
      const dvec3 out = glm::cross(next - x[k], normal);
      edges[k].set(out, -glm::dot(out, x[k] - tree.origin()), tree);
    }
  }

  HWY_INLINE unsigned meets(const WideBvh::Node& node) const {
    const TagF f;
    unsigned bits = 0;
    for (std::size_t i = 0; i < kWide; i += kLanesF) {
      const BoxLanes b = load_boxes(node, i);
      auto meet = hn::And(hn::And(hn::Le(b.lx, hn::Set(f, hi[0])), hn::Ge(b.hx, hn::Set(f, lo[0]))),
                          hn::And(hn::Le(b.ly, hn::Set(f, hi[1])), hn::Ge(b.hy, hn::Set(f, lo[1]))));
      meet = hn::And(meet, hn::And(hn::Le(b.lz, hn::Set(f, hi[2])), hn::Ge(b.hz, hn::Set(f, lo[2]))));
      meet = hn::And(meet, hn::Le(hn::Abs(box_position(plane, b)), box_reach(plane, b)));
      for (int k = 0; k < corners; ++k) meet = hn::And(meet, hn::Le(box_position(edges[k], b), box_reach(edges[k], b)));
      bits |= mask_bits(f, meet) << i;
    }
    return bits;
  }
};

/// Boxes that a plane passes through, or that reach into the half-space behind it.
template <bool kWholeSide>
struct PlaneQuery {
  QueryPlane plane;
  HWY_INLINE unsigned meets(const WideBvh::Node& node) const {
    const TagF f;
    unsigned bits = 0;
    for (std::size_t i = 0; i < kWide; i += kLanesF) {
      const BoxLanes b = load_boxes(node, i);
      const VecF position = box_position(plane, b);
      const auto meet = hn::Le(kWholeSide ? position : hn::Abs(position), box_reach(plane, b));
      bits |= mask_bits(f, hn::And(meet, hn::Le(b.lx, b.hx))) << i;  // unused lanes are empty
    }
    return bits;
  }
};
using ThroughPlane = PlaneQuery<false>;
using BehindPlane = PlaneQuery<true>;

/// Boxes that overlap one.
struct BoxQuery {
  float lo[3], hi[3];
  HWY_INLINE void set(const Aabb& box, const WideBvh& tree) {
    const double slack = kBoxSlack * tree.size();
    for (int i = 0; i < 3; ++i) {
      lo[i] = static_cast<float>(box.lo[i] - tree.origin()[i] - slack);
      hi[i] = static_cast<float>(box.hi[i] - tree.origin()[i] + slack);
    }
  }
  HWY_INLINE unsigned meets(const WideBvh::Node& node) const {
    const TagF f;
    unsigned bits = 0;
    for (std::size_t i = 0; i < kWide; i += kLanesF) {
      auto meet = hn::Le(hn::Load(f, &node.lo[0][i]), hn::Set(f, hi[0]));
      meet = hn::And(meet, hn::Ge(hn::Load(f, &node.hi[0][i]), hn::Set(f, lo[0])));
      for (std::size_t k = 1; k < 3; ++k) {
        meet = hn::And(meet, hn::Le(hn::Load(f, &node.lo[k][i]), hn::Set(f, hi[k])));
        meet = hn::And(meet, hn::Ge(hn::Load(f, &node.hi[k][i]), hn::Set(f, lo[k])));
      }
      bits |= mask_bits(f, meet) << i;
    }
    return bits;
  }
};

/// Finds the boxes that may touch a field in another frame: their spheres reach the part of the field's grid that the
/// field covers. The sphere around a box replaces the box; its distance comes from the grid.
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

/// Numbers of the items whose boxes a query meets, in the order of the tree, appended to `found`.
template <class Tree, class Query>
HWY_INLINE void collect(const Tree& tree, const Query& query, std::vector<std::int32_t>& found) {
  if (tree.nodes().empty()) return;
  std::int32_t stack[512];  // a tree of depth d holds at most 7 d + 1 waiting nodes, and halves at least thrice a level
  int waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const auto& node = tree.nodes()[static_cast<std::size_t>(stack[--waiting])];
    for (unsigned bits = query.meets(node); bits != 0; bits &= bits - 1) {
      const std::int32_t child = node.child[static_cast<std::size_t>(std::countr_zero(bits))];
      if (child < 0) {
        found.push_back(~child);
      } else {
        stack[waiting++] = child;
      }
    }
  }
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
