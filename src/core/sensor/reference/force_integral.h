// Aggregate::force: the force of the contact on each taxel, integrated over the contact polygons instead of sampled.
//
// F_k = integral of phi_k p0 dA, phi_k = cover w_k / (sum over j of w_j), and 0 outside of all fields. `cover` is 1, or
// less where all fields end in a roll-off of the angle. The weights at a point x of a polygon are the weights at s(x),
// the skin's point nearest to x. Of all rays that reach x against the normal of the face where they start, the ray from
// s(x) is the shortest. On an edge or a corner, the direction from x to s(x) takes the place of the skin's normal. No
// ray reaches deeper than SensorModel::max_depth. The contact surface of a rigid sensor is in its skin, so s(x) = x.
// docs/theory/sensor.md has the details.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/reference/skin_fields.h"
#include "core/sensor/surface_motion.h"

namespace taxel {

struct SensorModel;

/// The forces on the taxels, in frame M and layout order.
struct ForceReading {
  std::vector<double> values;   ///< integral of phi_k p0 dA [N]
  std::vector<dvec3> normal;    ///< integral of phi_k p0 n dA, n as ContactPolygon::normal [N]
  std::vector<dvec3> friction;  ///< integral of phi_k t dA, t of SurfaceMotion::friction(); zero without motions [N]
  double covered = 0;           ///< integral of p0 dA in all fields, the sum of `values` [N]
  double uncovered = 0;         ///< integral of p0 dA outside of all fields [N]
  /// Integral of p0 n dA outside of all fields. Added to the sum of `normal`, the elastic force of the surfaces [N].
  dvec3 uncovered_normal{0};
  long evaluations = 0;  ///< number of points at which weights were computed
};

/// Computes the integrals. The memory is reused, so that no step allocates after the largest surface.
class ForceIntegral {
 public:
  /// Target error of the sum over the taxels, as a fraction of the covered integral, or of a thousandth of the whole
  /// force of the surfaces if less is covered.
  static constexpr double kAccuracy = 1e-3;

  /// Integrates over surfaces in frame M; null ones are empty. `motions` is empty or has one motion per surface.
  void integrate(const SensorModel& model, const SkinFields& fields, std::span<const ContactSurface* const> surfaces,
                 std::span<const SurfaceMotion> motions, ForceReading& out);

 private:
  /// A part of a triangle of a polygon.
  struct Triangle {
    std::array<dvec3, 3> corners;
    double area = 0;  ///< scaled so that the triangles have the polygon's force [m^2]
    int level = 0;    ///< number of times it was quartered
    [[nodiscard]] Triangle child(int number) const;
  };
  /// A polygon with the values that its integral needs.
  struct Polygon {
    const ContactSurface* surface = nullptr;
    const ContactPolygon* polygon = nullptr;
    const SurfaceMotion* motion = nullptr;
    double radius = 0;  ///< largest distance of a corner from the centroid [m]
    [[nodiscard]] double pressure(const dvec3& x) const;
  };
  /// A point of a quadrature rule with its weights in the rule and in the coarse rule.
  struct Node {
    dvec3 x{0};
    double weight = 0, coarse = 0;
  };
  /// The part of a triangle's force on one taxel.
  struct Share {
    int taxel = 0;
    double value = 0, coarse = 0;  ///< by the rule and by the coarse rule [N]
    dvec3 friction{0};             ///< friction force [N]
  };
  /// The integrals over a triangle. Its shares are shares_ [first, end).
  struct Estimate {
    std::uint32_t first = 0, end = 0;
    double covered = 0, whole = 0, error = 0;  ///< forces [N]
  };
  struct Leaf {
    Triangle triangle;
    std::uint32_t polygon = 0;
    bool whole = false;  ///< true for a whole polygon instead of a triangle
    Estimate estimate;
  };

  void add_polygon(const ContactSurface& surface, const ContactPolygon& polygon, const SurfaceMotion* motion);
  void add_leaves(const Triangle& triangle, double largest_edge);
  template <class F>
  bool for_each_part(const Polygon& polygon, const F& f);
  void evaluate(const Polygon& polygon, const dvec3& x);
  [[nodiscard]] std::span<const int> discs_near(const ContactPolygon& polygon, double radius);
  void set_weights(int face, const dvec3& on_skin);
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
  const SkinFields* fields_ = nullptr;
  ForceReading* out_ = nullptr;
  std::vector<Polygon> polygons_;
  std::vector<int> near_;  // discs near the polygon near_of_
  const ContactPolygon* near_of_ = nullptr;
  std::vector<Leaf> leaves_;
  std::vector<Share> shares_;
  FieldWeights::AtPoint at_;
  FaceFields::AtPoint of_face_;
  int face_ = -1;                 // face of the skin at the last point, a guess for the next point
  std::vector<int> face_of_tet_;  // face of the skin at the last polygon of each tet, or -1
};

}  // namespace taxel
