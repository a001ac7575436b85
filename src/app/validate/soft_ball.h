// The soft ball of the closed forms of motion, and functions that solve them.
#pragma once

#include "app/validate/soft_on_floor.h"
#include "core/hydro/fields/round_mesh.h"

namespace taxel {

// A star field on a sphere with the exact volume, which is its medial-axis field.
inline constexpr double kBallRadius = 0.02, kBallModulus = 5e4, kBallMass = 0.05;
inline constexpr double kGravity = 9.81;

/// Returns the ball, with edges of at most `edge` [m].
inline SoftOnFloor soft_ball(const std::string& integrator, double dissipation, double edge) {
  SoftOnFloor setup;
  setup.skin = std::make_shared<const TriMesh>(make_round_sphere(kBallRadius, edge));
  setup.material = {FieldKind::star, kBallModulus, 0, dissipation, 0.5};
  setup.mass = kBallMass;
  setup.integrator = integrator;
  return setup;
}

/// Returns the force of A1 at the depth x [N].
inline double ball_force(double x) {
  return kPi * kBallModulus * x * x * (1 - 2 * x / (3 * kBallRadius));
}

/// Returns the root of an increasing function between low and high.
template <class Function>
double root(const Function& rising, double low, double high) {
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (rising(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Returns the depth at which the ball rests [m].
inline double ball_rest_depth() {
  return root([](double x) { return ball_force(x) - kGravity * kBallMass; }, 0, kBallRadius);
}

}  // namespace taxel
