// Integrals over the receptive field of one taxel: adaptive quadrature on the skin.
#pragma once

#include "core/hydro/quadrature.h"
#include "core/sensor/explain/exact_reading.h"
#include "core/sensor/explain/field_rays.h"

namespace taxel {

/// For weighted_mean, weighted_sum, mean and max.
class FieldIntegral {
 public:
  /// To an error of `accuracy` of the reading.
  FieldIntegral(FieldRays rays, double accuracy);
  /// The reading, once.
  ExactReading read();

 private:
  static constexpr std::size_t kNodes = kTriangleDegree5.size();
  struct Triangle {
    int face = -1;
    std::array<dvec3, 3> corners;
    double area = 0;
    int level = 0;  ///< halved so often
  };
  /// The integrals of value and of what it is divided by, by the rule and by the one it is compared with.
  struct Sums {
    double value = 0, whole = 0, coarse_value = 0, coarse_whole = 0;
  };
  struct Leaf {
    Triangle triangle;
    Sums sums;
    double largest = 0, least = 0;       ///< pressure among the nodes inside the field [Pa]
    double hidden = 0;                   ///< of sums.value, what may lie between the nodes and the corners
    std::array<double, kNodes> parts{};  ///< of sums.value, by node
    std::array<RayHit, kNodes> hits;
  };

  void add(const Triangle& triangle);
  [[nodiscard]] Leaf measure(const Triangle& triangle);
  [[nodiscard]] double hidden_in(const Leaf& leaf);
  void refine(std::size_t leaf);
  [[nodiscard]] double error_of(const Leaf& leaf) const;
  void take_sums(const Leaf& leaf, double sign);
  ExactReading read_largest();
  [[nodiscard]] std::vector<PolygonPart> parts(double scale) const;

  FieldRays rays_;
  double accuracy_;
  Aggregate how_;
  double scale_ = 1;  // samples per area where sums count them
  std::vector<Leaf> leaves_;
  Sums sum_;
  double error_ = 0;
  long cast_ = 0;
};

}  // namespace taxel
