// Values and fields that several scenario kinds share.
#pragma once

#include <span>
#include <string_view>

#include "core/base/text/field_spec.h"
#include "core/base/text/words.h"

namespace taxel {

/// Object that the finger touches. The edge that a sweep crosses is the line x = 0 on top of the object. The bounds of
/// the object begin at z = 0, and their middle is at y = 0. The bounds of a mesh and of all shapes except `edge` begin
/// at x = 0.
enum class ObjectShape {
  edge,   ///< a box of `box_size` balanced on an edge; the rounded edge is on top
  box,    ///< a cube with edges of length `box_size`
  plate,  ///< a square plate with sides of length `box_size`, a tenth as thick
  sphere  ///< a sphere of diameter `box_size`
};
inline constexpr Word<ObjectShape> kObjectShapeWords[] = {{ObjectShape::edge, "edge"},
                                                          {ObjectShape::box, "box"},
                                                          {ObjectShape::plate, "plate"},
                                                          {ObjectShape::sphere, "sphere"}};
inline std::span<const Word<ObjectShape>> words_of(ObjectShape) {
  return kObjectShapeWords;
}

namespace scenarios {

/// Properties of a scenario kind. Every kind derives from these defaults and redefines the ones that differ. A kind
/// also has `kWord`, its name in files, and `visit(self, v)`, which calls v(FieldSpec, value&) for each field in the
/// order of the inspector; visit_rows() does the same for the field that decides when a row is recorded.
struct KindTraits {
  static constexpr bool kHasObject = true;                 ///< true if the user chooses the object
  static constexpr bool kHasTimestep = true;               ///< false if a recording sets the time step
  static constexpr bool kHasPoses = false;                 ///< true for poses that fit one object only
  static constexpr ObjectShape kShape = ObjectShape::box;  ///< shape of the default object

  /// Throws Error("", "/key", ...) if the values of the kind contradict each other.
  void check(ObjectShape) const {}
  /// Adapts defaults that depend on the shape of the object.
  void follow_shape(ObjectShape /*from*/, ObjectShape /*to*/) {}
  bool operator==(const KindTraits&) const = default;
};

inline constexpr FieldSpec kDepth{"depth", "Depth", "Indentation depth below first contact with the object's top",
                                  FieldQuantity::length, FieldRange::positive};
inline constexpr FieldSpec kSpeed{"speed", "Path speed", "Along straight ways", FieldQuantity::speed,
                                  FieldRange::positive};
inline constexpr FieldSpec kTilt{"tilt_deg", "Tilt", "Of the finger's distal axis below the horizontal",
                                 FieldQuantity::angle};
inline constexpr FieldSpec kPlace{"place", "Place", "Lowest point of the finger, from the object's middle along x",
                                  FieldQuantity::length};
inline constexpr FieldSpec kAngle{"angle_deg", "Angle", "Through which it turns, and back; it rolls towards +x",
                                  FieldQuantity::angle};
inline constexpr FieldSpec kRate{"rate_deg", "Rate", "At which it turns", FieldQuantity::angular_speed,
                                 FieldRange::positive};

/// A kind that records a row at even times.
struct Timed : KindTraits {
  double record_interval = 0.010;  ///< time between two rows [s]

  template <class Self, class V>
  static void visit_rows(Self& self, const V& v) {
    v(FieldSpec{"record_interval", "Row every", "In plots and recordings", FieldQuantity::interval,
                FieldRange::positive},
      self.record_interval);
  }
  bool operator==(const Timed&) const = default;
};

}  // namespace scenarios
}  // namespace taxel
