// Integrals over the receptive field of one taxel by adaptive quadrature on the skin.
#pragma once

#include "core/hydro/quadrature.h"
#include "core/sensor/explain/exact_value.h"
#include "core/sensor/explain/field_rays.h"

namespace taxel {

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
