#include "core/hydro/material/elastomers.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/hydro/material/hardness.h"

namespace taxel {
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
