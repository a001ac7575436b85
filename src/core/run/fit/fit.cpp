#include "core/run/fit/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/run/fit/agreement.h"
#include "core/run/fit/fit_model.h"
#include "core/run/fit/least_squares.h"

namespace taxel {

namespace {

constexpr std::size_t kCoarseRows = 200, kFineRows = 1000;  // of all recordings, for starts and for the result
constexpr int kCoarseSteps = 10, kFineSteps = 15;
constexpr double kFactor = 4;  // bounds of a length, in starts
constexpr double kMostK = 0.95;

bool is_geometry(FitName name) {
  return name <= FitName::k;
}
int axis_of(FitName name) {
  return static_cast<int>(name) - static_cast<int>(FitName::x0);
}

/// One recording with the rows that are compared.
struct ComparedRun {
  const PressedRecording* recording = nullptr;
  std::vector<std::size_t> places;  // of its taxels in the layout
  std::vector<FitRow> rows;
  double largest = 0;
};

ComparedRun compared_run(const PressedRecording& recording, const FitModel& model) {
  ComparedRun run{&recording, {}, {}, 0};
  for (const int taxel : recording.taxel_ids) run.places.push_back(model.place_of(taxel, recording.file));
  for (std::size_t p = 0; p < recording.presses.size(); ++p)
    for (std::size_t r = recording.presses[p].first; r < recording.presses[p].end; ++r) run.rows.push_back({p, r});
  for (const FitRow& row : run.rows)
    for (std::size_t t = 0; t < run.places.size(); ++t) {
      const double value = measured_at(recording, row, t);
      if (!std::isnan(value)) run.largest = std::max(run.largest, std::abs(value));
    }
  if (!(run.largest > 0)) throw Error(recording.file, "no taxel responds to a press");
  return run;
}

/// Returns at most `most` of the rows, evenly.
std::vector<FitRow> thinned(const std::vector<FitRow>& rows, std::size_t most) {
  const std::size_t step = std::max<std::size_t>(1, (rows.size() + most - 1) / std::max<std::size_t>(most, 1));
  std::vector<FitRow> out;
  for (std::size_t i = 0; i < rows.size(); i += step) out.push_back(rows[i]);
  return out;
}

/// The residuals of some recordings as a function of the parameters, without the gains: residual = (recorded - gain *
/// simulated) / largest recorded, where each gain is the best one for the other parameters.
class Residuals {
 public:
  Residuals(FitModel& model, std::vector<ComparedRun>& runs, const RecordingFitOptions& options,
            const std::vector<FittedParameter>& parameters)
      : model_(model), runs_(runs), options_(options), parameters_(parameters) {
    for (const FitName name : options.free) has_gain_ = has_gain_ || name == FitName::gain;
    for (const FitValue& value : options.values) {
      if (is_geometry(value.name))
        given_[static_cast<std::size_t>(value.name)] = value.value;
      else if (value.name != FitName::gain)
        zero_[axis_of(value.name)] = value.value;
      else
        gain_ = value.value;
    }
  }

  void take_rows(std::size_t most) {
    std::size_t all = 0;
    for (const ComparedRun& run : runs_) all += run.rows.size();
    rows_.clear();
    for (const ComparedRun& run : runs_)
      rows_.push_back(
          thinned(run.rows, std::max<std::size_t>(1, most * run.rows.size() / std::max<std::size_t>(all, 1))));
  }

  [[nodiscard]] FitGeometry geometry(const Eigen::VectorXd& p) const {
    FitGeometry geometry = given_;
    for (std::size_t i = 0; i < parameters_.size(); ++i)
      if (is_geometry(parameters_[i].name))
        geometry[static_cast<std::size_t>(parameters_[i].name)] = p[Eigen::Index(i)];
    return geometry;
  }
  [[nodiscard]] dvec3 zero(const Eigen::VectorXd& p, std::size_t run) const {
    dvec3 zero = zero_;
    for (std::size_t i = 0; i < parameters_.size(); ++i)
      if (parameters_[i].run == run) zero[axis_of(parameters_[i].name)] = p[Eigen::Index(i)];
    return zero;
  }

  /// Simulated readings of the rows of a recording, of its taxels, row by row.
  [[nodiscard]] std::vector<double> simulated(const Eigen::VectorXd& p, std::size_t run) {
    std::vector<dvec3> displacements;
    const dvec3 at = zero(p, run);
    for (const FitRow& row : rows_[run]) displacements.push_back(runs_[run].recording->displacements[row.row] + at);
    const PoseReadings all = model_.read(geometry(p), displacements);
    std::vector<double> out;
    for (std::size_t i = 0; i < displacements.size(); ++i)
      for (const std::size_t place : runs_[run].places)
        out.push_back(all.readings[i * static_cast<std::size_t>(all.taxels) + place]);
    return out;
  }

  /// The gains of each recording that fit best.
  using Gains = std::vector<std::vector<double>>;
  [[nodiscard]] Gains gains_of(const std::vector<std::vector<double>>& simulated) const {
    Gains gains;
    for (const ComparedRun& run : runs_) gains.emplace_back(run.places.size(), gain_);
    if (!has_gain_) return gains;
    std::map<std::pair<std::size_t, int>, dvec2> sums;  // recorded * simulated, and simulated squared
    visit([&](std::size_t r, std::size_t t, std::size_t i, double recorded, double weight) {
      dvec2& sum = sums[group(r, t)];
      sum += weight * weight * simulated[r][i] * dvec2(recorded, simulated[r][i]);
    });
    for (std::size_t r = 0; r < runs_.size(); ++r)
      for (std::size_t t = 0; t < gains[r].size(); ++t)
        if (const dvec2 sum = sums[group(r, t)]; sum.y > 0) gains[r][t] = sum.x / sum.y;
    return gains;
  }

  [[nodiscard]] std::vector<std::vector<double>> all_simulated(const Eigen::VectorXd& p) {
    std::vector<std::vector<double>> out;
    for (std::size_t r = 0; r < runs_.size(); ++r) out.push_back(simulated(p, r));
    return out;
  }

  [[nodiscard]] Eigen::VectorXd residuals(const Eigen::VectorXd& p) {
    const auto values = all_simulated(p);
    const Gains gains = gains_of(values);
    Eigen::VectorXd e(size());
    Eigen::Index n = 0;
    visit([&](std::size_t r, std::size_t t, std::size_t i, double recorded, double weight) {
      e[n++] = weight * (recorded - gains[r][t] * values[r][i]);
    });
    return e;
  }

  /// Derivatives of the residuals, from which the part that gains can make up for is removed.
  [[nodiscard]] Eigen::MatrixXd derivatives(const Eigen::VectorXd& p) {
    const auto values = all_simulated(p);
    const Gains gains = gains_of(values);
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(size(), p.size());
    for (Eigen::Index j = 0; j < p.size(); ++j) {
      const auto change = difference(p, static_cast<std::size_t>(j));
      Eigen::Index n = 0;
      visit([&](std::size_t r, std::size_t t, std::size_t i, double, double weight) {
        J(n++, j) = change[r].empty() ? 0 : -weight * gains[r][t] * change[r][i];
      });
    }
    if (has_gain_) project(values, J);
    return J;
  }

  [[nodiscard]] Eigen::Index size() const {
    Eigen::Index count = 0;
    visit([&](std::size_t, std::size_t, std::size_t, double, double) { ++count; });
    return count;
  }
  [[nodiscard]] bool has_gain() const { return has_gain_; }
  [[nodiscard]] const std::vector<FitRow>& rows(std::size_t run) const { return rows_[run]; }
  [[nodiscard]] std::vector<ComparedRun>& runs() { return runs_; }

 private:
  /// Calls see(recording, taxel, index in the simulated values, recorded value, weight) for each value.
  template <class See>
  void visit(const See& see) const {
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      const std::size_t taxels = runs_[r].places.size();
      for (std::size_t i = 0; i < rows_[r].size(); ++i)
        for (std::size_t t = 0; t < taxels; ++t) {
          const double recorded = measured_at(*runs_[r].recording, rows_[r][i], t);
          if (!std::isnan(recorded)) see(r, t, i * taxels + t, recorded, 1 / runs_[r].largest);
        }
    }
  }
  [[nodiscard]] std::pair<std::size_t, int> group(std::size_t run, std::size_t taxel) const {
    return {options_.shares_gain ? 0 : run, runs_[run].recording->taxel_ids[taxel]};
  }

  /// Central differences of the simulated values by a parameter; empty for recordings that it does not affect.
  [[nodiscard]] std::vector<std::vector<double>> difference(const Eigen::VectorXd& p, std::size_t j) {
    const auto i = static_cast<Eigen::Index>(j);
    const double step = step_of(p, j);
    Eigen::VectorXd low = p, high = p;
    low[i] = std::max(p[i] - step, parameters_[j].lower);
    high[i] = std::min(p[i] + step, parameters_[j].upper);
    std::vector<std::vector<double>> out(runs_.size());
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      if (parameters_[j].run && *parameters_[j].run != r) continue;
      out[r] = simulated(high, r);
      const std::vector<double> below = simulated(low, r);
      for (std::size_t n = 0; n < below.size(); ++n) out[r][n] = (out[r][n] - below[n]) / (high[i] - low[i]);
    }
    return out;
  }
  [[nodiscard]] double step_of(const Eigen::VectorXd& p, std::size_t j) const {
    constexpr double kPart = 0.01;
    if (parameters_[j].name == FitName::k) return kPart;
    if (is_geometry(parameters_[j].name)) return kPart * p[Eigen::Index(j)];
    return kPart * geometry(p)[0];
  }

  /// Removes from each column its projection onto the simulated values of each gain.
  void project(const std::vector<std::vector<double>>& values, Eigen::MatrixXd& J) const {
    std::map<std::pair<std::size_t, int>, std::pair<double, Eigen::RowVectorXd>> sums;
    Eigen::Index n = 0;
    visit([&](std::size_t r, std::size_t t, std::size_t i, double, double weight) {
      auto& [square, along] = sums.try_emplace(group(r, t), 0.0, Eigen::RowVectorXd::Zero(J.cols())).first->second;
      const double u = weight * values[r][i];
      square += u * u;
      along += u * J.row(n++);
    });
    n = 0;
    visit([&](std::size_t r, std::size_t t, std::size_t i, double, double weight) {
      const auto& [square, along] = sums.at(group(r, t));
      if (square > 0) J.row(n) -= weight * values[r][i] / square * along;
      ++n;
    });
  }

  FitModel& model_;
  std::vector<ComparedRun>& runs_;
  const RecordingFitOptions& options_;
  const std::vector<FittedParameter>& parameters_;
  FitGeometry given_ = model_.geometry();
  dvec3 zero_{0};
  double gain_ = 1;
  bool has_gain_ = false;
  std::vector<std::vector<FitRow>> rows_;
};

/// Returns the start of a lateral zero: where the mean of the places at which a taxel responds, weighted by its
/// values, is its centre.
double lateral_start(const ComparedRun& run, const FitModel& model, int axis) {
  double sum = 0, weights = 0;
  for (std::size_t t = 0; t < run.places.size(); ++t) {
    double largest = 0, along = 0, total = 0;
    for (const Press& press : run.recording->presses)
      largest = std::max(
          largest, std::abs(measured_at(*run.recording,
                                        {std::size_t(&press - run.recording->presses.data()), press.end - 1}, t)));
    for (std::size_t p = 0; p < run.recording->presses.size(); ++p) {
      const std::size_t row = run.recording->presses[p].end - 1;
      const double value = std::abs(measured_at(*run.recording, {p, row}, t));
      if (!(value > 0.5 * largest)) continue;
      along += value * run.recording->displacements[row][axis];
      total += value;
    }
    if (!(total > 0)) continue;
    sum += largest * (model.center_of(run.places[t])[axis] - model.object_position()[axis] - along / total);
    weights += largest;
  }
  return weights > 0 ? sum / weights : 0;
}

/// The press of a recording with the largest value of a taxel: its row there and its row at rest.
struct StrongestPress {
  std::size_t deepest = 0, first = 0;
};
StrongestPress strongest_press(const ComparedRun& run) {
  StrongestPress best;
  double largest = -1;
  for (std::size_t p = 0; p < run.recording->presses.size(); ++p) {
    const Press& press = run.recording->presses[p];
    for (std::size_t t = 0; t < run.places.size(); ++t) {
      const double value = std::abs(measured_at(*run.recording, {p, press.end - 1}, t));
      if (value > largest) largest = value, best = {press.end - 1, press.first};
    }
  }
  return best;
}

/// Returns the displacement along the pressing axis at which the strongest press first touches, from `zero`. Returns
/// nothing if it touches nowhere within four sizes of the object.
std::optional<double> first_touch(const ComparedRun& run, FitModel& model, const FitGeometry& geometry, int axis,
                                  const dvec3& zero) {
  const StrongestPress press = strongest_press(run);
  const std::vector<dvec3>& at = run.recording->displacements;
  const double travel = at[press.deepest][axis] - at[press.first][axis], sign = travel < 0 ? -1 : 1;
  const double reach = 4 * (std::abs(travel) + geometry[1] + geometry[0]);
  const auto touches = [&](double shift) {
    dvec3 displacement = at[press.deepest] + zero;
    displacement[axis] += sign * shift;
    return model.read(geometry, std::array{displacement}).areas.front() > 0;
  };
  constexpr int kSteps = 64;
  double away = -reach, near = reach;
  bool found = false;
  for (int i = 0; i <= kSteps && !found; ++i) {
    near = -reach + 2 * reach * i / kSteps;
    found = touches(near);
    if (!found) away = near;
  }
  if (!found) return std::nullopt;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (away + near);
    (touches(middle) ? near : away) = middle;
  }
  return sign * near;
}

/// The parameters of a fit with their starts and bounds.
class Setup {
 public:
  Setup(FitModel& model, const RecordingFitOptions& options, int axis) : model_(model), options_(options), axis_(axis) {
    check_free();
  }

  [[nodiscard]] std::optional<double> given(FitName name) const {
    for (const FitValue& value : options_.values)
      if (value.name == name) return value.value;
    return std::nullopt;
  }

  /// Parameters of the geometry, if `with_geometry`, and the zeros of each recording. `geometry` is that of the start.
  [[nodiscard]] std::vector<FittedParameter> parameters(const std::vector<ComparedRun>& runs, bool with_geometry,
                                                        const FitGeometry& geometry) const {
    std::vector<FittedParameter> out;
    for (const FitName name : options_.free)
      if (with_geometry && is_geometry(name)) out.push_back(geometry_parameter(name, geometry));
    for (std::size_t r = 0; r < runs.size(); ++r)
      for (const FitName name : options_.free)
        if (!is_geometry(name) && name != FitName::gain) out.push_back(zero_parameter(name, r, runs[r]));
    return out;
  }

 private:
  void check_free() const {
    for (std::size_t i = 0; i < options_.free.size(); ++i) {
      const FitName name = options_.free[i];
      if (std::count(options_.free.begin(), options_.free.end(), name) > 1)
        throw Error("", "--free", fmt::format("names {} twice", to_word(name)));
      if (is_geometry(name) && !(model_.geometry()[static_cast<std::size_t>(name)] > 0) && name != FitName::k &&
          !given(name))
        throw Error("", "--free", fmt::format("{} has no value to start from", to_word(name)));
    }
  }
  [[nodiscard]] FittedParameter geometry_parameter(FitName name, const FitGeometry& geometry) const {
    const double start = geometry[static_cast<std::size_t>(name)];
    if (name == FitName::k) return {name, {}, start, 0, start, 0, kMostK};
    return {name, {}, start, 0, start, start / kFactor, start * kFactor};
  }
  [[nodiscard]] FittedParameter zero_parameter(FitName name, std::size_t r, const ComparedRun& run) const {
    const int axis = axis_of(name);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const dvec3& at : run.recording->displacements) low = std::min(low, at[axis]), high = std::max(high, at[axis]);
    const double reach = (high - low) + 2 * (model_.geometry()[0] + model_.geometry()[1]);
    const double start = given(name).value_or(axis == axis_ || !(high > low) ? 0 : lateral_start(run, model_, axis));
    return {name, r, start, 0, start, start - reach, start + reach};
  }

  FitModel& model_;
  const RecordingFitOptions& options_;
  int axis_;
};

/// Fits some recordings.
class Fitter {
 public:
  Fitter(FitModel& model, std::vector<ComparedRun> runs, const RecordingFitOptions& options, int axis)
      : model_(model), runs_(std::move(runs)), options_(options), axis_(axis), setup_(model, options, axis) {}

  /// Fits zeros, and the geometry if `with_geometry`; otherwise the geometry is that of the options' values.
  void fit(bool with_geometry, const FitGeometry& geometry, RecordingFit& out) {
    parameters_ = setup_.parameters(runs_, with_geometry, geometry);
    RecordingFitOptions fixed = options_;
    for (std::size_t i = 0; i < geometry.size(); ++i) fixed.values.push_back({static_cast<FitName>(i), geometry[i]});
    Residuals residuals(model_, runs_, fixed, parameters_);
    residuals.take_rows(kCoarseRows);
    LeastSquaresPoint best;
    bool is_first = true;
    for (const Eigen::VectorXd& start : starts(residuals, geometry)) {
      const LeastSquaresPoint tried = minimise(problem(residuals), start, kCoarseSteps);
      if (is_first || tried.cost < best.cost) best = tried;
      is_first = false;
    }
    residuals.take_rows(kFineRows);
    best = minimise(problem(residuals), best.p, kFineSteps);
    finish(residuals, best, out);
  }

  [[nodiscard]] const FitGeometry& geometry() const { return fitted_; }

 private:
  [[nodiscard]] LeastSquares problem(Residuals& residuals) const {
    const auto count = static_cast<Eigen::Index>(parameters_.size());
    LeastSquares out;
    out.residuals = [&residuals](const Eigen::VectorXd& p) { return residuals.residuals(p); };
    out.derivatives = [&residuals](const Eigen::VectorXd& p) { return residuals.derivatives(p); };
    out.lower.resize(count), out.upper.resize(count), out.scale.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const FittedParameter& parameter = parameters_[static_cast<std::size_t>(i)];
      out.lower[i] = parameter.lower, out.upper[i] = parameter.upper;
      out.scale[i] = scale_of(parameter);
    }
    return out;
  }

  /// Returns the size of a parameter, of which a step must change a part to matter.
  [[nodiscard]] double scale_of(const FittedParameter& parameter) const {
    if (parameter.name == FitName::k) return 1;
    return is_geometry(parameter.name) ? parameter.start : model_.geometry()[0];
  }

  /// The starts. Lateral zeros: as estimated from the presses, or 0; each with the best of some depths. From the better
  /// one, radii that trade off.
  [[nodiscard]] std::vector<Eigen::VectorXd> starts(Residuals& residuals, const FitGeometry& geometry) {
    const auto count = static_cast<Eigen::Index>(parameters_.size());
    Eigen::VectorXd first(count), second(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const FittedParameter& parameter = parameters_[static_cast<std::size_t>(i)];
      first[i] = second[i] = parameter.start;
      if (!is_geometry(parameter.name) && !setup_.given(parameter.name)) second[i] = 0;
    }
    std::vector<Eigen::VectorXd> all;
    if (choose_depths(residuals, geometry, first)) all.push_back(first);
    if (second != first && choose_depths(residuals, geometry, second)) all.push_back(second);
    if (all.empty())
      throw Error(
          runs_.front().recording->file,
          "the object of the case touches the layout nowhere along its presses: check the poses of the case, and "
          "the signs and units of the columns");
    if (all.size() > 1 && residuals.residuals(all[1]).squaredNorm() < residuals.residuals(all[0]).squaredNorm())
      std::swap(all[0], all[1]);
    add_traded_radii(all);
    for (Eigen::Index i = 0; i < count; ++i) parameters_[static_cast<std::size_t>(i)].start = all[0][i];
    return all;
  }

  /// Adds starts with a smaller field and a larger object than in the first one, and the reverse.
  void add_traded_radii(std::vector<Eigen::VectorXd>& all) const {
    std::optional<Eigen::Index> radius, object;
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      if (setup_.given(parameters_[i].name)) continue;
      if (parameters_[i].name == FitName::radius) radius = Eigen::Index(i);
      if (parameters_[i].name == FitName::object_radius) object = Eigen::Index(i);
    }
    if (!radius && !object) return;
    for (const double factor : {0.7, 1.4}) {
      Eigen::VectorXd other = all.front();
      if (radius) other[*radius] *= factor;
      if (object) other[*object] /= factor;
      all.push_back(other);
    }
  }

  /// Sets the zeros along the pressing axis to the best of some depths below the first touch. Returns false if the
  /// object touches nowhere.
  bool choose_depths(Residuals& residuals, const FitGeometry& geometry, Eigen::VectorXd& p) {
    const auto pressing = static_cast<FitName>(static_cast<int>(FitName::x0) + axis_);
    for (std::size_t i = 0; i < parameters_.size(); ++i)
      if (parameters_[i].name == pressing && !setup_.given(pressing) && !choose_depth(residuals, geometry, i, p))
        return false;
    return true;
  }
  bool choose_depth(Residuals& residuals, const FitGeometry& geometry, std::size_t parameter, Eigen::VectorXd& p) {
    const auto i = static_cast<Eigen::Index>(parameter);
    const std::size_t r = *parameters_[parameter].run;
    p[i] = 0;
    const auto touch = first_touch(runs_[r], model_, geometry, axis_, residuals.zero(p, r));
    if (!touch) return false;
    const StrongestPress press = strongest_press(runs_[r]);
    const std::vector<dvec3>& at = runs_[r].recording->displacements;
    const double travel = at[press.deepest][axis_] - at[press.first][axis_];
    double least = std::numeric_limits<double>::infinity(), best = *touch;
    for (const double part : {0.15, 0.3, 0.5, 0.7, 0.85, 1.0}) {
      p[i] = *touch + part * travel;
      if (const double cost = residuals.residuals(p).squaredNorm(); cost < least) least = cost, best = p[i];
    }
    p[i] = best;
    FittedParameter& zero = parameters_[parameter];
    zero.lower = std::min(zero.lower, best - std::abs(travel)),
    zero.upper = std::max(zero.upper, best + std::abs(travel));
    return true;
  }

  void finish(Residuals& residuals, const LeastSquaresPoint& best, RecordingFit& out);

  FitModel& model_;
  std::vector<ComparedRun> runs_;
  const RecordingFitOptions& options_;
  int axis_;
  Setup setup_;
  std::vector<FittedParameter> parameters_;
  FitGeometry fitted_{};
};

void Fitter::finish(Residuals& residuals, const LeastSquaresPoint& best, RecordingFit& out) {
  const Eigen::MatrixXd J = residuals.derivatives(best.p);
  std::size_t used = parameters_.size();
  if (residuals.has_gain())
    for (const ComparedRun& run : runs_) used += run.places.size();
  const auto points = static_cast<std::size_t>(residuals.size());
  if (points <= used)
    throw Error(runs_.front().recording->file,
                fmt::format("has {} values for {} parameters with the gains", points, used));
  residuals.take_rows(std::numeric_limits<std::size_t>::max() / 4);
  const auto all = static_cast<std::size_t>(residuals.size());
  const auto simulated = residuals.all_simulated(best.p);
  const auto gains = residuals.gains_of(simulated);
  // The fine fit uses a part of the values; J^T J of all of them is larger by the ratio of their numbers.
  const double variance =
      2 * best.cost / static_cast<double>(points - used) * static_cast<double>(points) / static_cast<double>(all);
  const Certainty certainty = certainty_of(J, variance);
  const std::size_t first_run = out.runs.size();
  fitted_ = residuals.geometry(best.p);
  for (std::size_t r = 0; r < runs_.size(); ++r)
    out.runs.push_back(
        agreement_of(*runs_[r].recording, residuals.rows(r), residuals.zero(best.p, r), simulated[r], gains[r], axis_));
  if (first_run > 0) return;  // a held-out recording: its zeros are in its agreement
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    parameters_[i].value = best.p[Eigen::Index(i)];
    parameters_[i].standard_error = certainty.standard_errors[i];
  }
  out.parameters = parameters_;
  out.correlations = certainty.correlations;
  out.undecided = undecided_of(out.parameters, out.correlations);
}

}  // namespace

RecordingFit fit_recordings(const FitSubject& subject, const std::vector<PressedRecording>& fitted,
                            const std::vector<PressedRecording>& held_out, const RecordingFitOptions& options) {
  if (fitted.empty()) throw Error("there is no recording to fit");
  FitModel model(subject, options.threads, options.progress);
  FitGeometry geometry = model.geometry();
  for (const FitValue& value : options.values)
    if (is_geometry(value.name)) geometry[static_cast<std::size_t>(value.name)] = value.value;
  std::vector<ComparedRun> runs;
  for (const PressedRecording& recording : fitted) runs.push_back(compared_run(recording, model));
  RecordingFit out;
  Fitter fitter(model, std::move(runs), options, options.axis);
  fitter.fit(true, geometry, out);
  for (const PressedRecording& recording : held_out) {
    Fitter other(model, {compared_run(recording, model)}, options, options.axis);
    other.fit(false, fitter.geometry(), out);
    out.runs.back().is_held_out = true;
  }
  return out;
}

}  // namespace taxel
