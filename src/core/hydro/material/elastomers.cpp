#include "core/hydro/material/elastomers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace taxel {
namespace {

void check_hardness(const char* field, double hardness) {
  if (!(hardness >= kHardnessTolerance && hardness <= 100.0 - kHardnessTolerance))
    throw Error("", field,
                fmt::format("must be from {} to {}, is {}", kHardnessTolerance, 100.0 - kHardnessTolerance, hardness));
}

/// Gent 1958, "On the relation between indentation hardness and Young's modulus", eq. 8, in Pa.
double gent(double s) {
  return 1e6 * 0.0981 * (56.0 + 7.62336 * s) / (0.137505 * (254.0 - 2.54 * s));
}

/// Qi, Joyce and Boyce 2003, "Durometer hardness and the stress-strain behavior of elastomeric materials": log10 of E
/// in MPa, fitted to nonlinear finite elements for 20 < s < 80. In Pa.
double qi(double s) {
  return 1e6 * std::pow(10.0, 0.0235 * s - 0.6403);
}

/// ASTM D2240, type OO: a ball of 2.38 mm diameter protrudes by 2.54 mm at 0; the spring pushes with 0.203 N and
/// 0.00908 N for each unit. F = 4/3 E/(1 - nu^2) sqrt(R) d^1.5 with nu = 1/2 (Hertz 1882). In Pa.
double ball_on_spring(double s) {
  const double force = 0.203 + 0.00908 * s, depth = 2.54e-3 * (1.0 - 0.01 * s), radius = 1.19e-3;
  return 0.75 * 0.75 * force / (std::sqrt(radius) * std::pow(depth, 1.5));
}

}  // namespace

YoungsEstimate youngs_from_shore_a(double hardness) {
  check_hardness("shore_a", hardness);
  YoungsEstimate estimate{gent(hardness), gent(hardness - kHardnessTolerance),
                          gent(std::min(hardness + kHardnessTolerance, 99.0)), "Gent 1958"};
  if (hardness >= 20.0 && hardness <= 80.0) {
    estimate.low = std::min(estimate.low, qi(hardness - kHardnessTolerance));
    estimate.high = std::max(estimate.high, qi(hardness + kHardnessTolerance));
    estimate.source = "Gent 1958; range with Qi, Joyce and Boyce 2003";
  }
  return estimate;
}

YoungsEstimate youngs_from_shore_00(double hardness) {
  check_hardness("shore_00", hardness);
  return {ball_on_spring(hardness), ball_on_spring(hardness - kHardnessTolerance),
          ball_on_spring(std::min(hardness + kHardnessTolerance, 99.0)),
          "Hertz 1882 for ball and spring of ASTM D2240, as Mix and Giacomin 2011"};
}

namespace {

constexpr double kPsi = 6894.757293168;  ///< pounds per square inch [Pa]
constexpr double kBulkModulus = 1e9;     ///< order of magnitude of rubbers [Pa]
constexpr double kLargestPoisson = 0.4999;
constexpr const char* kSheet = "Smooth-On's data sheet: stress at 100 % strain, hardness, specific gravity";
constexpr const char* kAssumed =
    "Young's modulus is computed from the stress at 100 % strain (neo-Hookean; measured moduli differ by up to "
    "a factor 2), Poisson's ratio from a bulk modulus of 1 GPa; the sheet's figures are quoted second hand and were "
    "not compared with its current issue";

/// A silicone of Smooth-On. `hardness` is Shore 00 if `is_00`, else Shore A.
Elastomer smooth_on(const char* word, const char* title, double psi, double density, double hardness, bool is_00) {
  Elastomer e{word, title, youngs_from_stress_100(psi * kPsi), 0, density, psi * kPsi, {}, {}, kSheet, kAssumed};
  e.poisson = rubber_poisson(e.youngs);
  (is_00 ? e.shore_00 : e.shore_a) = hardness;
  return e;
}

/// An elastomer with a Young's modulus of its own source.
Elastomer with_youngs(const char* word, const char* title, double youngs, double density, double shore_a,
                      const char* source, const char* unverified) {
  Elastomer e{word, title, youngs, rubber_poisson(youngs), density, {}, {}, {}, source, unverified};
  e.shore_a = shore_a;
  return e;
}

std::vector<Elastomer> make_elastomers() {
  return {smooth_on("ecoflex-00-10", "Ecoflex 00-10", 8, 1040, 10, true),
          smooth_on("ecoflex-00-20", "Ecoflex 00-20", 8, 1070, 20, true),
          smooth_on("ecoflex-00-30", "Ecoflex 00-30", 10, 1070, 30, true),
          smooth_on("ecoflex-00-50", "Ecoflex 00-50", 12, 1070, 50, true),
          smooth_on("dragon-skin-10", "Dragon Skin 10", 22, 1070, 10, false),
          smooth_on("dragon-skin-20", "Dragon Skin 20", 49, 1080, 20, false),
          smooth_on("dragon-skin-30", "Dragon Skin 30", 86, 1080, 30, false),
          smooth_on("solaris", "Solaris", 25, 990, 15, false),
          with_youngs(
              "sylgard-184", "Sylgard 184, 10:1, cured at 25 degrees C", 1.32e6, 1030, 44,
              "Johnston, McCluskey, Tan and Tracey 2014: modulus, hardness; Dow's data sheet: density",
              "2.97 MPa if cured at 200 degrees C; published shear moduli range over two orders of magnitude (Varner "
              "and Cohen 2024); Poisson's ratio is from a bulk modulus of 1 GPa"),
          with_youngs("elastosil-rt-601", "Elastosil RT 601", youngs_from_shore_a(45).youngs, 1020, 45,
                      "Wacker's data sheet: hardness, density; modulus by Gent 1958 from the hardness",
                      "hardness and density were not compared with a current data sheet; no modulus was measured"),
          with_youngs("tpu-85a", "TPU of 3-D printing, Shore 85A (NinjaFlex)", 12e6, 1190, 85,
                      "NinjaTek's data sheet: tensile modulus, hardness, specific gravity",
                      "not compared with a current data sheet; printed parts depend on infill and direction")};
}

}  // namespace

double rubber_poisson(double youngs) {
  return std::min(kLargestPoisson, 0.5 - youngs / (6.0 * kBulkModulus));
}

const std::vector<Elastomer>& elastomers() {
  static const std::vector<Elastomer> all = make_elastomers();
  return all;
}

const Elastomer& find_elastomer(std::string_view word) {
  std::string words;
  for (const Elastomer& one : elastomers()) {
    if (one.word == word) return one;
    words += (words.empty() ? "" : ", ") + one.word;
  }
  throw Error("", "preset", fmt::format("{} is unknown, there are {}", word, words));
}

}  // namespace taxel
