// The parameters of a fit, its subject, and its result.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/text/words.h"
#include "core/run/fit/pressed_recording.h"
#include "core/sensor/contact_case/contact_case.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Names of parameters. `radius` is that of all taxels, `object_radius` the first size of the case's shape, `thickness`
/// that of the layout's material and `k` the value of its law {"stiffening": k}. x0, y0 and z0 are added to the
/// displacements of one recording, whose zero they are; `gain` is the factor of each taxel.
enum class FitName { radius, object_radius, thickness, k, x0, y0, z0, gain };

/// A value of the user for a parameter, for all recordings.
struct FitValue {
  FitName name = FitName::radius;
  double value = 0;
};

/// A parameter that varied, with its result. Its unit is that of unit_of().
struct FittedParameter {
  FitName name = FitName::radius;
  std::optional<std::size_t> run;  ///< recording, for x0, y0 and z0
  double value = 0;
  double standard_error = 0;  ///< for independent errors; infinity if nothing depends on it
  double start = 0, lower = 0, upper = 0;
};

/// How well a taxel of a recording is described. Errors are those of recorded - gain * simulated.
struct TaxelAgreement {
  int taxel = 0;
  std::string column;
  double gain = 1;  ///< [unit of the recording / unit of the reading]
  std::size_t points = 0;
  double r2 = 0;     ///< 1 - squares of errors / squares about the mean
  double rms = 0;    ///< root mean square error over the largest recorded value of the recording
  double worst = 0;  ///< largest error over the same
  double width_measured = 0, width_fitted = 0;  ///< bells at half height [m], or NaN
};

/// One row of a taxel of a recording.
struct FitPoint {
  std::size_t press = 0, row = 0;
  dvec3 displacement{0};  ///< with the fitted zero [m]
  std::size_t taxel = 0;  ///< index in the recording
  double measured = 0;    ///< without the baseline, unit of the recording
  double fitted = 0;
};

/// How well a recording is described.
struct RunAgreement {
  bool is_held_out = false;
  dvec3 zero{0};                     ///< x0, y0 and z0 [m]
  std::size_t untouched_points = 0;  ///< points whose simulated reading is 0
  double largest = 0;                ///< largest size of a recorded value, without its baseline
  double r2 = 0, rms = 0, worst = 0;
  std::vector<TaxelAgreement> taxels;
  std::vector<FitPoint> points;
};

/// Parameters that the recordings do not tell apart.
struct Undecided {
  std::vector<std::size_t> parameters;  ///< indices in RecordingFit::parameters
  double correlation = 0;               ///< 1 for a parameter on which nothing depends
  std::string advice;                   ///< a sentence: which measurement would decide
};

struct RecordingFit {
  std::vector<FittedParameter> parameters;
  std::vector<std::vector<double>> correlations;  ///< between parameters, with free gains allowed for
  std::vector<RunAgreement> runs;                 ///< fitted recordings, then held-out ones
  std::vector<Undecided> undecided;
};

/// A sensor and an object that is displaced from its pose in the case.
struct FitSubject {
  SensorSource sensor;
  ContactCase contact_case;
};

/// The words of parameters in files and options.
inline constexpr Word<FitName> kFitNameWords[] = {{FitName::radius, "radius"},
                                                  {FitName::object_radius, "object.radius"},
                                                  {FitName::thickness, "thickness"},
                                                  {FitName::k, "k"},
                                                  {FitName::x0, "x0"},
                                                  {FitName::y0, "y0"},
                                                  {FitName::z0, "z0"},
                                                  {FitName::gain, "gain"}};
inline std::span<const Word<FitName>> words_of(FitName /*unused*/) {
  return kFitNameWords;
}

/// Returns the unit of a parameter: "m", or "" for k and gain.
inline std::string_view unit_of(FitName name) {
  return name == FitName::k || name == FitName::gain ? "" : "m";
}

/// Correlation of two parameters above which they are undecided.
inline constexpr double kUndecided = 0.98;

}  // namespace taxel
