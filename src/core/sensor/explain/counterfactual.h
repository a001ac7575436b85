// Contact surfaces as they would be with another pressure field of the sensor: what tells whether a change belongs to
// the contact or to the field.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Surfaces of one contact, parallel to those that they were made of.
struct OtherSurfaces {
  std::vector<ContactSurface> surfaces;
  std::vector<const ContactSurface*> pointers;  ///< to them; null where those were null
};

/// Where tets of a sensor's field are inside out: they lie on the outer side of the skin face that they belong to, and
/// the pressure below that face is that of other tets which reach across.
class InvertedTets {
 public:
  InvertedTets() = default;
  explicit InvertedTets(const SensorModel& model);
  /// Whether a polygon of the sensor's surfaces lies in one, or below a face of one. Frame M.
  [[nodiscard]] bool concern(const ContactPolygon& polygon) const;

 private:
  std::shared_ptr<const MeshIndex> skin_;
  std::vector<bool> tets_, faces_;  // empty where none is inverted
};

/// Whether the sensor's field may change a reading by itself: a star, or one with inverted tets.
bool field_is_suspect(const SensorModel& model);

/// Whether both bodies of a contact are soft: the surface then moves with the field. True for polygons with tets of
/// both, and for those on no face of a rigid mesh that do not lie in one plane.
bool between_soft_bodies(const ContactSurface& surface);

/// The same polygons under a field of the same stiffness everywhere: p = k depth, the depth below the skin, k the
/// mean stiffness of the sensor's own field; no deeper than the thickness of a pad whose field ends with its tets. Of
/// each polygon depth and gradient at its centroid. No tets are involved. Holds where the other bodies are rigid, whose
/// surfaces lie where they do whatever the field is.
OtherSurfaces with_even_stiffness(const SensorModel& model, std::span<const ContactSurface* const> surfaces);

}  // namespace taxel
