// The surface of equal pressure of two soft bodies where their tets do not reach, by marching tetrahedra (Doi, Koide
// 1991).
//
// Space is divided into cubes of a lattice in a frame half way between the two bodies. Each cube is six tets about its
// diagonal (Kuhn 1960), so neighbouring cubes divide their common face alike. The difference of the pressures at the
// nodes is taken as linear in each tet, and its zero is a slice. What polygons of the tets already cover, seen across
// the slice, is subtracted.
//
// 1. If the tets' surface ends at a core, the cubes at this rim come first, and neighbours follow across faces with
//    both signs of the difference, over at most three cubes in a row that add no area. A cube that is reached again
//    with more steps left is visited again, so that the set of cubes does not depend on the order.
// 2. If no tet has any surface, an octree over the volume that both bodies share drops each cube in which the pressures
//    cannot be equal: pressures are Lipschitz with the stiffness.
//
// Cost: one pressure of each body per node; of a pad it is a nearest-point query with an upper bound from the first
// node of the cube. Pitfalls: the lattice must not depend on which body is first, or the forces on both would not be
// opposite; origins are middles of slices for the same reason. A polygon of another sheet of the surface covers nothing
// (kSameSheet). Theory: docs/theory/hydro.md, "Beyond the tets".
#include "core/hydro/kernel/depth_march.h"

#include "core/base/math.h"
#include "core/hydro/kernel/slice_tet.h"

namespace taxel {
namespace {

/// A lattice point, in edges of the smallest cubes.
using Node = ivec3;

class PairMarch {
 public:
  PairMarch(const PressureAt& first, const PressureAt& second, const PressureAt& own, const RigidTransform& X_SL,
            const DepthPieceSize& size, SurfaceWriter& writer, DepthWorkspace& workspace)
      : first_(first),
        second_(second),
        own_is_first_(&own == &first),
        X_SL_(X_SL),
        thickness_(std::min(first.thickness(), second.thickness())),
        edge_(2 * size.min_edge * thickness_),
        least_pressure_(2 * size.tolerance *
                        std::min(first.stiffness() * first.thickness(), second.stiffness() * second.thickness())),
        writer_(writer),
        w_(workspace),
        first_polygon_(writer.polygon_count()) {}

  void run() {
    Aabb box{glm::max(first_.bounds_L().lo, second_.bounds_L().lo),
             glm::min(first_.bounds_L().hi, second_.bounds_L().hi)};
    if (box.empty() || !(box.lo.y <= box.hi.y) || !(box.lo.z <= box.hi.z)) return;
    const dvec3 extent = box.extent();
    const double longest = std::max({extent.x, extent.y, extent.z});
    while (longest > kMaxEdges * edge_) edge_ *= 2;
    w_.pressures.begin();
    w_.slopes.clear();
    if (w_.core_points.empty()) {
      int side = 1;
      while (side < kMaxEdges && side * edge_ < longest + edge_) side *= 2;
      search(Node(glm::floor(box.lo / edge_)), side);
    } else {
      follow();
    }
  }

 private:
  static constexpr int kMaxEdges = 1 << 12;  // largest number of edges along the longest side of the shared volume

  [[nodiscard]] dvec3 point(const Node& n) const { return edge_ * dvec3(n); }

  static std::uint64_t key_of(const Node& n) {
    constexpr std::uint64_t kMask = (1u << 21) - 1;
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(n.x)) & kMask) << 42 |
           (static_cast<std::uint64_t>(static_cast<std::uint32_t>(n.y)) & kMask) << 21 |
           (static_cast<std::uint64_t>(static_cast<std::uint32_t>(n.z)) & kMask);
  }

  /// Returns the pressures at a node. `near` has the pressures at a point that is `distance` away.
  PressurePair pressures(const Node& n, const PressurePair& near, double distance) {
    bool is_new = false;
    PressurePair& found = w_.pressures.at(key_of(n), is_new);
    if (is_new) {
      const dvec3 x = point(n);
      found = {first_.value_near(x, near.a, distance), second_.value_near(x, near.b, distance)};
    }
    return found;
  }
  static constexpr double kUnknown = std::numeric_limits<double>::infinity();

  /// Marches from the cubes at the rim of the tets' surface to their neighbours.
  void follow() {
    const ContactSurface& surface = writer_.surface();
    w_.boxes.clear();
    for (const ContactPolygon& polygon : surface.polygons) {
      Aabb& box = w_.boxes.emplace_back();
      for (int k = 0; k < polygon.count; ++k) box.include(surface.vertices[at(polygon.first + k)]);
    }
    w_.tree.build(w_.boxes);
    w_.visited.begin();
    w_.cubes.clear();
    w_.queue.clear();
    for (const dvec3& x_A : w_.core_points) {
      const dvec3 place = X_SL_.inverse_point(writer_.point_S(x_A)) / edge_;
      // The lattice's surface may lie in the next cube.
      const Node from(glm::floor(place - kNear)), to(glm::floor(place + kNear));
      for (int z = from.z; z <= to.z; ++z)
        for (int y = from.y; y <= to.y; ++y)
          for (int x = from.x; x <= to.x; ++x) visit({x, y, z}, kSteps);
    }
    for (std::size_t next = 0; next < w_.queue.size(); ++next) go_on(at(w_.queue[next]));
  }
  static constexpr double kNear = 0.25;      // edges
  static constexpr double kBareArea = 1e-4;  // least area that an uncovered cube adds, in edges squared
  static constexpr int kSteps = 3;           // cubes in a row that may be covered: the two surfaces differ a little

  /// Reaches a cube with `steps` steps left. A cube that was reached with fewer steps left continues once more, so that
  /// the set of reached cubes does not depend on the order.
  void visit(const Node& cube, int steps) {
    bool is_new = false;
    std::int32_t& number = w_.visited.at(key_of(cube), is_new);
    if (is_new) {
      number = static_cast<std::int32_t>(w_.cubes.size());
      w_.cubes.push_back({cube, 0, 0, false});
    }
    DepthWorkspace::Cube& found = w_.cubes[at(number)];
    if (steps <= found.steps) return;
    found.steps = steps;
    w_.queue.push_back(number);
  }

  /// Visits the neighbours of a cube. At the first visit, the cube's part of the surface is added.
  void go_on(std::size_t number) {
    DepthWorkspace::Cube cube = w_.cubes[number];
    if (!cube.is_done) {
      added_area_ = 0;
      cube.faces = march(cube.corner);
      if (added_area_ > kBareArea * edge_ * edge_) cube.steps = kSteps + 1;
      cube.is_done = true;
      w_.cubes[number] = cube;
    }
    const int steps = cube.steps - 1;
    if (steps == 0) return;
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 2; ++side) {
        if ((cube.faces >> (2 * axis + side) & 1u) == 0) continue;
        Node neighbour = cube.corner;
        neighbour[axis] += 2 * side - 1;
        visit(neighbour, steps);
      }
    }
  }

  /// Marches through the cubes in a larger cube of `side` lattice edges from `corner` on, by octree.
  void search(const Node& corner, int side) {
    const double half_diagonal = 0.5 * std::sqrt(3.0) * side * edge_;
    const dvec3 center = point(corner) + dvec3(0.5 * side * edge_);
    const PressurePair p{first_.value(center), second_.value(center)};
    const double reach_a = first_.stiffness() * half_diagonal, reach_b = second_.stiffness() * half_diagonal;
    if (p.a + reach_a < least_pressure_ || p.b + reach_b < least_pressure_) return;
    if (std::abs(p.b - p.a) > reach_a + reach_b) return;
    if (side == 1) {
      march(corner);
      return;
    }
    const int half = side / 2;
    for (int child = 0; child < 8; ++child) search(corner + half * Node(child & 1, child >> 1 & 1, child >> 2), half);
  }

  /// Lists the polygons of the tets near a cube.
  void list_near(const Node& corner) {
    w_.lists.clear();
    if (w_.core_points.empty()) return;
    const dvec3 center = writer_.point_A(X_SL_(point(corner) + dvec3(0.5 * edge_)));
    const double reach = (0.5 * std::sqrt(3.0) + 1) * edge_;
    const auto is_near = [&](const Aabb& box) {
      const dvec3 beyond = center - glm::clamp(center, box.lo, box.hi);
      return glm::dot(beyond, beyond) <= reach * reach;
    };
    w_.tree.visit(is_near, [&](std::int32_t number) {
      if (is_near(w_.boxes[at(number)])) w_.lists.push_back(number);
    });
    std::sort(w_.lists.begin(), w_.lists.end());
  }

  /// The six tets of a cube about its diagonal (Kuhn 1960): each goes from the lowest corner along the axes, in one of
  /// six orders, to the highest. Returns the faces across which the surface continues, as bits 2 axis + side.
  unsigned march(const Node& corner) {
    static constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    std::array<PressurePair, 8> pressure;
    unsigned negative = 0;
    bool any_pushes = false;
    pressure[0] = pressures(corner, {kUnknown, kUnknown}, 0);
    for (unsigned k = 0; k < 8; ++k) {
      const Node step(static_cast<int>(k & 1), static_cast<int>(k >> 1 & 1), static_cast<int>(k >> 2));
      if (k > 0) pressure[k] = pressures(corner + step, pressure[0], std::sqrt(3.0) * edge_);
      negative |= (pressure[k].b - pressure[k].a < 0 ? 1u : 0u) << k;
      any_pushes = any_pushes || std::min(pressure[k].a, pressure[k].b) >= least_pressure_;
    }
    if (negative == 0 || negative == 255 || !any_pushes) return 0;
    list_near(corner);
    for (int order = 0; order < 6; ++order) {
      std::array<Node, 4> nodes{corner, corner, corner, corner};
      std::array<unsigned, 4> number{};  // indices of the corners in the cube
      for (std::size_t k = 1; k < 4; ++k) {
        nodes[k] = nodes[k - 1];
        ++nodes[k][kOrders[order][k - 1]];
        number[k] = number[k - 1] | 1u << kOrders[order][k - 1];
      }
      std::array<PressurePair, 4> p;
      std::array<double, 4> difference;
      for (std::size_t k = 0; k < 4; ++k) {
        p[k] = pressure[number[k]];
        difference[k] = p[k].b - p[k].a;
      }
      dvec3 steepest(0), gradient(0);  // frame L
      for (std::size_t k = 0; k < 3; ++k) {
        const int axis = kOrders[order][k];
        steepest[axis] = (difference[k + 1] - difference[k]) / edge_;
        gradient[axis] = (own_is_first_ ? p[k + 1].a - p[k].a : p[k + 1].b - p[k].b) / edge_;
      }
      std::array<dvec3, 4> x;
      for (std::size_t k = 0; k < 4; ++k) x[k] = point(nodes[k]);
      ivec4 numbers(0, 1, 2, 3);  // of nodes shared by cubes, in the same order in all cubes
      if (order >= 3) {           // an odd order: the tet would be inside out
        std::swap(x[2], x[3]);
        std::swap(difference[2], difference[3]);
        std::swap(numbers[2], numbers[3]);
      }
      TetSlice slice;
      slice_tet(x, numbers, difference, slice);
      const double steepness = glm::length(steepest);
      if (slice.count == 0 || !(steepness > 0)) continue;
      const dvec3 other = own_is_first_ ? gradient + steepest : gradient - steepest;
      writer_.back_faces().note((own_is_first_ ? 1 : -1) * glm::dot(other, steepest) / steepness, other);
      add_slice(slice, steepest / steepness, gradient, (own_is_first_ ? p[0].a : p[0].b) - glm::dot(gradient, x[0]));
      w_.slopes.resize(writer_.polygon_count() - first_polygon_, steepness);
    }
    return crossed_faces(negative);
  }

  /// Returns the faces of a cube across which the surface continues, as bits 2 axis + side, from the bits of the
  /// corners with a negative difference of pressures.
  static unsigned crossed_faces(unsigned negative) {
    unsigned crossed = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      constexpr std::array<unsigned, 3> kUpper{0xAA, 0xCC, 0xF0};  // corners on the cube's upper face
      for (unsigned side = 0; side < 2; ++side) {
        const unsigned face = side != 0 ? kUpper[axis] : 0xFF & ~kUpper[axis];
        if ((negative & face) != 0 && (negative & face) != face) crossed |= 1u << (2 * axis + side);
      }
    }
    return crossed;
  }

  /// p = gradient . x + constant, frame L.
  void add_slice(const TetSlice& slice, const dvec3& normal, const dvec3& gradient, double constant) {
    // The middle, not a corner: which corner is the first depends on which body is.
    dvec3 origin(0);
    for (std::size_t k = 0; k < at(slice.count); ++k) origin += slice.points[k] / static_cast<double>(slice.count);
    const dvec3 u = edge_ * any_perpendicular(normal), v = glm::cross(normal, u);
    const dvec3 normal_S = X_SL_.R * normal, gradient_S = X_SL_.R * gradient;
    const SurfaceTriangle triangle = writer_.triangle({X_SL_(origin), X_SL_(origin + u), X_SL_(origin + v)}, normal_S);
    PlanePressure p{glm::dot(gradient, origin) + constant, glm::dot(gradient, u), glm::dot(gradient, v)};
    FlatPolygon flat;
    flat.count = slice.count;
    for (std::size_t k = 0; k < at(slice.count); ++k) {
      const dvec3 from = slice.points[k] - origin;
      flat.x[k] = dvec2(glm::dot(from, u), glm::dot(from, v)) / (edge_ * edge_);
    }
    w_.rest.clear();
    clip_by_pressure(flat, p);
    const double least = kMinPart * std::min(flat.area(), thickness_ * thickness_ / (edge_ * edge_));
    for (std::size_t n = 0; n < w_.lists.size() && !w_.rest.empty(); ++n) {
      FlatPolygon cover;
      if (project(writer_.surface().polygons[at(w_.lists[n])], triangle, cover))
        subtract(cover, least, w_.rest, w_.scratch);
    }
    for (const FlatPolygon& polygon : w_.rest) {
      writer_.add_flat(polygon, triangle, p, gradient_S, -1, edge_);
      added_area_ += 2 * triangle.area * polygon.area();
    }
  }

  /// Keeps the part that is deeper than errors of the pressures.
  void clip_by_pressure(const FlatPolygon& flat, const PlanePressure& p) {
    FlatPolygon kept;
    for (int k = 0; k < flat.count; ++k) {
      const dvec2 &here = flat.x[at(k)], &next = flat.x[at((k + 1) % flat.count)];
      const double a = p.at(here.x, here.y) - least_pressure_, b = p.at(next.x, next.y) - least_pressure_;
      if (a >= 0) kept.x[at(kept.count++)] = here;
      if ((a < 0) != (b < 0)) kept.x[at(kept.count++)] = here + a / (a - b) * (next - here);
    }
    if (kept.count >= 3) w_.rest.push_back(kept);
  }

  /// A polygon of the tets as it covers the plane of a slice, seen across it. False for one of another sheet.
  [[nodiscard]] bool project(const ContactPolygon& polygon, const SurfaceTriangle& triangle, FlatPolygon& out) const {
    constexpr double kSameSheet = 0.5;  // cosine between normals
    if (glm::dot(polygon.normal, triangle.push_A) < kSameSheet) return false;
    if (std::abs(glm::dot(triangle.push_A, polygon.centroid - triangle.origin_A)) > edge_) return false;
    const ContactSurface& surface = writer_.surface();
    out.count = std::min(polygon.count, FlatPolygon::kMaxStored);
    for (int k = 0; k < out.count; ++k) {
      const int from = writer_.reverse() ? out.count - 1 - k : k;
      const dvec3 x = surface.vertices[at(polygon.first + from)] - triangle.origin_A;
      out.x[at(k)] =
          dvec2(glm::dot(x, triangle.u_A) / triangle.metric.uu, glm::dot(x, triangle.v_A) / triangle.metric.vv);
    }
    return true;
  }

  const PressureAt &first_, &second_;
  bool own_is_first_;
  const RigidTransform& X_SL_;
  double thickness_, edge_, least_pressure_;
  SurfaceWriter& writer_;
  DepthWorkspace& w_;
  std::size_t first_polygon_;  // number of polygons before the march
  double added_area_ = 0;      // area added by the present cube [m^2]
};

}  // namespace

PressureAt::PressureAt(const DepthField* depth, const FieldIndex& field, const RigidTransform& X_BL,
                       const LawMatch* match)
    : depth_(depth), field_(&field), match_(match), X_BL_(X_BL) {
  set_bounds(field.field().bounds());
  if (depth_ != nullptr) {
    stiffness_ = depth_->stiffness() * (match_ != nullptr ? match_->steepest() : 1.0);
    thickness_ = depth_->thickness();
    return;
  }
  for (const dvec3& gradient : field.field().gradients()) stiffness_ = std::max(stiffness_, glm::length(gradient));
  thickness_ = field.field().max_pressure() / stiffness_;
}

PressureAt::PressureAt(double stiffness, double thickness, const RigidTransform& X_BL)
    : X_BL_(X_BL), stiffness_(stiffness), thickness_(thickness) {
  bounds_L_ = {dvec3(-std::numeric_limits<double>::infinity()), dvec3(std::numeric_limits<double>::infinity())};
}

void PressureAt::set_bounds(const Aabb& bounds) {
  for (int corner = 0; corner < 8; ++corner)
    bounds_L_.include(X_BL_.inverse_point({(corner & 1) != 0 ? bounds.hi.x : bounds.lo.x,
                                           (corner & 2) != 0 ? bounds.hi.y : bounds.lo.y,
                                           (corner & 4) != 0 ? bounds.hi.z : bounds.lo.z}));
}

double PressureAt::value_near(const dvec3& x_L, double near, double distance) const {
  const bool is_matched = depth_ != nullptr && match_ != nullptr;
  const double depth = is_matched ? std::abs(match_->inverse(near)) / depth_->stiffness() : std::abs(near) / stiffness_;
  return value(x_L, (depth + distance) * (1 + 1e-9));
}

double PressureAt::value(const dvec3& x_L, double within) const {
  const dvec3 x = X_BL_(x_L);
  if (depth_ != nullptr) {
    const double linear = depth_->stiffness() * depth_->at(x, within).depth;
    return match_ != nullptr ? (*match_)(linear) : linear;
  }
  return field_ != nullptr ? value_in_tets(x) : -stiffness_ * x.z;
}

/// Returns the pressure by a traversal from the tet of the point's cell. Outside of the tets, the pressure of the last
/// tet is extrapolated; it is negative there.
double PressureAt::value_in_tets(const dvec3& x) const {
  constexpr int kMaxTraversalSteps = 256;
  const DistanceGrid::Cell& cell = field_->grid().cell_of(x);
  if (cell.tet < 0) return -stiffness_ * static_cast<double>(cell.distance);
  std::int32_t tet = cell.tet;
  for (int step = 0;; ++step) {
    const PackedTet& t = field_->tets()[at(tet)];
    std::size_t least = 0;
    std::array<double, 4> distance;
    for (std::size_t i = 0; i < 4; ++i) {
      distance[i] = t.nx[i] * x.x + t.ny[i] * x.y + t.nz[i] * x.z + t.offset[i];
      if (distance[i] < distance[least]) least = i;
    }
    if (!(distance[least] < 0)) return glm::dot(t.pressure().gradient, x) + t.pressure().constant;
    if (t.neighbour[least] < 0 || step == kMaxTraversalSteps)
      return std::min(glm::dot(t.pressure().gradient, x) + t.pressure().constant, 0.0);
    tet = t.neighbour[least];
  }
}

RigidTransform frame_between(const Pose& X_AB) {
  const dquat turn = X_AB.q.w < 0 ? -X_AB.q : X_AB.q;
  return RigidTransform(Pose{glm::normalize(dquat(1, 0, 0, 0) + turn), 0.5 * X_AB.p});
}

bool reaches_core(const FieldIndex& a, const FieldIndex& b, const RigidTransform& X_AB) {
  const auto in_core = [](const FieldIndex& field, const dvec3& x) {
    const Aabb& box = field.field().bounds();
    if (glm::any(glm::lessThan(x, box.lo)) || glm::any(glm::greaterThan(x, box.hi))) return false;
    const DistanceGrid::Cell& cell = field.grid().cell_of(x);
    return cell.tet == DistanceGrid::kCoreCell;
  };
  return (a.goes_on() && in_core(a, X_AB(b.field().vertices().front()))) ||
         (b.goes_on() && in_core(b, X_AB.inverse_point(a.field().vertices().front())));
}

void add_march(const PressureAt& first, const PressureAt& second, const PressureAt& own, const RigidTransform& X_SL,
               const DepthPieceSize& size, SurfaceWriter& writer, DepthWorkspace& workspace) {
  PairMarch(first, second, own, X_SL, size, writer, workspace).run();
}

}  // namespace taxel
