// Friction that sticks, A10.
#include "app/validate/validation.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "app/validate/setups.h"
#include "core/hydro/bristles.h"
#include "core/hydro/hydro_body.h"
#include "core/hydro/intersect.h"

namespace taxel {
namespace {

constexpr double kSkinRadius = 0.02, kDepth = 0.003, kSkinModulus = 5e4, kStiffness = 2e8, kMu = 0.5;
constexpr int kBallBristles = 8000;

/// A soft ball with p = E (1 - r/R), pressed on a rigid plane, and its bristles.
class BrushedBall {
 public:
  BrushedBall() : search_(nullptr) {
    Material soft;
    soft.modulus = kSkinModulus;
    const HydroBodyPtr ball =
        make_body({ShapeType::sphere, dvec3(kSkinRadius), nullptr, 0.06 * kSkinRadius}, soft, "ball");
    const HydroBodyPtr floor = make_body({ShapeType::plane, dvec3(0), nullptr, 0}, {}, "floor");
    search_ =
        BristleSearch(std::make_shared<const BristleSkin>(*std::get<SoftBody>(ball->geometry).field, kBallBristles));
    ContactSurface surface;
    IntersectWorkspace workspace;
    intersect(*ball, *floor, Pose{dquat(1, 0, 0, 0), {0, 0, kSkinRadius - kDepth}}, Pose{}, surface, workspace);
    contact_.assign(surface, search_);
  }
  /// Moves the ball by dx and lets its bristles slip. Returns the force that resists.
  double move(double dx) {
    const BristleLaw law{kStiffness, {0, kMu}, 1, 0};
    double force = 0;
    sticking_ = 0;
    for (Bristle& b : contact_.bristles()) {
      const BristleAnswer answer = answer_of(b, law, {{dx, 0, 0}, dvec3(0)});
      b.u = answer.u + dvec3(dx, 0, 0) - dx * b.normal.x * b.normal;
      force -= answer.force.x;
      if (!answer.slips) sticking_ += b.area;
    }
    return force;
  }
  /// Returns the radius of a disc with the area that stuck in the last move.
  [[nodiscard]] double sticking_radius() const { return std::sqrt(sticking_ / kPi); }

 private:
  BristleSearch search_;
  BristleContact contact_;
  double sticking_ = 0;
};

/// The displacement at which the whole contact slips.
constexpr double kAllSlips = kMu * kSkinModulus * kDepth / kSkinRadius / kStiffness;

/// Returns the radius within which k u < mu p.
double exact_radius(double u) {
  const double r = kSkinRadius * (1 - kStiffness * u / (kMu * kSkinModulus)), h = kSkinRadius - kDepth;
  return std::sqrt(std::max(0.0, r * r - h * h));
}

/// Returns the friction after a first displacement u: k u on the sticking disc, and mu p on the ring around it.
double exact_friction(double u) {
  const double h2 = (kSkinRadius - kDepth) * (kSkinRadius - kDepth);
  const auto load = [&](double rho) {
    return 2 * kPi * kSkinModulus * (0.5 * rho * rho - std::pow(h2 + rho * rho, 1.5) / (3 * kSkinRadius));
  };
  const double c = exact_radius(u), a = std::sqrt(kSkinRadius * kSkinRadius - h2);
  return kStiffness * u * kPi * c * c + kMu * (load(a) - load(c));
}

/// Returns the work of friction over a whole cycle between -U and U, after a first displacement to U.
double loop_of(BrushedBall& ball, double U) {
  constexpr int kSteps = 100;
  const double du = U / kSteps;
  double before = 0, work = 0;
  const auto go = [&](double step, int count) {
    for (int n = 0; n < count; ++n) {
      const double now = ball.move(step);
      work += 0.5 * (before + now) * step;
      before = now;
    }
  };
  go(du, kSteps);
  work = 0;
  go(-du, 2 * kSteps);
  go(du, 2 * kSteps);
  return work;
}

/// Masing (1926): each branch is the first loading, scaled by two, so the loop has 8 times the area between the first
/// loading and its chord.
double exact_loop(double U) {
  constexpr int kParts = 1000;
  double first = 0;  // integral of the first loading
  for (int n = 0; n < kParts; ++n) first += exact_friction((n + 0.5) * U / kParts) * U / kParts;
  return 8 * (first - 0.5 * U * exact_friction(U));
}

}  // namespace

ClosedFormChecks validate_brush() {
  constexpr int kSteps = 50;
  const CheckedCase about{"A10",
                          fmt::format("soft ball on a rigid plane, R = {} m, depth {} m, E = {} Pa, k = {:g} Pa/m, "
                                      "mu = {}, {} bristles, moved sideways until all of it slips",
                                      kSkinRadius, kDepth, kSkinModulus, kStiffness, kMu, kBallBristles)};
  Statistic radius, friction;
  BrushedBall ball;
  for (int n = 1; n < kSteps; ++n) {
    const double u = n * kAllSlips / kSteps, force = ball.move(kAllSlips / kSteps);
    friction.add(force, exact_friction(u));
    // The bristles are too far apart for the radius of a smaller disc.
    if (exact_radius(u) > 0.5 * exact_radius(0)) radius.add(ball.sticking_radius(), exact_radius(u));
  }
  BrushedBall cycled;
  Statistic loop;
  loop.add(loop_of(cycled, 0.7 * kAllSlips), exact_loop(0.7 * kAllSlips));
  return {radius.mean(about, "radius of the sticking part", "m", 0.01),
          radius.worst(about, "radius of the sticking part", "m", 0.02), friction.worst(about, "friction", "N", 0.02),
          loop.worst(about, "hysteresis loop", "J", 0.02)};
}

ClosedFormChecks validate_held_block() {
  const auto held = [](const char* integrator, double theta) {
    SoftOnFloor setup = block_on_slope(integrator, theta);
    setup.material.tangential_stiffness = 1e7;
    setup.material.bristles = 100;
    return setup;
  };
  double moved = 0, below = 0, above = std::numeric_limits<double>::infinity();
  for (const char* integrator : kIntegrators) {
    SoftOnFloorRun rests(held(integrator, 15 * kPi / 180));
    rests.step(500);
    const dvec3 start = rests.place();
    for (int n = 0; n < 20; ++n) {
      rests.step(50);
      moved = std::max(moved, glm::distance(rests.place(), start));
    }
    SoftOnFloorRun holds(held(integrator, std::atan(0.995 * 0.5))), slides(held(integrator, std::atan(1.005 * 0.5)));
    holds.step(600);
    slides.step(600);
    below = std::max(below, glm::length(holds.velocity()));
    above = std::min(above, slides.velocity().x);
  }
  const CheckedCase about{"A10",
                          "soft block on a rigid slope, mu = 0.5, k = 1e7 Pa/m, steps of 2 ms, every integrator"};
  return {about.limit("distance moved in 2 s at 15 degrees", "m", moved, Relation::at_most, 1e-9),
          about.limit("speed at 0.995 mu", "m/s", below, Relation::at_most, 1e-9),
          about.limit("speed at 1.005 mu after 1.2 s", "m/s", above, Relation::at_least, 0.01)};
}

ClosedFormChecks validate_sticking() {
  ClosedFormChecks all = validate_brush();
  const ClosedFormChecks held = validate_held_block();
  all.insert(all.end(), held.begin(), held.end());
  return all;
}

}  // namespace taxel
