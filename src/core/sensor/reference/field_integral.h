// The limit of a taxel's reading for ever more samples, by adaptive quadrature on the skin. The sums over samples
// become integrals over the skin, and from each point of the skin starts a ray, as one starts from each sample.
//
//   weighted_mean   int w p dA / int w dA       (if misses are omitted: both over the part that is hit)
//   weighted_sum    N/A int w p dA              N samples on the sampled area A
//   mean            int p dA / int dA           over the field
//   nearest, max    p at the point nearest to the centre, the largest p of the field
//
// p is the pressure where the ray first intersects a contact surface, and 0 if the ray misses. The integrals run over
// the sampled faces, which are those of layout.sampling.region if a region is painted.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/hydro/quadrature.h"
#include "core/layout/field/receptive_field.h"
#include "core/sensor/rays/surface_caster.h"
#include "core/sensor/reference/exact_value.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// The rays of one taxel in one contact. The model and the surfaces must outlive this object.
class FieldRays {
 public:
  /// Rays start against the `normals` of the skin, unless all have the direction of the taxel's normal.
  FieldRays(const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces,
            FieldNormals normals = FieldNormals::face);

  /// Returns the first hit of the ray from a point of a face of the sensed skin, within its allowed depth.
  [[nodiscard]] RayHit cast(int face, const dvec3& point) const;
  /// Returns the weight of a point, 0 outside of the field [m^2].
  [[nodiscard]] double weight(int face, const dvec3& point);
  /// Returns true if the point of the last weight() is in the field. Its weight may be 0.
  [[nodiscard]] bool inside() const { return !at_.weights.empty(); }

  /// A point of the skin.
  struct Start {
    int face = -1;
    dvec3 point{0};
  };
  /// Returns the sampled skin's point nearest to p, if it is in the field.
  [[nodiscard]] std::optional<Start> nearest_start(const dvec3& p) const;

  /// A face of the sampled skin that the field may reach.
  struct Face {
    int face = -1;
    std::array<dvec3, 3> corners;
    double area = 0;
  };
  [[nodiscard]] std::vector<Face> faces() const;
  /// Returns false only if the field surely does not intersect the ball, by Euclidean distances.
  [[nodiscard]] bool reaches(const dvec3& center, double radius) const;
  /// Returns false only if rays from a triangle of that face surely miss all surfaces.
  [[nodiscard]] bool may_hit(int face, const std::array<dvec3, 3>& corners) const;

  [[nodiscard]] double smallest_radius() const { return smallest_radius_; }
  [[nodiscard]] double smallest_contact() const { return smallest_contact_; }  ///< diagonal of a surface's box [m]
  [[nodiscard]] bool omit_misses() const { return model_.layout.readout.misses == Misses::omit; }
  [[nodiscard]] const SensorModel& model() const { return model_; }

 private:
  [[nodiscard]] dvec3 direction(int face, const dvec3& point) const;

  const SensorModel& model_;
  const Taxel& taxel_;
  FieldNormals normals_;
  SensorSkin skin_;
  std::vector<FieldDisc> discs_;
  FieldWeights weights_;  // of this taxel only
  std::vector<int> disc_numbers_;
  FieldWeights::AtPoint at_;
  SurfaceCaster caster_;
  std::vector<Aabb> boxes_;
  double smallest_radius_ = 0, smallest_contact_ = 0;
};

/// The integrals that make a reading: value = int c p dA, whole = int c dA.
struct FieldTerms {
  bool weighted = true;  ///< c is the weight of the field, otherwise 1
  bool divided = true;   ///< the reading is value / whole, otherwise value times the samples per area
};

/// The exact reading of one taxel. Each object computes one reading.
class FieldIntegral {
 public:
  /// `accuracy` is the largest error as a fraction of the reading.
  FieldIntegral(FieldRays rays, double accuracy, FieldTerms terms = {});
  /// Returns the reading by integrals.
  ExactReading read();
  /// Returns the largest pressure of the field.
  ExactReading read_largest();

 private:
  static constexpr std::size_t kNodes = kTriangleDegree5.size();
  struct Triangle {
    int face = -1;
    std::array<dvec3, 3> corners;
    double area = 0;
    int level = 0;  ///< number of times a face was quartered
  };
  /// The integrals by the rule of degree 5, and by the coarse rule of degree 2.
  struct Sums {
    double value = 0, whole = 0, coarse_value = 0, coarse_whole = 0;
  };
  struct Leaf {
    Triangle triangle;
    Sums sums;
    double largest = 0, least = 0;       ///< pressures at the nodes inside the field [Pa]
    double hidden = 0;                   ///< largest error of sums.value between nodes and corners
    std::array<double, kNodes> parts{};  ///< parts of sums.value by node
    std::array<RayHit, kNodes> hits;
  };

  void add_faces();
  void add(const Triangle& triangle);
  [[nodiscard]] Leaf measure(const Triangle& triangle);
  [[nodiscard]] double hidden_in(const Leaf& leaf);
  void refine(std::size_t leaf);
  [[nodiscard]] double error_of(const Leaf& leaf) const;
  void add_sums(const Leaf& leaf, double sign);
  [[nodiscard]] std::vector<PolygonPart> parts(double scale) const;

  FieldRays rays_;
  double accuracy_;
  FieldTerms terms_;
  std::vector<Leaf> leaves_;
  Sums sum_;
  double error_ = 0;
  long cast_ = 0;
};

}  // namespace taxel
