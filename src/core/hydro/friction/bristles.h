// Friction that sticks: the skin touches through bristles, each of which bends elastically and slips at the Coulomb
// limit.
//
//        B   ____________________  touched body
//              /  /  /  /             tips stick to B while k |u| < mu p
//        A   _/__/__/__/_________  skin: the roots are material points of A
//             |u|
//
// Each point of the contact has a deflection u, the tangential displacement of A relative to B since the point stuck,
// and the traction t = -k u, limited to mu p: the brush model, an array of the elastic-perfectly plastic elements of
// Jenkins (1962). Since the elements are independent, the law is that of elastic-plastic friction (Dupont, Hayward,
// Armstrong, Altpeter 2002) without its transition, at every point. A contact of many bristles slips first where the
// pressure is low, as that of Cattaneo (1938) and Mindlin (1949).
#pragma once

#include <vector>

#include "core/hydro/friction/bristle_skin.h"
#include "core/hydro/traction.h"

namespace taxel {

/// Time constant of the damping of a bristle [s]: its force is k (u + kBristleTime du/dt), below the Coulomb limit. A
/// body that is held by bristles comes to rest also in time steps that are much shorter than its period.
inline constexpr double kBristleTime = 1e-3;

/// The law of the bristles of one pair, in a step of `timestep` seconds.
struct BristleLaw {
  double stiffness = 0;  ///< k, tangential stiffness per area [Pa/m]
  PairProperties pair;   ///< mu limits the bristles; d limits them to mu p0 (1 - d vn)+
  double timestep = 0;   ///< h [s]; 0 if the deflection is that of the present pose
  double time = 0;       ///< time constant of the damping, kBristleTime in the simulation [s]
};

/// The bristles about one root in one contact, frame A.
struct Bristle {
  int root = 0;
  double area = 0;  ///< area of contact that the root bears [m^2]
  double push = 0;  ///< integral of p0 over this area [N]
  dvec3 normal{0};  ///< unit normal that pushes A
  dvec3 x{0};       ///< the root, moved along the normal into the contact surface [m]
  dvec3 u{0};       ///< deflection at the present pose [m]
};

/// Force of one bristle and its state after the step.
struct BristleAnswer {
  dvec3 force{0};      ///< friction on A [N]
  dvec3 u{0};          ///< deflection at the present pose less the slip of the step [m]
  bool slips = false;  ///< the Coulomb limit is reached
};
BristleAnswer answer_of(const Bristle& bristle, const BristleLaw& law, const Twist& V_BA);

/// The bristles of one contact.
class BristleContact {
 public:
  /// Replaces the bristles by those that bear a surface, without deflection. Areas and pushes add up to the area and
  /// the pressure force of the surface. Reuses the memory.
  void assign(const ContactSurface& surface, BristleSearch& search);

  [[nodiscard]] std::vector<Bristle>& bristles() { return bristles_; }
  [[nodiscard]] const std::vector<Bristle>& bristles() const { return bristles_; }

  /// Adds the friction to a traction without friction: with the deflection u + (h + T) vt at the end of the step and
  /// beta = min(k area, mu push (1 - d vn)+ / |u + (h + T) vt|), the force of a bristle is -beta u - beta (h + T) vt.
  /// The first part is added to `elastic` and the second to the secant, which stays symmetric and positive
  /// semi-definite.
  void add_friction(const BristleLaw& law, const Twist& V_BA, Traction& sum) const;

 private:
  void add(const dvec3& x, double area, double push, const dvec3& normal, BristleSearch& search);

  std::vector<Bristle> bristles_;
  std::vector<int> place_;  // index in bristles_ of each root, or -1
};

}  // namespace taxel
