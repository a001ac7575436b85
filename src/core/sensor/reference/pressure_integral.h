// The means weighted_mean and mean as integrals over the contact polygons: the limit of the samples' reading.
//
//   reading = int w p dA / int w dA over the sampled part of the taxel's field
//
// From each point of the skin a ray starts against the normal of its face, and p is the pressure where it first meets a
// contact surface. So a polygon adds its part inside of each face's prism of rays (skin_fields.h), projected to the
// face, on which p is linear. docs/theory/sensor.md has the details.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/reference/skin_fields.h"
#include "core/sensor/surface_motion.h"

namespace taxel {

/// The integrals over the fields, in layout order.
struct PressureSums {
  std::vector<double> pressure;  ///< integral of w p dA [N m^2], or of p dA for `mean` [N]
  std::vector<double> hit;       ///< integral of w over the part whose rays meet a surface [m^4], or its area [m^2]
  std::vector<dvec3> friction;   ///< integral of w t dA, t of SurfaceMotion::friction(); zero without motions
  long points = 0;               ///< number of points at which weights were computed
};

/// Computes the integrals. The memory is reused, so that no step allocates after the largest surface.
class PressureIntegral {
 public:
  /// Integrates over surfaces in frame M; null ones are empty. `motions` is empty or has one motion per surface.
  /// `fields` has prisms. With `weighted` w is the weight of the field, otherwise 1 inside of the field.
  void integrate(const SkinFields& fields, int taxels, bool weighted, std::span<const ContactSurface* const> surfaces,
                 std::span<const SurfaceMotion> motions, PressureSums& out);

  /// Returns the integral of w over the sampled part of each taxel's field.
  static std::vector<double> of_whole_fields(const SkinFields& fields, int taxels, bool weighted);

 private:
  /// The part of a polygon inside of a prism, in the plane of the face.
  struct Piece {
    std::uint32_t first = 0, end = 0;  ///< corners in corners_
    std::int32_t prism = 0;
    std::int32_t next = -1;  ///< another piece of the prism, or -1
    int surface = 0;
    const ContactPolygon* polygon = nullptr;
    dvec3 pressure{0};  ///< p = [0] + [1] u + [2] v [Pa]
    dvec3 depth{0};     ///< depth below the face, in the same way [m]
  };
  /// The pieces of one prism in this step.
  struct OfPrism {
    std::int32_t last = -1;  ///< its last piece, or -1
    std::int32_t kind = -1;  ///< surface and side of its pieces
    bool mixed = false;      ///< true if not all pieces are of one kind
  };

  void add_polygon(int surface, const ContactPolygon& polygon);
  void add_piece(int surface, const ContactPolygon& polygon, double radius, std::int32_t prism);
  bool cut(const FaceLine& line);
  void integrate(const Piece& piece);
  void subtract_hidden(const Piece& piece);
  void integrate_part(const Piece& piece, std::span<const dvec2> corners, double sign);
  void integrate_disc_parts(const Piece& piece, std::span<const dvec2> corners, double sign);
  void integrate_points(const Piece& piece, std::span<const dvec2> corners, double sign);
  void integrate_triangle(const Piece& piece, const std::array<dvec2, 3>& corners, double area, double largest);
  void add_point(const Piece& piece, const dvec2& q, double area);
  void add(std::size_t taxel, double weight, double pressure, const dvec3& friction);

  const SkinFields* fields_ = nullptr;
  PressureSums* out_ = nullptr;
  std::span<const ContactSurface* const> surfaces_;
  std::span<const SurfaceMotion> motions_;
  bool weighted_ = true;
  std::vector<Piece> pieces_;
  std::vector<dvec2> corners_;      // of the pieces
  std::vector<dvec2> part_, next_;  // the part that is being cut
  std::vector<double> values_;
  std::vector<OfPrism> of_prisms_;  // as long as the prisms; only those of touched_ are not empty
  std::vector<std::int32_t> touched_, near_;
  FaceFields::AtPoint at_;
};

}  // namespace taxel
