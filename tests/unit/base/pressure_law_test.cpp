// The pressure laws against quadrature, their inverse and continuation, their broken rules, and their levels.
#include "core/base/pressure_law.h"

#include <gtest/gtest.h>

#include <cmath>

namespace taxel {
namespace {

const PressureLaw kStiffening{LawKind::stiffening, 0.78, {}};
const PressureLaw kTable{LawKind::table, 0, {{0.2, 0.1}, {0.5, 0.5}, {0.9, 2}}};

TEST(PressureLaw, HasTheEnergyGradientAndInverseOfQuadrature) {
  for (const PressureLaw& law : {PressureLaw{}, kStiffening, kTable, PressureLaw{LawKind::stiffening, 1e-9, {}}}) {
    for (const double end : {0.1, 0.35, 0.7, 1.0, 1.4}) {
      double sum = 0;
      constexpr int kParts = 200000;
      for (int i = 0; i < kParts; ++i) sum += law.pressure(end * (i + 0.5) / kParts) * end / kParts;
      EXPECT_NEAR(law.energy(end), sum, 1e-8 * sum) << end;
      constexpr double h = 1e-6;
      const double slope = (law.pressure(end + h) - law.pressure(end - h)) / (2 * h);
      EXPECT_NEAR(law.gradient(end), slope, 1e-5 * slope) << end;
      EXPECT_LE(law.slopes().least, slope * (1 + 1e-5));
      EXPECT_GE(law.slopes().most, slope * (1 - 1e-5));
      EXPECT_NEAR(law.strain(law.pressure(end)), end, 1e-14) << end;
    }
    EXPECT_EQ(law.pressure(0), 0);
    EXPECT_EQ(law.energy(-1), 0);
    EXPECT_EQ(law.strain(-1), 0);
  }
  EXPECT_NEAR(kStiffening.pressure(0.5), 0.5 / 0.61, 1e-15);
}

TEST(PressureLaw, NamesTheBrokenRule) {
  std::string place;
  EXPECT_EQ(law_problem(kStiffening), "");
  EXPECT_EQ(law_problem(kTable), "");
  EXPECT_NE(law_problem({LawKind::stiffening, 1, {}}, &place).find("infinite at the strain 1/k, is 1"),
            std::string::npos);
  EXPECT_EQ(place, "/stiffening");
  EXPECT_NE(law_problem({LawKind::stiffening, std::nan(""), {}}), "");
  EXPECT_NE(law_problem({LawKind::table, 0, {{1, 1}}}, &place).find("2 rows or more, has 1"), std::string::npos);
  EXPECT_EQ(place, "/table");
  EXPECT_NE(law_problem({LawKind::table, 0, {{0.5, 1}, {1, 0.9}}}, &place).find("falls"), std::string::npos);
  EXPECT_EQ(place, "/table/1/1");
  EXPECT_NE(law_problem({LawKind::table, 0, {{0.5, 1}, {0.5, 2}}}, &place).find("strain of the row before"),
            std::string::npos);
  EXPECT_EQ(place, "/table/1/0");
}

TEST(PressureLaw, HasLevelsOfEvenError) {
  EXPECT_TRUE(law_levels({}, 4).empty());
  EXPECT_TRUE(law_levels({LawKind::stiffening, 0, {}}, 4).empty());
  EXPECT_EQ(law_levels(kTable, 4), (std::vector<double>{0.2, 0.5})) << "the points at which it bends";
  PressureLaw straight{LawKind::table, 0, {}};
  for (int i = 1; i <= 256; ++i) straight.table.push_back({i / 256.0, i / 256.0});
  EXPECT_TRUE(law_levels(straight, 4).empty());
  PressureLaw fine{LawKind::table, 0, {}};
  for (int i = 1; i <= 200; ++i) fine.table.push_back({i / 200.0, kStiffening.pressure(i / 200.0)});
  for (const PressureLaw& law : {kStiffening, fine}) {
    std::vector<double> ends = law_levels(law, 4);
    ASSERT_EQ(ends.size(), 4U);
    ends.push_back(1);
    double begin = 0;
    for (const double end : ends) {
      double worst = 0;
      for (double e = begin; e < end; e += 1e-3) {
        const double t = (e - begin) / (end - begin);
        const double line = (1 - t) * law.pressure(begin) + t * law.pressure(end);
        worst = std::max(worst, std::abs(line - law.pressure(e)) / law.pressure(end));
      }
      EXPECT_LT(worst, 0.08) << begin << " to " << end;
      begin = end;
    }
  }
}

}  // namespace
}  // namespace taxel
