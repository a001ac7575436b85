// The explanation of one taxel's reading: its samples and polygons, the readings with other numbers of samples, the
// exact reading, the balance of forces, and the reason why the reading changed since the previous step.
#pragma once

#include "core/sensor/convergence.h"
#include "core/sensor/explain/behind/samples_behind.h"
#include "core/sensor/explain/exact_value.h"
#include "core/sensor/explain/verdict.h"
#include "core/sensor/sensor_step.h"

namespace taxel {

/// One polygon of the sensor's contact surfaces.
struct PolygonBehind {
  int surface = 0, polygon = 0;
  int tet = -1, tet_b = -1, face = -1;       ///< indices as in ContactPolygon
  bool inverted = false;                     ///< true if its tet, or the tet of the skin above it, is inverted
  double area = 0;                           ///< [m^2]
  double lowest = 0, mean = 0, highest = 0;  ///< pressure [Pa]
  double force_share = 0;                    ///< fraction of the integral of p0 over all surfaces
  int samples = 0;                           ///< number of the taxel's samples whose rays hit the polygon
  double share = 0;                          ///< fraction of the taxel's reading, by samples
  double exact_share = 0;                    ///< fraction of the exact reading; 0 if that is not an integral
  std::vector<int> taxels;                   ///< ids of taxels whose samples hit the polygon, ascending
};

/// The balance of the forces on the sensor in one step, in the world frame.
struct ForceBudget {
  dvec3 surfaces_W{0};                ///< integral of p0 n over all surfaces: the elastic force on the sensor [N]
  dvec3 taxels_W{0};                  ///< part of surfaces_W that the taxels' fields cover [N]
  dvec3 taxel_W{0};                   ///< part of taxels_W on this taxel [N]
  double pressed = 0;                 ///< integral of p0 over all surfaces [N]
  double covered = 0, uncovered = 0;  ///< parts of `pressed` inside and outside all fields [N]
  dvec3 net_W{0};                     ///< force that MuJoCo applied, with damping and friction [N]
};

/// The taxel's reading with the numbers of samples of Convergence::kFactors. A weighted_sum is scaled to the number of
/// samples of the layout.
struct SampleLevels {
  std::array<int, 3> samples{};    ///< numbers on the sampled faces
  std::array<double, 3> now{};     ///< readings in this step
  std::array<double, 3> before{};  ///< readings in the previous step, zeros without one
};

/// The samples that changed in one way since the previous step. All ways together make the change of the reading.
struct SampleChange {
  int count = 0;
  double change = 0;  ///< change of the reading by these samples [its unit]
};

/// The change of a reading since the previous step.
struct StepChange {
  double time_before = 0;
  Readings reading;
  Readings force;                      ///< magnitude of the contact force on the sensor [N]
  SampleChange began, ceased, stayed;  ///< samples that began, ceased or continued to hit
  Verdict verdict;
};

/// The explanation of one taxel's reading in one step.
struct Explanation {
  int taxel = 0;  ///< index in layout order
  int id = 0;
  std::string name;
  Aggregate aggregate{};
  double time = 0, reading = 0;
  std::vector<TaxelSampleReading> samples, samples_before;  ///< previous step: same order, or empty
  std::vector<PolygonBehind> polygons;                      ///< polygons of all surfaces, in their order
  std::optional<SampleLevels> levels;                       ///< empty if there is a reason in `no_levels`
  std::string no_levels;
  ExactReading exact;
  std::optional<ExactReading> exact_before;
  ForceBudget budget;
  /// Number of the taxel's samples that would read a back face of a thin body if contact surfaces had these faces.
  int samples_at_back_faces = 0;
  std::optional<StepChange> change;  ///< empty without a previous step
};

}  // namespace taxel
