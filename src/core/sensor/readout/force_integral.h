// Aggregate::force: what each taxel carries of the contact, integrated over the contact polygons instead of sampled.
//
// F_k = integral of phi_k p0 dA, phi_k = w_k / (sum over j of w_j), 0 where no taxel reaches. The weights of a point x
// of a polygon are those of the skin's point s(x) nearest to x: of the rays that reach x against the normal of the face
// where they start, that one's is the shortest; on an edge or a corner the direction from x to s(x) is the skin's
// normal. Deeper than SensorModel::max_depth no ray reaches. For a rigid sensor the surface lies in the skin, and
// s(x) = x. docs/theory.md has the whole of it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/layout/field/field_weights.h"
#include "core/sensor/surface_motion.h"

namespace taxel {

struct SensorModel;

/// Frame M. Taxels in layout order.
struct ForceReading {
  std::vector<double> values;   ///< integral of phi_k p0 dA [N]
  std::vector<dvec3> normal;    ///< integral of phi_k p0 n dA, n as ContactPolygon::normal [N]
  std::vector<dvec3> friction;  ///< integral of phi_k t dA, t of friction_traction(); zero without motions [N]
  double covered = 0;           ///< integral of p0 dA where a taxel reaches: the sum of `values` [N]
  double uncovered = 0;         ///< the same where none does: what no taxel feels [N]
  dvec3 uncovered_normal{0};    ///< integral of p0 n dA there; with the sum of `normal` the surfaces' elastic force [N]
  long evaluations = 0;         ///< points at which weights were asked for: what it cost
};

/// Integrates; kept between steps, so that none takes memory once the largest surface was seen.
class ForceIntegral {
 public:
  /// The error that is aimed at: the taxels' sum equals the covered integral to this part of it, or of a thousandth of
  /// the surfaces' whole force where less is covered.
  static constexpr double kAccuracy = 1e-3;

  /// Surfaces in frame M, null ones hold nothing. `motions`: empty, or parallel to them.
  void integrate(const SensorModel& model, const FieldWeights& weights, std::span<const ContactSurface* const> surfaces,
                 std::span<const SurfaceMotion> motions, ForceReading& out);

 private:
  /// A part of a fanned polygon.
  struct Triangle {
    std::array<dvec3, 3> corners;
    double area = 0;  ///< scaled, so that a polygon's triangles have its force [m^2]
    int level = 0;    ///< halved so often
    [[nodiscard]] Triangle child(int number) const;
  };
  /// The polygon that is worked on.
  struct Polygon {
    const ContactSurface* surface = nullptr;
    const ContactPolygon* polygon = nullptr;
    const SurfaceMotion* motion = nullptr;
    std::uint32_t first_disc = 0, end_disc = 0;  ///< in discs_
    [[nodiscard]] double pressure(const dvec3& x) const;
  };
  /// A point of a rule, its weight there and in the rule that it is compared with.
  struct Node {
    dvec3 x{0};
    double weight = 0, coarse = 0;
  };
  struct Share {
    int taxel = 0;
    double value = 0, coarse = 0;  ///< by the rule, and by the one it is compared with [N]
    dvec3 friction{0};             ///< [N]
  };
  /// The integrals over a triangle, as shares_ [first, end).
  struct Estimate {
    std::uint32_t first = 0, end = 0;
    double covered = 0, whole = 0, error = 0;  ///< [N]
  };
  struct Leaf {
    Triangle triangle;
    std::uint32_t polygon = 0;
    bool whole = false;  ///< the polygon itself instead of a triangle of it
    Estimate estimate;
  };

  void add_polygon(const ContactSurface& surface, const ContactPolygon& polygon, const SurfaceMotion* motion);
  void add_leaves(const Triangle& triangle, double largest_edge);
  template <class F>
  bool for_each_part(const Polygon& polygon, const F& f);
  void evaluate(const Polygon& polygon, const dvec3& x);
  Estimate estimate(const Polygon& polygon, std::span<const Node> nodes, double area, double radius);
  Estimate estimate(const Polygon& polygon, const Triangle& triangle);
  Estimate cut(const Polygon& polygon, const Triangle& triangle);
  Estimate cut_at(const Polygon& polygon, const Triangle& triangle, int lone, bool lone_covered,
                  const std::array<double, 3>& margins);
  std::optional<dvec3> edge_of_cover(const Polygon& polygon, dvec3 inside, double inner, dvec3 outside, double outer);
  void share_out(const Polygon& polygon, const std::array<dvec3, 3>& corners, double area, Estimate& e, double& pushed);
  [[nodiscard]] bool covered() const;
  Estimate estimate_whole(const Polygon& polygon, double radius);
  Share& share_of(std::uint32_t first, int taxel);
  void settle(const Leaf& leaf, double tolerance);
  void settle(const Polygon& polygon, const Triangle& triangle, double tolerance);
  void refine(const Polygon& polygon, const Triangle& triangle, double tolerance);
  void take(const Polygon& polygon, const Estimate& estimate);

  const SensorModel* model_ = nullptr;
  const FieldWeights* weights_ = nullptr;
  ForceReading* out_ = nullptr;
  std::vector<Polygon> polygons_;
  std::vector<int> discs_, near_;
  std::vector<Leaf> leaves_;
  std::vector<Share> shares_;
  FieldWeights::AtPoint at_;
  int face_ = -1;  // of the skin, where the last point was: the next one is near
};

}  // namespace taxel
