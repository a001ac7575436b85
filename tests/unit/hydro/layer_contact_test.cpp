// Elastic layers: compliance, contact of balls and cylinders, moduli of pads.
#include "core/hydro/material/pad_modulus.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/hydro/quadrature.h"
#include "fixtures/complaint.h"

namespace taxel::test {
namespace {

constexpr LayerBase kBases[] = {LayerBase::bonded, LayerBase::sliding};
constexpr PressedBody kBodies[] = {PressedBody::ball, PressedBody::cylinder};

TEST(GaussLegendre, IntegratesPolynomialsExactly) {
  for (const int count : {1, 2, 5, 14, 40}) {
    QuadratureRule rule;
    add_gauss_legendre(1.0, 3.0, count, rule);
    const int degree = 2 * count - 1;
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], degree);
    const double exact = (std::pow(3.0, degree + 1) - 1.0) / (degree + 1);
    EXPECT_NEAR(sum / exact, 1.0, 1e-12) << count;
  }
}

TEST(LayerCompliance, HasTheLimitsOfThinAndThickLayers) {
  for (const LayerBase base : kBases)
    for (const double nu : {0.0, 0.3, 0.49}) {
      EXPECT_NEAR(layer_compliance(20.0, nu, base), 1.0, 1e-12);
      const double thin = 1.0 / (1.0 - nu * nu) / (2.0 * thin_layer_modulus({1.0, nu, 1.0, base}));
      EXPECT_NEAR(layer_compliance(1e-3, nu, base) / 1e-3, thin, 1e-3 * thin);
    }
}

TEST(LayerContact, EqualsHertzOnAThickLayer) {
  const double a = 0.01;
  for (const LayerBase base : kBases) {
    const LayerPress ball = press_layer(a, 0.3, base, PressedBody::ball);
    EXPECT_NEAR(ball.force / (4.0 / 3.0 * a * a * a), 1.0, 1e-4);  // F = 4/3 E* a^3 / R
    EXPECT_NEAR(ball.depth / (a * a), 1.0, 0.02);                  // depth = a^2 / R; the layer is not infinite
    const LayerPress cylinder = press_layer(a, 0.3, base, PressedBody::cylinder);
    EXPECT_NEAR(cylinder.force / (kPi / 4.0 * a * a), 1.0, 1e-3);  // F' = pi E* a^2 / (4 R)
  }
}

// Garcia and Garcia 2018: a series in chi = sqrt(R depth)/H for an incompressible bonded layer. Dimitriadis et al. 2002
// have the same first term and smaller further ones.
TEST(LayerContact, EqualsThePublishedSeriesAtSmallContacts) {
  for (const double chi : {0.05, 0.1, 0.2, 0.4}) {
    const LayerPress press = press_with_overlap(std::sqrt(2.0) * chi, 0.4999999, LayerBase::bonded, PressedBody::ball);
    const double series = 1 + chi * (1.133 + chi * (1.497 + chi * (1.469 + chi * 0.755)));
    EXPECT_NEAR(press.force / (4.0 / 3.0 * std::pow(press.depth, 1.5)), series, 0.004 * series) << chi;
  }
}

TEST(LayerContact, EqualsJohnsonsThinIncompressibleLayer) {
  // Johnson 1985, eq. 5.72 and 5.75: depth = a^2/(4 R) of a ball, a^2/(6 R) of a cylinder, slowly from above.
  double last_ball = 10, last_cylinder = 10;
  for (const double a : {5.0, 10.0, 20.0, 40.0}) {
    const double ball = press_layer(a, 0.4999999999, LayerBase::bonded, PressedBody::ball).depth / (a * a / 4);
    const double cylinder = press_layer(a, 0.4999999999, LayerBase::bonded, PressedBody::cylinder).depth / (a * a / 6);
    EXPECT_GT(ball, 1.0);
    EXPECT_LT(ball, last_ball);
    EXPECT_LT(cylinder, last_cylinder);
    last_ball = ball, last_cylinder = cylinder;
  }
  EXPECT_NEAR(last_ball, 1.0, 0.1);
  EXPECT_NEAR(last_cylinder, 1.0, 0.1);
}

TEST(LayerContact, FindsThePressWithAnOverlap) {
  for (const LayerBase base : kBases)
    for (const PressedBody body : kBodies)
      for (const double radius : {0.05, 1.0, 20.0})
        for (const double nu : {0.0, 0.45, 0.4999})
          EXPECT_NEAR(overlap_radius(press_with_overlap(radius, nu, base, body)) / radius, 1.0, 1e-7)
              << radius << " " << nu;
}

TEST(PadModulus, HasTheClosedFormsOfThinLayers) {
  EXPECT_DOUBLE_EQ(thin_layer_modulus({6e4, 0.0, 1e-3, LayerBase::bonded}), 6e4);
  EXPECT_DOUBLE_EQ(thin_layer_modulus({6e4, 0.0, 1e-3, LayerBase::sliding}), 6e4);
  EXPECT_NEAR(thin_layer_modulus({6e4, 0.49, 1e-3, LayerBase::bonded}), 6e4 * 0.51 / (1.49 * 0.02), 1e-6);
  EXPECT_NEAR(thin_layer_modulus({6e4, 0.49, 1e-3, LayerBase::sliding}), 6e4 / 0.7599, 1e-6);
  EXPECT_GT(thin_layer_modulus({1.0, 0.5 - 1e-9, 1.0, LayerBase::bonded}), 1e8);
}

TEST(PadModulus, TendsToTheThinLayerForWideContacts) {
  for (const PressedBody body : kBodies) {
    const ElasticLayer bonded{1.0, 0.3, 1e-3, LayerBase::bonded}, sliding{1.0, 0.499, 1e-3, LayerBase::sliding};
    EXPECT_NEAR(modulus_at_contact(bonded, 20e-3, body) / thin_layer_modulus(bonded), 1.0, 0.002);
    EXPECT_NEAR(modulus_at_contact(sliding, 20e-3, body) / thin_layer_modulus(sliding), 1.0, 0.002);
  }
}

TEST(PadModulus, GrowsWithPoissonsRatioAndWithGlue) {
  for (const PressedBody body : kBodies)
    for (const double radius : {0.2, 1.0, 5.0}) {
      double last = 0;
      for (const double nu : {0.0, 0.2, 0.4, 0.45, 0.49, 0.499, 0.4999}) {
        const double bonded = modulus_at_contact({1.0, nu, 1.0, LayerBase::bonded}, radius, body);
        EXPECT_GT(bonded, last) << radius << " " << nu;
        EXPECT_GT(bonded, modulus_at_contact({1.0, nu, 1.0, LayerBase::sliding}, radius, body));
        last = bonded;
      }
    }
}

TEST(PadModulus, ScalesWithItsUnits) {
  const double one = modulus_at_contact({1.0, 0.45, 1.0, LayerBase::bonded}, 1.5, PressedBody::ball);
  const double other = modulus_at_contact({6e4, 0.45, 2e-3, LayerBase::bonded}, 3e-3, PressedBody::ball);
  EXPECT_NEAR(other / one, 6e4, 1e-3);
}

TEST(PadModulus, HoldsWithinItsRangeAndNotOutside) {
  const ElasticLayer layer{6e4, 0.4999, 2e-3, LayerBase::bonded};
  const PadModulus result = pad_modulus(layer, 3e-3, PressedBody::ball);
  ASSERT_TRUE(result.holds);
  EXPECT_LT(result.holds->low, 3e-3);
  EXPECT_GT(result.holds->high, 3e-3);
  for (const double end : {result.holds->low, result.holds->high}) {
    const double error = result.modulus / modulus_at_contact(layer, end, PressedBody::ball) - 1.0;
    EXPECT_NEAR(std::abs(error), kModulusTolerance, 0.002) << end;
  }
}

TEST(PadModulus, NamesThePoissonsRatioFromWhichAThinLayerIsTooStiff) {
  const PadModulus result = pad_modulus({6e4, 0.49, 2e-3, LayerBase::bonded}, 4e-3, PressedBody::ball);
  ASSERT_TRUE(result.poisson_limit);
  const ElasticLayer at{1.0, *result.poisson_limit, 2e-3, LayerBase::bonded};
  EXPECT_NEAR(thin_layer_modulus(at) / modulus_at_contact(at, 4e-3, PressedBody::ball), 1.0 + kModulusTolerance, 0.002);
  EXPECT_FALSE(pad_modulus({6e4, 0.49, 2e-3, LayerBase::bonded}, std::nullopt, PressedBody::ball).holds);
  EXPECT_FALSE(pad_modulus({6e4, 0.49, 2e-3, LayerBase::sliding}, std::nullopt, PressedBody::ball).poisson_limit);
}

TEST(PadModulus, NamesBadInput) {
  const auto expect = [](const ElasticLayer& layer, const char* text) {
    EXPECT_EQ(complaint_of([&] { pad_modulus(layer, std::nullopt, PressedBody::ball); }), text);
  };
  expect({0.0, 0.4, 1e-3, LayerBase::bonded}, "youngs: must be greater than 0 Pa, is 0");
  expect({1.0, 0.5, 1e-3, LayerBase::bonded},
         "poisson: must be at least 0 and less than 0.5 (rubber: 0.49 to 0.4999), is 0.5");
  expect({1.0, -0.1, 1e-3, LayerBase::bonded},
         "poisson: must be at least 0 and less than 0.5 (rubber: 0.49 to 0.4999), is -0.1");
  expect({1.0, 0.4, 0.0, LayerBase::bonded}, "thickness: must be greater than 0 m, is 0");
  expect({1.0, std::nan(""), 1e-3, LayerBase::bonded},
         "poisson: must be at least 0 and less than 0.5 (rubber: 0.49 to 0.4999), is nan");
}

}  // namespace
}  // namespace taxel::test
