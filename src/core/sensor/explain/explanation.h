// The explanation of one taxel's reading: its samples and polygons, the readings with other numbers of samples, the
// exact reading, the balance of forces, the mesh edges that the contact crossed, and the reason why the reading changed
// since the previous step.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/math.h"
#include "core/layout/words.h"
#include "core/sensor/error_bars.h"
#include "core/sensor/explain/verdict.h"
#include "core/sensor/rays/sensor_ray.h"
#include "core/sensor/reference/exact_value.h"
#include "core/sensor/sensor_model.h"
#include "core/sensor/sensor_step.h"

namespace taxel {

/// One sample of a taxel in one step.
struct TaxelSampleReading {
  int sample = 0;         ///< index in SensorModel::samples
  bool hit = false;       ///< true if the ray hit a contact surface
  double depth = 0.0;     ///< depth of the hit along the ray; 0 for a miss [m]
  double pressure = 0.0;  ///< 0 for a miss [Pa]
  double weight = 0.0;    ///< weight in the receptive field [m^2]
  double share = 0.0;     ///< fraction of the taxel's reading; all are 0 if it reads 0
};

/// Returns the samples of one taxel for the layout's aggregate, sorted by sample. Throws Error for an unknown taxel.
std::vector<TaxelSampleReading> samples_behind(const SensorModel& model, const std::vector<RayHit>& hits, int taxel);

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

/// Returns the number of samples of taxel number `taxel` whose rays meet a back face (hydro/kernel/surface_writer.h)
/// before the polygon that they read, or read one that counts in part.
int count_samples_at_back_faces(const SensorModel& model, int taxel, const SensorStep& step);

/// Returns the sentence on back faces in the taxel's field, or nothing if there are none.
std::string back_faces_text(const Explanation& explanation);

/// Returns the lower limit of the largest reading of which changes are fractions, in the unit of the readings: 1e-4 of
/// the modulus, or, if readings are forces, this pressure times the area of the largest receptive field. 0 for a rigid
/// sensor. Every contact gives larger readings, so rounding errors are not reported as jumps.
inline double reading_floor(const SensorModel& model) {
  constexpr double kFraction = 1e-4;
  const double pressure = kFraction * model.layout.material.modulus;
  const Aggregate how = model.layout.readout.aggregate;
  if (std::string_view(reading_unit(how)) == "Pa") return pressure;
  double radius = 0;
  for (const Taxel& taxel : model.layout.taxels) radius = std::max(radius, taxel.radius);
  return pressure * kPi * radius * radius;
}

/// Returns an explanation as JSON, one object in SI units, for `taxel explain --json` and the window's state dump.
/// docs/window_reference.md lists the keys.
std::string explanation_to_json(const Explanation& explanation);

// Finds the edges of the skin's mesh under a taxel that a contact crossed from one step to the next.
//
//        f     |     g        The force of each contact polygon acts on the face of the skin that is nearest to the
//     ____ooo__|______        polygon's centroid. The contact crossed the edge between f and g if the force on one
//     ______oo_|o_____        of them fell while the other's rose, or if it reached or left one of them while it
//                             acted on the other in both steps.

/// Angle between the normals of two faces up to which their edge is flat [degrees].
inline constexpr double kFlatEdge = 0.1;
/// Largest number of edges that crossed_edges() returns.
inline constexpr std::size_t kMaxCrossedEdges = 8;

/// Returns the edges inside the receptive field of taxel number `taxel` of now.model that the contact crossed, except
/// flat ones, by descending product of force and angle. An edge is inside if a point of the edge is within the radius
/// of the field, by the straight distance. An edge on the way of the centre of the pressure counts as well: then all of
/// the force in the field crossed the edge. `before` is a step of the same model.
std::vector<CrossedEdge> crossed_edges(int taxel, const SensorStep& before, const SensorStep& now);

}  // namespace taxel
