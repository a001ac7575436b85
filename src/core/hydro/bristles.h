// Friction that sticks: the skin touches through bristles, each of which bends elastically and slips at the Coulomb
// limit. Here are the points of a soft body's skin that carry bristles (roots), the shares of a contact that each of
// them bears, the law of a bristle, and the friction of one contact as a field of traction.
#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/traction.h"

namespace taxel {

/// Roots of bristles: material points spread evenly over the skin of a pressure field. Immutable.
class BristleSkin {
 public:
  /// Spreads `count` roots by farthest-point sampling (Gonzalez 1985). The roots are equal for equal fields. Throws
  /// Error if the field has no skin or `count` is below 1.
  BristleSkin(const PressureField& field, int count);

  [[nodiscard]] const std::vector<dvec3>& roots() const { return roots_; }  ///< frame of the field [m]
  /// Distance within which each point of the skin has a root [m].
  [[nodiscard]] double spacing() const { return spacing_; }
  /// Length s of the shares, see BristleSearch::shares() [m]. With a shorter one they would follow the pressure better,
  /// and with a longer one they would change more slowly where a contact slides.
  [[nodiscard]] double reach() const { return std::sqrt(0.4) * spacing_; }

 private:
  std::vector<dvec3> roots_;
  double spacing_ = 0;
};
using BristleSkinPtr = std::shared_ptr<const BristleSkin>;

/// Part of a point's load that a root bears.
struct BristleShare {
  int root = 0;
  double part = 0;
};

/// Returns the share of a root at a distance d_i from a point, before division by the sum: (1 - (d_i^2 - d^2)/s^2)^2
/// where the bracket is positive, with the least distance d of a root and s = BristleSkin::reach(). It is continuous in
/// the place of the point.
inline double share_of(double squared_distance, double least_squared_distance, double reach) {
  const double bracket = 1 - (squared_distance - least_squared_distance) / (reach * reach);
  return bracket > 0 ? bracket * bracket : 0;
}

/// Finds the roots near points of contact surfaces. Memory that only speeds up a step: the results do not depend on
/// earlier calls.
class BristleSearch {
 public:
  explicit BristleSearch(BristleSkinPtr skin) : skin_(std::move(skin)) {}

  [[nodiscard]] const BristleSkin& skin() const { return *skin_; }
  [[nodiscard]] const BristleSkinPtr& skin_pointer() const { return skin_; }
  /// Returns the shares of a point x, which add up to 1, by share_of(). On flat skin they do not depend on the depth of
  /// x. Valid until the next call.
  std::span<const BristleShare> shares(const dvec3& x);

 private:
  [[nodiscard]] const std::vector<int>& candidates(const dvec3& x);

  BristleSkinPtr skin_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;  // roots that may have a share at a point of the cell
  std::vector<BristleShare> shares_;
};

// The law of a bristle.
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

/// The friction of the bristles of one contact in one state: the traction of each at its root. Plain values.
struct StickingFriction {
  struct Root {
    dvec3 place{0};     ///< material point of the skin, frame A [m]
    dvec3 normal{0};    ///< unit normal that pushes A
    double area = 0;    ///< area of contact that the root bears [m^2]
    dvec3 traction{0};  ///< friction on A divided by the area [Pa]
    bool slips = false;
  };
  std::vector<Root> roots;
  double reach = 0;  ///< length s of the shares, see BristleSearch::shares() [m]

  /// Returns the traction at a point of the contact surface: that of the roots by their shares, so that its integral is
  /// the friction of the contact, as far as the roots resolve its edge.
  [[nodiscard]] dvec3 traction_at(const dvec3& x) const;
  /// Returns the share of the roots at a point that slip, from 0 (all stick) to 1.
  [[nodiscard]] double slip_at(const dvec3& x) const;
};

/// Returns the friction of the bristles of a contact that moves with V_BA.
StickingFriction sticking_friction(const BristleContact& contact, const BristleSkin& skin, const BristleLaw& law,
                                   const Twist& V_BA);

/// Returns the friction on body B, in the frame of B. The roots are the same material points of A.
StickingFriction mirrored(const StickingFriction& on_A, const RigidTransform& X_BA);

}  // namespace taxel
