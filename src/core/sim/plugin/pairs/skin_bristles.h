// The bristles of one body of a plugin instance: their settings, their roots, and their state in MuJoCo's plugin state.
//
// The state of a body is a part of plugin_state of fixed size. For each root it has five numbers: the number of the
// touched geom plus 1 (0 if the bristle is free), the deflection u in the axes of M, and the area of the contact. For
// each geom of the model follow seven numbers: the pose of the touched body in M (quaternion, then position) to which
// the deflections belong, with a zero quaternion if there is none. The poses give the displacement since then exactly,
// whatever the integrator did in between, and also for mocap bodies, which have no velocity.
//
// The state is read at the PASSIVE and SENSOR stages and written only when the step is complete. So saving, restoring
// and copying a state repeats a run bit for bit, and Runge-Kutta stages do not disturb each other.
#pragma once

#include <mujoco/mujoco.h>

#include <optional>
#include <span>
#include <vector>

#include "core/hydro/bristles.h"
#include "core/sim/plugin/plugin_config.h"

namespace taxel {

/// Returns the number of state values of one body; 0 without bristles.
int bristle_state_size(const BristleSettings& settings, int geoms);

class SkinBristles {
 public:
  /// Throws Error whose place is the key if the body has no skin.
  SkinBristles(const HydroBody& body, const BristleSettings& settings);
  /// Copies the bristles. Memory that only speeds up a step starts empty.
  SkinBristles(const SkinBristles& other) : settings_(other.settings_), search_(other.search_.skin_pointer()) {}
  SkinBristles& operator=(const SkinBristles&) = delete;

  [[nodiscard]] const BristleSettings& settings() const { return settings_; }
  [[nodiscard]] const BristleSkin& skin() const { return search_.skin(); }

  /// Forgets the surfaces of the pairs, when they change.
  void forget_surfaces() { assigned_.assign(assigned_.size(), false); }
  /// Reads the bristles that bear the surface of a pair, with their deflections at the present pose X_MB of the touched
  /// body. `state` is the state of the body. A root that touches another geom, or nothing, has no deflection.
  void read(std::size_t pair, const ContactSurface& surface, int geom, const Pose& X_MB, std::span<const mjtNum> state);
  /// Bristles of a pair as the last read() left them.
  [[nodiscard]] const BristleContact& contact(std::size_t pair) const { return contacts_[pair]; }

  /// Frees all bristles in a new state. Call it once, then write() for each pair, then replace the state.
  void begin(std::size_t size) { next_.assign(size, 0); }
  /// Writes the bristles of a pair after a step in which the body moves with V_BA relative to the touched one. Call
  /// read() before.
  void write(std::size_t pair, int geom, const Pose& X_MB, const BristleLaw& law, const Twist& V_BA,
             std::span<const mjtNum> state);
  [[nodiscard]] std::span<const mjtNum> written() const { return next_; }

 private:
  BristleSettings settings_;
  BristleSearch search_;
  std::vector<BristleContact> contacts_;  // by pair
  std::vector<char> assigned_;            // the contact of the pair bears its present surface
  std::vector<mjtNum> next_;
};

}  // namespace taxel
