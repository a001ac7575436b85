// The contacts of one body with the geoms that it touches: poses, twists, surfaces and wrenches of the last evaluated
// state. A sensor has one such body, a `taxel.contact` has one for each soft geom.
//
// Frame M belongs to the body: it is the frame of a sensor's mesh file, or otherwise the frame of the geom. Wrenches
// act on the body, about the origin of M, in the axes of M.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <string>
#include <vector>

#include "core/hydro/bristles.h"
#include "core/hydro/hydro_body.h"
#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"
#include "core/sim/plugin/pairs/declared_bodies.h"
#include "core/sim/plugin/pairs/skin_bristles.h"
#include "core/sim/sensor_times.h"

namespace taxel {

/// Broad phase: finds the touched geoms that are near a sensor, by bounding spheres about the origins of geoms. MuJoCo
/// has already computed the positions of the origins, so the test costs a few nanoseconds for each geom and remains
/// correct when geoms move for any reason.
class BroadPhase {
 public:
  void clear();
  /// Adds a geom without a body. Numbers are given in the order of calls, from 0.
  void add(int geom);
  /// Sets the body of a geom. X_GB is the pose of the body's frame in the geom's frame.
  void set_body(std::size_t number, const HydroBody& body, const Pose& X_GB);
  void remove_body(std::size_t number);

  /// Sets `near` to the numbers of the geoms whose bodies may touch a sphere, ascending. Reuses the memory of `near`.
  void find(const mjData& d, const dvec3& center_W, double radius, std::vector<std::size_t>& near) const;

 private:
  std::vector<int> geoms_;
  std::vector<double> radii_;  // radii [m]; negative without a body, infinite for a half-space
};

/// A geom that the body touches.
struct TouchedGeom {
  int geom = -1;
  HydroBodyPtr body;   ///< touched body; null if it cannot be touched or a partner has not built it yet
  std::string repair;  ///< a sentence on the repair of its mesh; empty if there was none
  PairProperties properties;
  Pose X_GB;                 ///< pose of the touched body's frame in the geom; identity unless it is a sensor
  double half_diagonal = 0;  ///< half of the touched body's diagonal [m]; 0 unless this is a half-space
  PairRole role;             ///< role of this body towards a declared body on the geom
  dvec3 inner{0};            ///< inner_point() of the touched body, frame B
  Aabb box;                  ///< bounds of the touched body, frame B; empty for a half-space
};

/// The warnings about a pair that were given, and the checks of the pair so far.
struct PairChecks {
  bool mujoco_too = false;      ///< the warning about MuJoCo's own contact of this pair was given
  bool mujoco_share = false;    ///< the warning about MuJoCo's share of the force of this geom's body was given
  bool step_too_large = false;  ///< the warning about a contact too stiff for the time step was given
  bool undamped_back = false;   ///< the warning about back faces and little dissipation was given
  bool behind_skin = false;     ///< the warning about a body behind the skin of the other was given
  unsigned skin_checks = 0;     ///< number of times that the pair was near when sense_and_warn() looked
  unsigned step_checks = 0;     ///< calls of is_step_check_due() since the last check
  double checked_bound = 0;     ///< bound of the stiffest mode at the last check [1/s^2]
};

/// Contact of the body with one touched geom, in one state.
struct PairState {
  Pose X_WB;                  ///< pose of the touched body's frame B in the world
  Twist V;                    ///< motion of the body relative to B, at M's origin, frame M
  Twist V_rub;                ///< motion that gives `wrench`: V at the end of the step if the step is implicit
  ContactSurface surface;     ///< contact surface, frame M
  Wrench wrench;              ///< wrench on the body
  double implicit_step = 0;   ///< time step of which `wrench` uses the end [s]; 0 if it uses V
  StickingFriction sticking;  ///< friction of bristles in sensed(), frame M; no roots if friction is regularised
};

/// All pairs of a body in one state.
struct Evaluation {
  bool valid = false;
  Pose X_WM;
  /// States of the pairs, parallel to touched(). Pairs that are not in `near` have only `surface` and `wrench` set.
  std::vector<PairState> pairs;
  std::vector<std::size_t> near;  ///< indices of the pairs that may touch, ascending; all others are empty
};

/// A sphere and a box around a body.
struct BodyBounds {
  dvec3 center{0};    ///< centre of the sphere
  double radius = 0;  ///< radius [m]; infinite for a half-space
  Aabb box;           ///< empty for a half-space
};

/// Writes the total wrench or elastic wrench (6 values) or area (1 value) of a state to `out`. Returns the position
/// after the values.
mjtNum* write_block(const Evaluation& e, Output block, mjtNum* out);

/// The body of a sensor or of a soft geom, with all geoms that it touches.
class BodyContacts {
 public:
  /// `declared` has the body `id`. The body touches nothing before set_body().
  BodyContacts(BodyId id, std::vector<DeclaredBody> declared);
  /// Copies a body with its state, for mj_copyData. The memory of the kernels starts empty.
  BodyContacts(const BodyContacts&) = default;
  BodyContacts& operator=(const BodyContacts&) = delete;

  /// Replaces the friction that the configuration gives. Call it before set_body().
  void set_bristles(const BristleSettings& bristles) { declared_[self_].settings.bristles = bristles; }
  /// Sets the body, with its bounds in M and the pose of M in the geom's frame, compiles the geoms that it touches, and
  /// forgets all states. If a geom cannot be touched, throws Error if the configuration names the geom, and otherwise
  /// adds a warning.
  void set_body(const mjModel& m, HydroBodyPtr body, const Aabb& bounds_M, const Pose& X_GM);

  [[nodiscard]] BodyId id() const { return declared_[self_].id; }
  [[nodiscard]] const ContactSettings& settings() const { return declared_[self_].settings; }
  [[nodiscard]] const HydroBodyPtr& body() const { return body_; }  ///< body, or null before set_body()
  [[nodiscard]] const dvec3& inner_M() const { return inner_M_; }   ///< inner_point() of the body
  [[nodiscard]] const std::vector<TouchedGeom>& touched() const { return touched_; }  ///< ascending by geom
  /// Size of the contact with a touched geom, which compares angles with lengths [m].
  [[nodiscard]] double length(std::size_t pair) const {
    return body_->half_space() ? touched_[pair].half_diagonal : bounds_M_.radius;
  }

  /// The bristles of the skin, or null if friction is regularised.
  [[nodiscard]] SkinBristles* bristles() { return bristles_ ? &*bristles_ : nullptr; }

  /// Computes poses, twists and surfaces of the present state of `d`, and sets wrenches to zero. Pairs that the partner
  /// computes remain empty; sense() copies them from the partner.
  Evaluation& evaluate(const mjModel& m, mjData& d);
  // The two parts of evaluate(): poses and twists, which need `d`, and then surfaces. Several bodies of one mjData may
  // compute their surfaces at the same time.
  void begin_evaluation(const mjModel& m, mjData& d);
  void compute_surfaces();
  /// State of the last evaluate().
  [[nodiscard]] Evaluation& latest() { return slots_[latest_]; }
  /// Returns latest() if it is the present state. Otherwise evaluates the present state, with wrenches at the present
  /// velocities (no implicit step).
  Evaluation& present(const mjModel& m, mjData& d);
  /// Returns true if latest() is the present state.
  [[nodiscard]] bool is_fresh(const mjModel& m, const mjData& d);
  /// Retains the present state, with the pairs that partners compute, as sensed().
  void sense(const mjModel& m, mjData& d);
  /// State of the last sense(). Valid until the next step.
  [[nodiscard]] const Evaluation& sensed() const { return slots_[sensed_]; }

  /// Uses the body of a partner; must be called again when the partner's body changes. Throws Error if both bodies are
  /// rigid and the configuration names the geom.
  void link(const BodyContacts& other);

  /// Forgets all states.
  void reset();

  std::vector<std::string> warnings;  ///< warnings about the scene, for the user
  std::vector<PairChecks> checks;     ///< parallel to touched()
  SensorTimes times;                  ///< time spent so far; that of a copied mjData begins at 0
  /// Error of a callback that failed, set by the plugin. It is reported once, and the body then has no contacts.
  std::string failure;

 private:
  void compile_others(const mjModel& m);
  TouchedGeom compile_other(const mjModel& m, int geom);
  void mirror_pairs(const mjModel& m, mjData& d);
  void locate(const mjModel& m, const mjData& d, Evaluation& e) const;

  std::vector<DeclaredBody> declared_;
  std::size_t self_ = 0;  // index of this body in declared_
  HydroBodyPtr body_;
  Pose X_GM_;
  dvec3 inner_M_{0};  // inner_point() of the body
  BodyBounds bounds_M_;
  std::vector<TouchedGeom> touched_;
  std::vector<std::size_t> partners_;  // indices in touched_ of geoms with a declared body
  std::optional<SkinBristles> bristles_;
  BroadPhase broad_phase_;           // uses the indices of touched_
  std::array<Evaluation, 2> slots_;  // two, so that sensed() remains valid while RK4 evaluates more states
  std::size_t latest_ = 0, sensed_ = 0;
  Evaluation probe_;
  IntersectWorkspace workspace_;
};

// The bristles of the pairs of a body, in the state latest().

/// Returns the law of the bristles of a pair.
BristleLaw bristle_law(const BodyContacts& body, std::size_t pair, double timestep);
/// Reads the bristles of a pair, and returns them. Call it only if there are bristles. Throws Error if the model has
/// less state than the bristles need.
const BristleContact& read_bristles(const mjModel& m, mjData& d, BodyContacts& body, std::size_t pair);
/// Writes the state of the bristles at the end of a step. Leaves the state if there are no bristles, or if the contacts
/// of the step were not evaluated.
void advance_bristles(const mjModel& m, mjData& d, BodyContacts& body);

/// Returns the index of the pair with a geom, or touched.size() if there is none.
std::size_t pair_with(const std::vector<TouchedGeom>& touched, int geom);

// The contact surface of two declared bodies, from poses alone.

/// Computes the contact surface as the body that computes the pair does, so the result has the same bits. That body is
/// `other` if the pair is mirrored (PairRole), otherwise `self`. X_WM and X_WO are the poses of the frames of `self`
/// and `other`; `out` is in the frame of `self`.
void intersect_bodies(const BodyContacts& self, const BodyContacts& other, bool mirrored, const Pose& X_WM,
                      const Pose& X_WO, ContactSurface& out, IntersectWorkspace& workspace);

}  // namespace taxel
