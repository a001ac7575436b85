// The wrenches of several pairs that share bodies, all with the velocities of the end of the step.
//
// A hand that holds a light object couples its fingertips stiffly: friction at rest answers a velocity hundreds of
// times as strongly as the object's inertia does. Solved one after the other, each pair undoes what the others did, and
// many hundred rounds would be needed; solved together they take no more iterations than one pair does.
//
// With the pairs' twists, wrenches and secants stacked (implicit_wrench.h), V = V_free + h A w(V) is the same equation
// in 6 n unknowns; the block A_ij = J_i M^-1 J_j^T is the twist that a wrench of pair j gives pair i.
#pragma once

#include <functional>
#include <vector>

#include "core/sim/plugin/implicit_wrench.h"

namespace taxel {

/// Keeps its memory from one step to the next.
class CoupledWrenches {
 public:
  /// Of so many pairs, in a step of h seconds; then everything of pair() and inverse_inertia() is to be set.
  void begin(std::size_t pairs, double timestep);

  struct Pair {
    Twist V_start;      ///< where the search begins
    Twist V_free;       ///< at the end of the step without the wrenches of all these pairs
    double length = 1;  ///< size of the contact [m]
    Wrench wrench;      ///< found
    Twist V_end;        ///< likewise
  };
  [[nodiscard]] Pair& pair(std::size_t i) { return pairs_[i]; }
  [[nodiscard]] std::size_t size() const { return pairs_.size(); }
  void set_inverse_inertia(std::size_t i, std::size_t j, const Matrix6& A_ij);

  /// The law of a pair: its traction at a twist.
  using Law = std::function<Traction(std::size_t pair, const Twist& V)>;
  struct Outcome {
    int evaluations = 0;  ///< of the law, for each pair
    bool converged = false;
  };
  /// By repeated linear solves with the secants, accelerated, to the tolerance of solve_implicit_wrench() and with its
  /// guarantee: each lowers the energy of the step.
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
