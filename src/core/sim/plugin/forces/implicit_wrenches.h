// Implicit integration of friction and damping: the forces use the velocity at the end of the step.
//
// The wrench of a pair is w(V) = elastic(V) - S(V) V (hydro/traction.h). It is stiff in V: explicit friction would need
// steps below pi vs/(mu g), 0.06 ms. If all other forces are known, a step of h seconds changes the relative twist of
// the pair to V_free + h A w, where A = J M^-1 J^T is the inverse inertia at the contact. Both together are one
// equation in six unknowns, V = V_free + h A w(V), which is solved here.
//
// Several pairs that share bodies give the same equation in 6 n unknowns, with stacked twists, wrenches and secants.
// The block A_ij = J_i M^-1 J_j^T is the twist that a wrench of pair j gives to pair i. A robot hand that grasps a
// light object couples its fingertips stiffly: friction at rest responds to a velocity hundreds of times as strongly as
// the inertia of the object. If the pairs were solved one after the other, each would undo the solution of the others,
// and many hundred rounds would be needed. Solved together, the pairs need no more iterations than a single pair.
#pragma once

#include <functional>
#include <vector>

#include "core/hydro/traction.h"

namespace taxel {

/// Solver for the wrenches of a group of pairs. Reuses its memory from one step to the next.
class ImplicitWrenches {
 public:
  /// Begins a system of `pairs` pairs in a step of `timestep` seconds. After it, pair() and set_inverse_inertia() must
  /// be set for all pairs.
  void begin(std::size_t pairs, double timestep);

  struct Pair {
    Twist V_start;      ///< start of the search: the present twist
    Twist V_free;       ///< twist at the end of the step without the wrenches of these pairs
    double length = 1;  ///< size of the contact, to compare [rad/s] with [m/s] [m]
    Wrench wrench;      ///< result: the wrench
    Twist V_end;        ///< result: the twist at the end of the step
  };
  [[nodiscard]] Pair& pair(std::size_t i) { return pairs_[i]; }
  [[nodiscard]] std::size_t size() const { return pairs_.size(); }
  /// Sets A_ij, the change of relative twist per wrench and second. The whole matrix is symmetric and may be singular.
  /// pair(i).length and pair(j).length must be set before.
  void set_inverse_inertia(std::size_t i, std::size_t j, const Matrix6& A_ij);

  /// The law of a pair: returns the traction at a twist.
  using Law = std::function<Traction(std::size_t pair, const Twist& V)>;
  struct Outcome {
    int evaluations = 0;  ///< number of evaluations of the law, for each pair
    bool converged = false;
  };
  /// Solves the equation by repeated linear solves with the secant S, accelerated by Anderson mixing (Walker, Ni 2011).
  /// Each linear solve lowers the energy of the step, because |t| grows less than linearly in |v|; so the iteration
  /// cannot diverge. A single linear solve would chatter when sliding stops. Stops when an iteration changes V by less
  /// than 1e-7 of the change by the wrenches, or after 60 evaluations. The result is stable in either case.
  Outcome solve(const Law& law);

 private:
  using Vector = std::vector<double>;  // 6 n numbers: for each pair, linear and length * angular velocity
  void image_of(const Vector& v, const Law& law);
  void eliminate();
  void mix(bool grew);

  double timestep_ = 0;
  std::vector<Pair> pairs_;
  Vector A_, M_;  // (6 n)^2 numbers, row by row; A_ is in scaled units and multiplied by h
  Vector elastic_, S_;
  Vector free_, v_, image_, residual_, last_image_, last_residual_;
  std::size_t columns_ = 0;
  std::vector<Vector> images_, residuals_;  // changes of the latest iterates, oldest first
  std::vector<Vector> q_, moved_;           // scratch memory of mix()
};

}  // namespace taxel
