// The rays of one taxel from any point of the skin: the rays that samples at these points would have.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/layout/field/field_weights.h"
#include "core/sensor/rays/cast_rays.h"

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

}  // namespace taxel
