// The contacts of one body with the geoms that it touches: poses, twists, surfaces and wrenches of the state last
// evaluated. A sensor has one such body, a `taxel.contact` one for each soft geom.
//
// Frame M is the body's: that of a sensor's mesh file, otherwise that of the geom. Wrenches act on the body, about M's
// origin, in M's axes.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <string>
#include <vector>

#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"
#include "core/sim/plugin/pairs/broad_phase.h"
#include "core/sim/plugin/pairs/declared_bodies.h"
#include "core/sim/sensor_times.h"

namespace taxel {

/// A geom that the body touches.
struct TouchedGeom {
  int geom = -1;
  HydroBodyPtr body;  ///< null: a partner that has no body yet, or none that can be touched
  PairProperties properties;
  Pose X_GB;                    ///< touched body's frame in the geom's; identity unless it is a sensor's
  double half_diagonal = 0;     ///< half of the touched body's diagonal [m]; 0 unless this is a half-space
  PairRole role;                ///< towards a declared body on the geom
  bool mujoco_too = false;      ///< MuJoCo's own contact of the pair was seen: reported once
  unsigned step_checks = 0;     ///< how often the time step was to be checked
  bool step_too_large = false;  ///< the contact was seen to be too stiff for the time step: reported once
};

/// A pair in one state.
struct PairState {
  Pose X_WB;               ///< touched body's frame in the world
  Twist V;                 ///< motion of the body relative to B, at M's origin, frame M
  Twist V_rub;             ///< V for which `wrench` was found: of the step's end if that is implicit
  ContactSurface surface;  ///< frame M
  Wrench wrench;           ///< on the body
};

/// All pairs of a body in one state.
struct Evaluation {
  bool valid = false;
  Pose X_WM;
  std::vector<PairState> pairs;   ///< parallel to touched(); entries not listed in `near` have only surface and wrench
  std::vector<std::size_t> near;  ///< numbers of the pairs that may touch, ascending; all others are empty
};

class BodyContacts {
 public:
  /// `declared` has the body `id`. It touches nothing before set_body().
  BodyContacts(BodyId id, std::vector<DeclaredBody> declared);
  /// For mj_copyData: the same body in the same state. Memory that only speeds up a step starts empty.
  BodyContacts(const BodyContacts& other);
  BodyContacts& operator=(const BodyContacts&) = delete;

  /// Sets the body, with its bounds in M and the pose of M in the geom's frame, compiles the geoms that it touches and
  /// forgets all states. Throws Error for a named geom that cannot be touched; of others a warning says so.
  void set_body(const mjModel& m, HydroBodyPtr body, const Aabb& bounds_M, const Pose& X_GM);

  [[nodiscard]] BodyId id() const { return declared_[self_].id; }
  [[nodiscard]] const ContactSettings& settings() const { return declared_[self_].settings; }
  [[nodiscard]] const HydroBodyPtr& body() const { return body_; }  ///< body, or null before set_body()
  [[nodiscard]] const Pose& X_GM() const { return X_GM_; }
  [[nodiscard]] const std::vector<TouchedGeom>& touched() const { return touched_; }
  /// Size of the contact with a touched geom, which compares angles with lengths [m].
  [[nodiscard]] double length(std::size_t pair) const {
    return body_->half_space() ? touched_[pair].half_diagonal : radius_;
  }

  /// Poses, twists and surfaces of the present state of `d`; wrenches are zeroed.
  /// Pairs that the partner computes stay empty: sense() takes them from there.
  Evaluation& evaluate(const mjModel& m, mjData& d);
  /// The state that evaluate() saw last.
  [[nodiscard]] Evaluation& latest() { return slots_[latest_]; }
  /// latest() if it is of the present state, else that state evaluated, its wrenches without implicit step.
  Evaluation& present(const mjModel& m, mjData& d);
  /// Retains the present state, with the pairs that partners compute, as sensed().
  void sense(const mjModel& m, mjData& d);
  /// The state that sense() saw last. Valid until the next step.
  [[nodiscard]] const Evaluation& sensed() const { return slots_[sensed_]; }
  /// Writes the wrench (6 values) or the area (1 value) of all pairs of sensed() to `out`; returns the place behind.
  mjtNum* write_output(Output block, mjtNum* out) const;

  /// Takes the body of a partner; to be called again when the partner gets another. Throws Error if both are rigid and
  /// the geom was named.
  void link(const BodyContacts& other);

  /// True at the first call for a pair and at every `every`th.
  bool time_to_check_step(std::size_t pair, unsigned every) { return touched_[pair].step_checks++ % every == 0; }
  /// Reports, once, that a pair's contact is stiffer than the time step bears; `largest` is the step it does [s].
  void note_step_too_large(const mjModel& m, std::size_t pair, double largest);

  /// Forgets all states.
  void reset();

  std::vector<std::string> warnings;  ///< warnings about the scene, for the user
  SensorTimes times;                  ///< time spent so far; a copy begins at 0
  /// Set by the plugin when a callback failed: reported once, then the body has no contacts.
  std::string failure;

 private:
  /// The key that names the touched geoms, for errors.
  [[nodiscard]] const char* key_of_others() const { return declared_[self_].sensor ? "others" : "pairs"; }
  void set_properties(TouchedGeom& touched) const;  ///< those that depend on both bodies
  void compile_others(const mjModel& m);
  TouchedGeom compile_other(const mjModel& m, int geom);
  void link_all(const mjModel& m, mjData& d);
  void mirror_pairs(const mjModel& m, mjData& d);
  /// Number of the pair with a geom; touched().size() if there is none.
  [[nodiscard]] std::size_t pair_with(int geom) const;
  void note_mujoco_contacts(const mjModel& m, const mjData& d);
  void clear_pairs(Evaluation& e) const;
  void locate(const mjModel& m, const mjData& d, Evaluation& e) const;
  [[nodiscard]] bool fresh(const mjModel& m, const mjData& d);

  std::vector<DeclaredBody> declared_;
  std::size_t self_ = 0;  // in declared_
  HydroBodyPtr body_;
  Pose X_GM_;
  dvec3 center_M_{0};                  // of the bounding sphere
  double radius_ = 0;                  // of the bounding sphere; infinite for a half-space
  std::vector<TouchedGeom> touched_;   // ascending by geom
  std::vector<std::size_t> partners_;  // numbers of those with a declared body
  BroadPhase broad_phase_;             // numbers as touched_
  std::array<Evaluation, 2> slots_;    // one may still be shown as sensed() while RK4 evaluates further
  std::size_t latest_ = 0, sensed_ = 0;
  Evaluation probe_;
  IntersectWorkspace workspace_;
};

}  // namespace taxel
