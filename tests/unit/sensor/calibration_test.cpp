// Calibration: every part compared with its closed form, the order of the parts, and random numbers that depend on seed
// and id.
#include "core/sensor/calibration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace taxel {
namespace {

using Values = std::vector<double>;

/// Returns a layout of taxels 10 mm apart along x with ids 0, 1, ...
Layout row_of_taxels(int count, const Calibration& calibration) {
  Layout layout;
  for (int i = 0; i < count; ++i) layout.taxels.push_back({i, "", dvec3(0.01 * i, 0, 0), dvec3(0, 0, 1), 0.004, {}});
  layout.calibration = calibration;
  return layout;
}

/// Returns the values that one taxel reports for these readings, one per millisecond.
Values reported(const Calibration& calibration, const Values& readings) {
  Calibrator calibrator(row_of_taxels(1, calibration));
  Values all;
  for (std::size_t i = 0; i < readings.size(); ++i)
    all.push_back(calibrator.advance(0.001 * static_cast<double>(i), {&readings[i], 1})[0]);
  return all;
}

TEST(Calibration, ChangesNothingWithoutParts) {
  const Values readings = {0, 1e-300, 123.456, 1e6, 0.1 + 0.2};
  EXPECT_EQ(reported({}, readings), readings);
}

TEST(Calibration, UsesThePlayOperatorForHysteresis) {
  Calibration c;
  c.hysteresis = {20, 1, {}};  // r = 10: x - 10 while rising, constant over the last 20, x + 10 while falling
  EXPECT_EQ(reported(c, {0, 5, 10, 50, 100, 95, 80, 50, 0, 5, 20, 40}),
            (Values{0, 0, 0, 40, 90, 90, 90, 60, 10, 10, 10, 30}));
  c.hysteresis->fraction = 0.25;  // x + (w - x) / 4
  EXPECT_EQ(reported(c, {0, 100, 80, 0}), (Values{0, 97.5, 82.5, 2.5}));
}

TEST(Calibration, EnclosesWidthTimesHeightInAHysteresisLoop) {
  Calibration c;
  c.hysteresis = {20, 1, {}};
  Values path;
  for (int i = 0; i <= 1000; ++i) path.push_back(0.1 * i);
  for (int i = 1000; i >= 0; --i) path.push_back(0.1 * i);
  path.insert(path.end(), path.begin(), path.end());  // the second cycle is closed
  const Values w = reported(c, path);
  double area = 0;
  for (std::size_t i = path.size() / 2 + 1; i < path.size(); ++i)
    area += 0.5 * (w[i] + w[i - 1]) * (path[i] - path[i - 1]);
  EXPECT_NEAR(-area, 20.0 * (100.0 - 20.0), 1e-9);
}

TEST(Calibration, DecreasesCrosstalkLinearlyWithDistance) {
  Calibration c;
  c.crosstalk = {0.5, 0.025};
  Calibrator calibrator(row_of_taxels(4, c));
  const Values readings = {100, 0, 0, 0};
  const Values v = calibrator.advance(0, readings);
  EXPECT_EQ(v[0], 100);
  EXPECT_NEAR(v[1], 100 * 0.5 * (1 - 10.0 / 25), 1e-12);
  EXPECT_NEAR(v[2], 100 * 0.5 * (1 - 20.0 / 25), 1e-12);
  EXPECT_EQ(v[3], 0);  // 30 mm away
}

TEST(Calibration, SubtractsTheTare) {
  Calibration c;
  c.tare = {false, 30};
  EXPECT_EQ(reported(c, {30, 100, 0}), (Values{0, 70, -30}));
  c.tare = {true, 0};
  EXPECT_EQ(reported(c, {40, 100, 0}), (Values{0, 60, -40}));
  c.taxels = {{.id = 0, .tare = 5, .gain = {}, .curve = {}, .dead = {}}};
  EXPECT_EQ(reported(c, {40, 100, 0}), (Values{35, 95, -5}));
}

TEST(Calibration, AppliesGainsAndCurvesPerTaxel) {
  Calibration c;
  c.gain = 2;
  c.taxels = {{.id = 1, .tare = {}, .gain = 3, .curve = {}, .dead = {}},
              {.id = 2, .tare = {}, .gain = {}, .curve = {{0, 1}, {10, 5}, {20, 6}}, .dead = {}}};
  Calibrator calibrator(row_of_taxels(3, c));
  const auto at = [&](double p) {
    const Values readings(3, p);
    return calibrator.advance(0, readings);
  };
  EXPECT_EQ(at(0), (Values{0, 0, 1}));
  EXPECT_EQ(at(5), (Values{10, 15, 3}));
  EXPECT_EQ(at(10), (Values{20, 30, 5}));
  EXPECT_EQ(at(15), (Values{30, 45, 5.5}));
  EXPECT_EQ(at(40), (Values{80, 120, 8}));    // the last segment is extrapolated
  EXPECT_EQ(at(-5), (Values{-10, -15, -1}));  // and so is the first
}

TEST(Calibration, ClipsToTheRange) {
  Calibration c;
  c.range = {-1, 5};
  EXPECT_EQ(reported(c, {-3, -1, 2.5, 5, 7}), (Values{-1, -1, 2.5, 5, 5}));
}

TEST(Calibration, QuantisesToTheNearestLevel) {
  Calibration c;
  c.quantisation = {0.25, {}};
  EXPECT_EQ(reported(c, {0.1, 0.13, -0.4, 7.6}), (Values{0, 0.25, -0.5, 7.5}));
  c.range = {1, 2.1};  // levels from the low end, none outside: 1, 1.25 ... 2
  EXPECT_EQ(reported(c, {0, 1.2, 2.09, 9}), (Values{1, 1.25, 2, 2}));
  c.range = {0, 0.3};  // 0.3 / 0.1 is slightly less than 3
  c.quantisation = {0.1, {}};
  EXPECT_NEAR(reported(c, {9})[0], 0.3, 1e-15);
  c.range = {0, 5};
  c.quantisation = {{}, 2};  // 0, 5/3, 10/3, 5
  const Values v = reported(c, {0.8, 0.9, 4.1, 4.2, 9});
  const Values expected = {0, 5.0 / 3, 10.0 / 3, 5, 5};
  for (std::size_t i = 0; i < v.size(); ++i) EXPECT_NEAR(v[i], expected[i], 1e-15) << i;
  EXPECT_LE(v.back(), 5);
}

TEST(Calibration, HasAUniformQuantisationError) {
  Calibration c;
  c.quantisation = {0.25, {}};
  Values readings;
  for (int i = 0; i < 20000; ++i) readings.push_back(0.001234567 * i);
  const Values v = reported(c, readings);
  double square = 0, largest = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    square += (v[i] - readings[i]) * (v[i] - readings[i]) / static_cast<double>(v.size());
    largest = std::max(largest, std::abs(v[i] - readings[i]));
  }
  EXPECT_NEAR(square, 0.25 * 0.25 / 12, 0.01 * 0.25 * 0.25 / 12);  // q^2 / 12
  EXPECT_LE(largest, 0.125 + 1e-12);
}

TEST(Calibration, HoldsValuesBetweenTicks) {
  Calibration c;
  c.rate = 250;  // every fourth millisecond
  EXPECT_EQ(reported(c, {1, 2, 3, 4, 5, 6, 7, 8, 9}), (Values{1, 1, 1, 1, 5, 5, 5, 5, 9}));
  c.rate = 1e5;  // faster than the readings, so no value is held
  EXPECT_EQ(reported(c, {1, 2, 3}), (Values{1, 2, 3}));
  // Times that are sums of steps miss no tick.
  c.rate = 100;
  Calibrator calibrator(row_of_taxels(1, c));
  double time = 0;
  for (int i = 0; i < 5000; ++i, time += 0.001) {
    const double reading = i;
    EXPECT_EQ(calibrator.advance(time, {&reading, 1})[0], i - i % 10) << i;
  }
}

TEST(Calibration, AddsNormalWhiteNoise) {
  Calibration c;
  c.noise = 2;
  const double n = 40000;
  const Values v = reported(c, Values(40000, 100));
  double mean = 0, square = 0, fourth = 0, next = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double x = (v[i] - 100) / 2;
    mean += x / n;
    square += x * x / n;
    fourth += x * x * x * x / n;
    if (i > 0) next += x * (v[i - 1] - 100) / 2 / n;
  }
  const double sigma = 1 / std::sqrt(n);
  EXPECT_NEAR(mean, 0, 4 * sigma);
  EXPECT_NEAR(square, 1, 4 * std::sqrt(2.0) * sigma);
  EXPECT_NEAR(fourth, 2.9, 4 * std::sqrt(96.0) * sigma);  // 3 - 6/5 / 12 for a sum of 12
  EXPECT_NEAR(next, 0, 4 * sigma);
}

TEST(Calibration, DrawsGainAndTareWithTheRequestedDeviations) {
  Calibration c;
  c.gain = 2;
  c.gain_deviation = 0.1;
  c.taxels = {{.id = 7, .tare = {}, .gain = 3, .curve = {}, .dead = {}}};
  const std::size_t n = 4000;
  const auto of_all = [&](double p) {
    Calibrator calibrator(row_of_taxels(static_cast<int>(n), c));
    return Values(calibrator.advance(0, Values(n, p)));
  };
  const auto deviation = [](const Values& v, double mean) {
    double sum = 0;
    for (const double x : v) sum += (x - mean) * (x - mean);
    return std::sqrt(sum / static_cast<double>(v.size()));
  };
  const Values gains = of_all(1);
  EXPECT_NEAR(deviation(gains, 2), 0.2, 0.01);
  EXPECT_EQ(gains[7], 3);  // the taxel's own gain, as measured
  c = {};
  c.tare = {false, 5};
  c.tare_deviation = 0.5;
  EXPECT_NEAR(deviation(of_all(0), -5), 0.5, 0.025);
}

TEST(Calibration, ReportsTheValueOfDeadTaxels) {
  Calibration c;
  c.dead = {0.25, -1};
  c.taxels = {{.id = 4, .tare = {}, .gain = {}, .curve = {}, .dead = 9}};
  const std::size_t n = 4000;
  Calibrator calibrator(row_of_taxels(static_cast<int>(n), c));
  const Values v = calibrator.advance(0, Values(n, 3));
  EXPECT_EQ(v[4], 9);
  const auto dead = std::count(v.begin(), v.end(), -1.0);
  EXPECT_NEAR(static_cast<double>(dead), 1000, 4 * std::sqrt(750));
  EXPECT_EQ(std::count(v.begin(), v.end(), 3.0) + dead + 1, 4000);
  EXPECT_EQ(calibrator.advance(1, Values(n, 8))[4], 9);
}

/// The order is hysteresis, crosstalk, tare, gain, noise, range, quantisation, hold, dead. Each pair shows which part
/// is first.
TEST(Calibration, AppliesPartsInTheDocumentedOrder) {
  const Values two = {100, 40};
  Calibration c;
  c.hysteresis = {20, 1, {}};  // 90 and 30
  c.crosstalk = {0.5, 0.02};
  const auto first = [&] { return Values(Calibrator(row_of_taxels(2, c)).advance(0, two)); };
  EXPECT_EQ(first()[0], 90 + 0.25 * 30);  // crosstalk first would give 100 + 10 - 10
  c.tare = {false, 7.5};
  EXPECT_EQ(first()[0], 90);
  c.gain = 2;
  EXPECT_EQ(first()[0], 180);  // gain first would give 195 - 7.5
  c.tare = {true, 0};
  EXPECT_EQ(first(), (Values{0, 0}));  // the tare is measured after hysteresis and crosstalk
  c.tare = {false, 7.5};
  c.noise = 1000;
  c.range = {0.5, 180.2};
  const Values noisy = reported(c, Values(200, 100));
  EXPECT_EQ(*std::max_element(noisy.begin(), noisy.end()), 180.2);  // the range clips the noise
  EXPECT_EQ(*std::min_element(noisy.begin(), noisy.end()), 0.5);
  c.quantisation = {1, {}};
  const Values levels = reported(c, Values(200, 100));
  EXPECT_EQ(*std::max_element(levels.begin(), levels.end()), 179.5);  // clipped, then the nearest level in the range
  c.rate = 100;
  const Values held = reported(c, Values(200, 100));
  for (std::size_t i = 0; i < held.size(); ++i) EXPECT_EQ(held[i], held[i - i % 10]) << i;  // the noise is held
  c.dead = {1, 1e6};
  EXPECT_EQ(first(), (Values{1e6, 1e6}));  // not clipped
}

TEST(Calibration, KeepsTheCrosstalkOfADeadTaxel) {
  Calibration c;
  c.crosstalk = {0.5, 0.02};
  c.taxels = {{.id = 0, .tare = {}, .gain = {}, .curve = {}, .dead = 0}};
  Calibrator calibrator(row_of_taxels(2, c));
  EXPECT_EQ(calibrator.advance(0, Values{100, 0}), (Values{0, 25}));
}

TEST(Calibration, ContinuesHysteresisLoopsBetweenTicks) {
  Calibration c;
  c.hysteresis = {20, 1, {}};
  c.rate = 500;
  // The hysteresis includes the peak in between, although the peak was never reported.
  EXPECT_EQ(reported(c, {0, 100, 50})[2], 60);
}

/// Returns a calibration with all parts that are random or have a state.
Calibration everything() {
  Calibration c;
  c.seed = 7;
  c.hysteresis = {5, 0.5, {}};
  c.crosstalk = {0.3, 0.025};
  c.tare = {true, 0};
  c.tare_deviation = 3;
  c.gain = 0.5;
  c.gain_deviation = 0.1;
  c.noise = 0.7;
  c.rate = 300;
  c.dead = {0.1, 0};
  return c;
}

double reading_of(int id, int step) {
  return 50 + 40 * std::sin(0.3 * step + id);
}

/// Returns the values by id of ten taxels after some readings. `order` is the order of the taxels in the layout.
std::vector<Values> by_id(Layout layout, const std::vector<int>& order) {
  std::vector<Taxel> taxels;
  for (const int id : order) taxels.push_back(layout.taxels[static_cast<std::size_t>(id)]);
  layout.taxels = taxels;
  Calibrator calibrator(layout);
  std::vector<Values> rows;
  for (int step = 0; step < 20; ++step) {
    Values readings, row(order.size());
    for (const int id : order) readings.push_back(reading_of(id, step));
    const Values& values = calibrator.advance(0.002 * step, readings);
    for (std::size_t i = 0; i < order.size(); ++i) row[static_cast<std::size_t>(order[i])] = values[i];
    rows.push_back(row);
  }
  return rows;
}

TEST(Calibration, DependsOnIdsAndNotOnTheOrderOfTaxels) {
  const Layout layout = row_of_taxels(10, everything());
  EXPECT_EQ(by_id(layout, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}), by_id(layout, {9, 3, 0, 7, 1, 8, 2, 6, 5, 4}));
}

TEST(Calibration, DependsOnTheSeed) {
  const std::vector<int> order = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  Layout layout = row_of_taxels(10, everything());
  const auto once = by_id(layout, order);
  EXPECT_EQ(by_id(layout, order), once);
  layout.calibration->seed = 8;
  EXPECT_NE(by_id(layout, order), once);
}

TEST(Calibration, DrawsTheSameNoiseOnEveryMachine) {
  Calibration c;
  c.noise = 1;
  // The sum of 12 numbers of SplitMix64, computed independently in integers, minus 6.
  EXPECT_EQ(reported(c, {0, 0}), (Values{-0.357153389596623, 0.9517159131941487}));
}

TEST(Calibration, DrawsFromASeparateStreamForEachPart) {
  Calibration noise;
  noise.noise = 1;
  Calibration both = noise;
  both.dead = {0, 0};
  both.rate = 1000;
  const Values readings = {1, 2, 3};
  EXPECT_EQ(reported(noise, readings), reported(both, readings));
  both.gain_deviation = 0.1;
  EXPECT_NE(reported(noise, readings), reported(both, readings));
}

TEST(Calibration, RestartsOnReset) {
  Calibrator calibrator(row_of_taxels(3, everything()));
  const auto run = [&] {
    std::vector<Values> rows;
    for (int step = 0; step < 10; ++step)
      rows.push_back(calibrator.advance(0.002 * step, Values{reading_of(0, step), reading_of(1, step), 0}));
    return rows;
  };
  const auto first = run();
  calibrator.reset();
  EXPECT_EQ(run(), first);
}

TEST(Calibration, KeepsTheRawReadings) {
  Calibrator calibrator(row_of_taxels(3, everything()));
  const Values raw = {1, 2, 3};
  Values readings = raw;
  EXPECT_NE(calibrator.advance(0, readings), raw);
  EXPECT_EQ(readings, raw);
}

TEST(Calibration, RefusesInvalidValues) {
  Calibrator calibrator(row_of_taxels(2, {}));
  EXPECT_THROW(calibrator.advance(0, Values{1}), Error);
  calibrator.advance(1, Values{1, 2});
  calibrator.advance(1, Values{1, 2});
  EXPECT_THROW(calibrator.advance(0.5, Values{1, 2}), Error);
  EXPECT_THROW(calibrator.advance(std::nan(""), Values{1, 2}), Error);
  calibrator.reset();
  EXPECT_EQ(calibrator.advance(0, Values{1, 2}), (Values{1, 2}));
}

}  // namespace
}  // namespace taxel
