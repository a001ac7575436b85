// The stages of the chain of a taxel that depend on time, compared with closed forms; their order; restored states.
#include "core/sensor/chain/chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/base/error.h"
#include "core/sensor/calibration.h"

namespace taxel {
namespace {

using Numbers = std::vector<double>;
using Complex = std::complex<double>;

/// Returns a layout of taxels 10 mm apart along x with ids 0, 1, ...
Layout line_of_taxels(int count, const Calibration& calibration) {
  Layout layout;
  for (int i = 0; i < count; ++i) layout.taxels.push_back({i, "", dvec3(0.01 * i, 0, 0), dvec3(0, 0, 1), 0.004, {}});
  layout.calibration = calibration;
  return layout;
}

/// Returns the values that one taxel reports for readings at these times.
Numbers values_at(const Calibration& calibration, const Numbers& times, const Numbers& readings) {
  Calibrator calibrator(line_of_taxels(1, calibration), 0.001);
  Numbers all;
  for (std::size_t i = 0; i < times.size(); ++i) all.push_back(calibrator.advance(times[i], {&readings[i], 1})[0]);
  return all;
}

/// Returns count times from 0 on, with the time step h.
Numbers every(double h, int count) {
  Numbers times;
  for (int i = 0; i < count; ++i) times.push_back(h * i);
  return times;
}

/// Returns the values for readings every millisecond.
Numbers values_of(const Calibration& calibration, const Numbers& readings) {
  return values_at(calibration, every(0.001, static_cast<int>(readings.size())), readings);
}

/// Returns uneven times from 0 on.
Numbers uneven_times() {
  Numbers times = {0};
  for (int i = 1; i < 400; ++i) times.push_back(times.back() + 0.001 * (1 + i % 7) * (i % 50 == 0 ? 100 : 1));
  return times;
}

/// Returns the readings x(t) at these times.
template <class X>
Numbers sampled(const Numbers& times, const X& x) {
  Numbers readings;
  for (const double t : times) readings.push_back(x(t));
  return readings;
}

template <class Y>
void expect_values(const Numbers& values, const Numbers& times, const Y& y, double tolerance) {
  ASSERT_EQ(values.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(values[i], y(times[i]), tolerance) << times[i];
}

const std::vector<RelaxationArm> kArms = {{0.12, 0.8}, {0.17, 5.5}};

Calibration relaxing() {
  Calibration c;
  c.relaxation = kArms;
  return c;
}

TEST(Chain, RelaxesAStepByTwoExponentials) {
  const Numbers times = uneven_times();
  const auto closed = [](double t) { return 1 - 0.12 * (1 - std::exp(-t / 0.8)) - 0.17 * (1 - std::exp(-t / 5.5)); };
  expect_values(values_at(relaxing(), times, Numbers(times.size(), 1)), times, closed, 1e-12);
  // Two readings at the same time are a step too.
  Numbers later = {0, 2, 2}, readings = {0, 0, 1};
  for (const double t : times) later.push_back(2 + t), readings.push_back(1);
  const Numbers values = values_at(relaxing(), later, readings);
  expect_values(Numbers(values.begin() + 3, values.end()), times, closed, 1e-12);
}

TEST(Chain, RelaxesDuringARampAndAHoldExactly) {
  const Numbers times = uneven_times();
  const double end = times[200];
  const auto x = [&](double t) { return 3 * std::min(t, end); };
  const auto closed = [&](double t) {
    double y = x(t);
    for (const auto& [a, tau] : kArms) {
      const double s = std::min(t, end), at_end = 3 * a * (s - tau * (1 - std::exp(-s / tau)));
      const double decay = std::exp(-(t - s) / tau);
      y -= at_end * decay + a * 3 * end * (1 - decay);
    }
    return y;
  };
  expect_values(values_at(relaxing(), times, sampled(times, x)), times, closed, 3 * end * 1e-12);
}

/// Returns the response of a filter with z_0 = 0 and z_n = e z_n-1 + u_n to a sine of frequency w, whose gain is H.
double driven(const Complex& gain, double e, double w, double h, double t) {
  return std::imag(gain * std::polar(1.0, w * t)) - std::imag(gain) * std::pow(e, std::round(t / h));
}

TEST(Chain, RelaxesASineByItsTransferFunction) {
  const double w = 9, h = 0.002;
  const Numbers times = every(h, 3000);
  const auto x = [&](double t) { return std::sin(w * t); };
  const auto closed = [&](double t) {
    double y = x(t);
    for (const auto& [a, tau] : kArms) {
      const double q = h / tau, e = std::exp(-q), f = (1 - e) / q;
      const Complex late = std::polar(1.0, -w * h);  // of the previous reading; straight lines between readings
      y -= driven(a * ((1 - f) + (f - e) * late) / (1.0 - e * late), e, w, h, t);
    }
    return y;
  };
  expect_values(values_at(relaxing(), times, sampled(times, x)), times, closed, 1e-12);
}

/// Between readings the load is taken as straight, so the error for a smooth load falls with the square of the step.
TEST(Chain, ApproachesTheRelaxationOfASmoothSine) {
  const double w = 9;
  const auto largest_error = [&](double h) {
    const Numbers times = every(h, static_cast<int>(std::round(6 / h)));
    const Numbers values = values_at(relaxing(), times, sampled(times, [&](double t) { return std::sin(w * t); }));
    double largest = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      double y = std::sin(w * times[i]);
      for (const auto& [a, tau] : kArms)  // of tau dz/dt = a sin(w t) - z
        y -= a * (std::sin(w * times[i]) - w * tau * (std::cos(w * times[i]) - std::exp(-times[i] / tau))) /
             (1 + w * w * tau * tau);
      largest = std::max(largest, std::abs(values[i] - y));
    }
    return largest;
  };
  const double coarse = largest_error(0.01), fine = largest_error(0.005);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_NEAR(coarse / fine, 4, 0.2);
}

Calibration filtered() {
  Calibration c;
  c.low_pass = {0.03, {}};
  return c;
}

TEST(Chain, FiltersStepsExactly) {
  const Numbers times = uneven_times();
  const double on = times[20], off = times[150];
  const auto closed = [&](double t) {
    const double up = t < on ? 0 : 1 - std::exp(-(t - on) / 0.03);
    return t < off ? up : up - (1 - std::exp(-(t - off) / 0.03));
  };
  const Numbers readings = sampled(times, [&](double t) { return t >= on && t < off ? 1 : 0; });
  expect_values(values_at(filtered(), times, readings), times, closed, 1e-12);
}

TEST(Chain, FiltersARampAndASineOfHeldReadingsExactly) {
  const double h = 0.004, w = 40, e = std::exp(-h / 0.03);
  const Numbers times = every(h, 2000);
  // y_n = e y_n-1 + (1 - e) h (n - 1) has the solution h (n - c) + h c e^n, c = 1 / (1 - e).
  expect_values(
      values_at(filtered(), times, times), times,
      [&](double t) { return t - h / (1 - e) * (1 - std::pow(e, std::round(t / h))); }, 1e-11);
  const Complex late = std::polar(1.0, -w * h);
  expect_values(
      values_at(filtered(), times, sampled(times, [&](double t) { return std::sin(w * t); })), times,
      [&](double t) { return driven((1 - e) * late / (1.0 - e * late), e, w, h, t); }, 1e-12);
}

TEST(Chain, HalvesThePowerAtTheCutoff) {
  Calibration c;
  c.low_pass = {{}, 5};
  const Numbers times = every(1e-5, 100000);
  const Numbers values =
      values_at(c, times, sampled(times, [](double t) { return std::sin(2 * std::numbers::pi * 5 * t); }));
  EXPECT_NEAR(*std::max_element(values.end() - 20000, values.end()), std::sqrt(0.5), 2e-4);
}

TEST(Chain, HoldsAFilteredReadingOfAConstantLoad) {
  const Numbers values = values_at(filtered(), {0, 100, 100.5, 1e6}, {7, 7, 7, 7});
  EXPECT_EQ(values, (Numbers{0, 7, 7, 7}));
}

TEST(Chain, AddsPlayOperators) {
  Calibration c;
  c.hysteresis = {20, 0.25, {{40, 0.5}}};
  // Of 0, 100, 80, 0, 50 the operators of 10 and 20 make 0, 90, 90, 10, 40 and 0, 80, 80, 20, 30.
  EXPECT_EQ(values_of(c, {0, 100, 80, 0, 50}), (Numbers{0, 100 - 2.5 - 10, 80 + 2.5, 2.5 + 10, 50 - 2.5 - 10}));
  c.hysteresis = {20, 0.25, {{0, 0.5}}};  // a play without width is the reading
  EXPECT_EQ(values_of(c, {0, 100, 80}), (Numbers{0, 97.5, 82.5}));
}

TEST(Chain, RespondsByAPolynomialWithTangents) {
  Calibration c;
  c.response = {{2, -0.5}, 1.5, {}};  // 2 x - x^2 / 2: slope 2 at 0 and 0.5 at 1.5
  EXPECT_EQ(values_of(c, {-1, 0, 1, 1.5, 2.5}), (Numbers{-2, 0, 1.5, 1.875, 2.375}));
  c.response = {{1, 0, 0, 0.25}, 4, {}};
  EXPECT_EQ(values_of(c, {2, 4, 5}), (Numbers{6, 68, 68 + 65}));
  c.response = {{}, 0, {{0, 0}, {10, 20}, {20, 25}}};
  EXPECT_EQ(values_of(c, {-1, 5, 10, 14, 30}), (Numbers{-2, 10, 20, 22, 30}));
}

TEST(Chain, MultipliesByTheCrosstalkMatrix) {
  Calibration c;
  c.crosstalk_matrix = {{1, 0.5, 0}, {0, 2, -0.25}, {0.125, 0, 1}};
  Calibrator calibrator(line_of_taxels(3, c));
  EXPECT_EQ(calibrator.advance(0, Numbers{8, 16, 32}), (Numbers{16, 24, 33}));
}

TEST(Chain, DelaysByTheLatencyToTheNearestStep) {
  const Numbers readings = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  Calibration c;
  for (const double latency : {0.0026, 0.003, 0.0034}) {
    c.latency = latency;
    EXPECT_EQ(values_of(c, readings), (Numbers{1, 1, 1, 1, 2, 3, 4, 5, 6})) << latency;
  }
  c.latency = 0.0004;
  EXPECT_EQ(values_of(c, readings), readings);
  c.latency = 0.003;
  EXPECT_THROW(Calibrator(line_of_taxels(1, c)), Error) << "the time step is unknown";
  c.latency = 100;
  EXPECT_THROW(Calibrator(line_of_taxels(1, c), 0.001), Error) << "the state would take much memory";
}

/// The correlation of two lists of numbers with mean 0 and variance 1.
double correlation(const Numbers& a, const Numbers& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum / static_cast<double>(a.size());
}

TEST(Chain, DrawsIndependentNoiseByTaxelStepAndSeed) {
  Calibration c;
  c.noise = 1;
  const int n = 20000;
  const auto noise_of = [&](std::uint64_t seed) {
    c.seed = seed;
    Calibrator calibrator(line_of_taxels(3, c));
    std::vector<Numbers> taxels(3);
    for (int i = 0; i < n; ++i) {
      const Numbers& values = calibrator.advance(0.001 * i, Numbers(3));
      for (std::size_t k = 0; k < 3; ++k) taxels[k].push_back(values[k]);
    }
    return taxels;
  };
  std::vector<Numbers> all = noise_of(1);
  for (const Numbers& other : noise_of(2)) all.push_back(other);
  const Numbers shifted(all[0].begin() + 1, all[0].end());
  const double four_sigma = 4 / std::sqrt(n);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      EXPECT_NEAR(correlation(all[i], all[j]), i == j ? 1 : 0, (i == j ? 1.5 : 1) * four_sigma) << i << ' ' << j;
  EXPECT_NEAR(correlation(shifted, all[0]), 0, four_sigma);
}

/// Each pair of stages shows which one is first.
TEST(Chain, AppliesStagesInTheDocumentedOrder) {
  Calibration c;
  c.response = {{0, 1}, 100, {}};  // x^2
  c.hysteresis = {2, 1, {}};
  EXPECT_EQ(values_of(c, {3})[0], 9 - 1);              // the play first would give 4
  c.relaxation = {{0.5, 1e-9}};                        // half is lost after the first reading
  EXPECT_EQ(values_of(c, {3, 3}), (Numbers{8, 5.5}));  // 4.5 + 1; relaxation first: 3.25, behind the play: 4
  c.relaxation.clear();
  c.low_pass = {0.001 / std::numbers::ln2, {}};    // half way in a step
  EXPECT_NEAR(values_of(c, {3, 3})[1], 4, 1e-12);  // the filter before the play would give 3.5
  c.low_pass = {1e-9, {}};                         // the previous reading
  c.hysteresis.reset();
  c.response.reset();
  c.tare = {true, 0};
  EXPECT_EQ(values_of(c, {5, 5}), (Numbers{0, 5}));  // the tare is measured behind the filter
  c.tare.reset();
  c.range = {1, 4};
  EXPECT_EQ(values_of(c, {5, 5}), (Numbers{1, 4}));
  c = {};
  c.quantisation = {2.0, {}};
  c.rate = 250;
  c.latency = 0.001;
  EXPECT_EQ(values_of(c, {1, 3, 5, 7, 9.5, 9}), (Numbers{2, 2, 2, 2, 2, 10}));
  c.dead = {1, 7};
  EXPECT_EQ(values_of(c, {1, 3}), (Numbers{7, 7}));
}

/// Returns a calibration with all stages that have a state or random numbers.
Calibration whole_chain() {
  Calibration c;
  c.seed = 3;
  c.response = {{1, 1e-3}, 200, {}};
  c.relaxation = kArms;
  c.hysteresis = {5, 0.4, {{20, 0.3}}};
  c.low_pass = {0.004, {}};
  c.crosstalk = {0.3, 0.025};
  c.tare = {true, 0};
  c.gain = 0.5;
  c.gain_deviation = 0.1;
  c.noise = 0.7;
  c.range = {-20, 90};
  c.quantisation = {{}, 10};
  c.rate = 300;
  c.latency = 0.005;
  return c;
}

Numbers loads(int step) {
  return {50 + 40 * std::sin(0.05 * step), 30 * std::cos(0.11 * step), step % 100 < 50 ? 60.0 : 0.0};
}

TEST(Chain, RepeatsItsBitsFromEachRestoredState) {
  Calibrator calibrator(line_of_taxels(3, whole_chain()), 0.001);
  const int steps = 1000, more = 12;
  std::vector<Numbers> states, values;
  for (int i = 0; i < steps + more; ++i) {
    states.push_back(calibrator.state());
    values.push_back(calibrator.advance(0.001 * i, loads(i)));
  }
  Calibrator other(line_of_taxels(3, whole_chain()), 0.001);
  for (int i = 0; i < steps; ++i) {
    const int from = i * 617 % steps;  // in another order
    other.restore(states[static_cast<std::size_t>(from)]);
    for (int j = from; j < from + more; ++j)
      ASSERT_EQ(other.advance(0.001 * j, loads(j)), values[static_cast<std::size_t>(j)]) << from << ' ' << j;
  }
  EXPECT_NE(values[700], values[701 - 100]);
}

TEST(Chain, BeginsWithAStateOfZeros) {
  const Chain chain(line_of_taxels(3, whole_chain()), 0.001);
  const Numbers zeros(chain.state_size());
  Calibrator calibrator(line_of_taxels(3, whole_chain()), 0.001);
  EXPECT_EQ(calibrator.state(), zeros);
  EXPECT_TRUE(Chain::is_new(zeros));
  for (int i = 0; i < 10; ++i) calibrator.advance(0.001 * i, loads(i));
  EXPECT_FALSE(Chain::is_new(calibrator.state()));
  EXPECT_DOUBLE_EQ(Chain::time_of(calibrator.state()), 0.009);
  calibrator.reset();
  EXPECT_EQ(calibrator.state(), zeros);
}

TEST(Chain, RefusesStatesOfAnotherChain) {
  Calibrator calibrator(line_of_taxels(3, whole_chain()), 0.001);
  Numbers state = calibrator.state();
  state.push_back(0);
  EXPECT_THROW(calibrator.restore(state), Error);
  state.pop_back();
  state.back() = std::nan("");
  EXPECT_THROW(calibrator.restore(state), Error);
}

}  // namespace
}  // namespace taxel
