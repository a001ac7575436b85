// Where one taxel's reading comes from, and why it changed since the step before: its samples, its polygons, what other
// numbers of samples would read, the exact integral, where the force goes, and a verdict.
#pragma once

#include <memory>

#include "core/sensor/convergence.h"
#include "core/sensor/explain/exact_reading.h"
#include "core/sensor/explain/samples_behind.h"
#include "core/sensor/explain/verdict.h"

namespace taxel {

/// One sensor in one step, as it was read. Keeps what it points to alive for nobody.
struct SensorStep {
  double time = 0;  ///< [s]
  Pose X_WM;
  std::vector<const ContactSurface*> surfaces;  ///< frame M, as hits number them; null ones hold nothing
  const std::vector<RayHit>* hits = nullptr;    ///< parallel to the model's rays
  std::vector<double> readings;                 ///< by taxel
  std::optional<dvec3> force_W;                 ///< of the contact on the sensor, with damping and friction [N]
};

/// One polygon of the sensor's contact surfaces.
struct PolygonBehind {
  int surface = 0, polygon = 0;
  int tet = -1, tet_b = -1, face = -1;       ///< as ContactPolygon
  bool inverted = false;                     ///< its tet, or that of the skin above it, is inside out
  double area = 0;                           ///< [m^2]
  double lowest = 0, mean = 0, highest = 0;  ///< pressure [Pa]
  double force_share = 0;                    ///< of the integral of p0 over all surfaces
  int samples = 0;                           ///< of the taxel, whose rays met it
  double share = 0;                          ///< of the taxel's reading, by its samples
  double exact_share = 0;                    ///< of the exact reading; 0 where that is no integral
  std::vector<int> taxels;                   ///< served: ids of those with a sample that met it, ascending
};

/// World frame.
struct ForceBudget {
  dvec3 surfaces_W{0};  ///< integral of p0 n over all surfaces: the elastic force on the sensor [N]
  dvec3 taxels_W{0};    ///< the part of it that taxels reach, shared out among them (force_integral.h) [N]
  dvec3 taxel_W{0};     ///< this taxel's part [N]
  double pressed = 0;   ///< integral of p0 over all surfaces [N]
  double covered = 0, uncovered = 0;  ///< of it, where a taxel reaches and where none does [N]
  std::optional<dvec3> net_W;         ///< what MuJoCo applied, with damping and friction [N]
};

/// The taxel's reading by the numbers of samples of Convergence::kFactors.
struct SampleLevels {
  std::array<int, 3> samples{};    ///< on what is sampled
  std::array<double, 3> now{};     ///< weighted_sum: as of so many samples as the layout has
  std::array<double, 3> before{};  ///< zeros without a step before
};

/// Samples that changed from before to now: together they make the change of the reading.
struct SampleChange {
  int count = 0;
  double change = 0;  ///< of the reading, by them [its unit]
};

struct StepChange {
  double time_before = 0;
  Readings reading;
  Readings force;                      ///< magnitude of the contact force on the sensor [N]
  SampleChange began, ceased, stayed;  ///< to hit
  Verdict verdict;
};

struct Explanation {
  int taxel = 0;  ///< in layout order
  int id = 0;
  std::string name;
  Aggregate aggregate{};
  double time = 0, reading = 0;
  std::vector<TaxelSampleReading> samples, samples_before;  ///< the latter parallel to the former, or empty
  std::vector<PolygonBehind> polygons;  ///< of all surfaces, in their order; those of the taxel have a share
  std::optional<SampleLevels> levels;   ///< none: `no_levels` says why
  std::string no_levels;
  ExactReading exact;
  std::optional<ExactReading> exact_before;
  ForceBudget budget;
  std::optional<StepChange> change;  ///< none without a step before
};

/// Explains, one question after the other; keeps what sensors of the same model need again. Of one thread.
class Explainer {
 public:
  Explainer();
  ~Explainer();
  /// `before` may be null; it must be of the same model as `now`. A pure function of its arguments. Throws Error for an
  /// unknown taxel, Cancelled through `progress`.
  Explanation explain(const SensorModelPtr& model, int taxel, const SensorStep& now, const SensorStep* before,
                      const ExplainLimits& limits, Progress* progress = nullptr);

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace taxel
