// Friction and damping with the velocity of the end of the step.
//
// A pair's wrench is w(V) = elastic(V) - S(V) V (hydro/traction.h), stiff in V: explicit friction needs steps below
// pi vs/(mu g), 0.06 ms. The step itself, with everything but this wrench known, moves the pair's relative twist to
// V_free + h A w, A = J M^-1 J^T being the inverse inertia that the contact feels. Both together are one equation in
// six unknowns, V = V_free + h A w(V), solved here.
//
// So it is for several pairs that share bodies: with their twists, wrenches and secants stacked it is the same equation
// in 6 n unknowns; the block A_ij = J_i M^-1 J_j^T is the twist that a wrench of pair j gives pair i. A hand that holds
// a light object couples its fingertips stiffly: friction at rest answers a velocity hundreds of times as strongly as
// the object's inertia does. Solved one after the other, each pair undoes what the others did, and many hundred rounds
// would be needed; solved together they take no more iterations than one pair does.
#pragma once

#include <functional>
#include <vector>

#include "core/hydro/traction.h"

namespace taxel {

/// Keeps its memory from one step to the next.
class ImplicitWrenches {
 public:
  /// Of so many pairs, in a step of h seconds; then everything of pair() and inverse_inertia() is to be set.
  void begin(std::size_t pairs, double timestep);

  struct Pair {
    Twist V_start;      ///< where the search begins: the twist now
    Twist V_free;       ///< at the end of the step without the wrenches of all these pairs
    double length = 1;  ///< size of the contact: compares [rad/s] with [m/s] [m]
    Wrench wrench;      ///< found
    Twist V_end;        ///< likewise
  };
  [[nodiscard]] Pair& pair(std::size_t i) { return pairs_[i]; }
  [[nodiscard]] std::size_t size() const { return pairs_.size(); }
  /// A_ij, relative twist per wrench and second; the whole matrix is symmetric and may be singular. After
  /// pair(i).length and pair(j).length.
  void set_inverse_inertia(std::size_t i, std::size_t j, const Matrix6& A_ij);

  /// The law of a pair: its traction at a twist.
  using Law = std::function<Traction(std::size_t pair, const Twist& V)>;
  struct Outcome {
    int evaluations = 0;  ///< of the law, for each pair
    bool converged = false;
  };
  /// By repeated linear solves with the secant S (each lowers the energy of the step, so they cannot run away: |t|
  /// grows less than linearly in |v|), accelerated by Anderson mixing (Walker, Ni 2011). A single linear solve would
  /// chatter when sliding stops. Stops when an iteration changes V by less than 1e-7 of what the wrenches changed it
  /// by, or after 60 evaluations; the result is stable in either case.
  Outcome solve(const Law& law);

 private:
  using Vector = std::vector<double>;  // 6 n numbers: linear, and length * angular, of each pair
  void image_of(const Vector& v, const Law& law);
  void eliminate();
  void mix(bool grew);

  double timestep_ = 0;
  std::vector<Pair> pairs_;
  Vector A_, M_;  // (6 n)^2, by rows; A_ in scaled units, times h
  Vector elastic_, S_;
  Vector free_, v_, image_, residual_, last_image_, last_residual_;
  std::size_t columns_ = 0;
  std::vector<Vector> images_, residuals_;  // changes of the latest iterates, oldest first
  std::vector<Vector> q_, moved_;           // scratch of mix()
};

}  // namespace taxel
