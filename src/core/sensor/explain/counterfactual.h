// Contact surfaces under another pressure field of the sensor. They show whether a change comes from the contact or
// from the field.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Surfaces of one contact, in the order of the original ones.
struct OtherSurfaces {
  std::vector<ContactSurface> surfaces;
  std::vector<const ContactSurface*> pointers;  ///< pointers to `surfaces`; null for null originals
};

/// The inverted tets of a sensor's field. An inverted tet is on the outer side of its skin face, and the pressure below
/// that face is the pressure of other tets that reach across.
class InvertedTets {
 public:
  InvertedTets() = default;
  explicit InvertedTets(const SensorModel& model);
  /// Returns true if a polygon (frame M) is in an inverted tet, or below the face of one.
  [[nodiscard]] bool concern(const ContactPolygon& polygon) const;

 private:
  std::shared_ptr<const MeshIndex> skin_;
  std::vector<bool> tets_, faces_;  // empty if no tet is inverted
};

/// Returns true if the field may cause a change of a reading: a star, or a field with inverted tets.
bool field_is_suspect(const SensorModel& model);

/// Returns true if both bodies of a contact are soft, so that the surface depends on the field: if polygons have tets
/// of both bodies, or if they are on no face of a rigid mesh and not in one plane.
bool between_soft_bodies(const ContactSurface& surface);

/// Returns the polygons under a field of uniform stiffness: p = k depth with the depth below the skin and the mean
/// stiffness k of the sensor's own field. The depth is at most the thickness of a pad whose field ends with its tets.
/// Depth and gradient are evaluated at the centroid of each polygon, without tets. Valid if the other bodies are rigid:
/// then the place of the surfaces does not depend on the field.
OtherSurfaces with_even_stiffness(const SensorModel& model, std::span<const ContactSurface* const> surfaces);

}  // namespace taxel
