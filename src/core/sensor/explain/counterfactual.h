// The contacts of two steps read again with one thing changed: another pressure field, more samples, other settings of
// the layout. The readings show whether a change comes from the contact or from the method, and what cures it.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/explain/explanation.h"
#include "core/sensor/explain/verdict.h"
#include "core/sensor/sensor_model.h"
#include "core/sensor/sensor_step.h"

namespace taxel {

/// Surfaces of one contact, in the order of the original ones.
struct OtherSurfaces {
  std::vector<ContactSurface> surfaces;
  std::vector<const ContactSurface*> pointers;  ///< pointers to `surfaces`; null for null originals
};

/// The inverted tets of a sensor's field. An inverted tet is on the outer side of its skin face, and the pressure below
/// that face is the pressure of other tets that reach across.
class InvertedTets {
 public:
  InvertedTets() = default;
  explicit InvertedTets(const SensorModel& model);
  /// Returns true if a polygon (frame M) is in an inverted tet, or below the face of one.
  [[nodiscard]] bool concern(const ContactPolygon& polygon) const;

 private:
  std::shared_ptr<const MeshIndex> skin_;
  std::vector<bool> tets_, faces_;  // empty if no tet is inverted
};

/// Returns true if the field may cause a change of a reading: a star, or a field with inverted tets.
bool field_is_suspect(const SensorModel& model);

/// Returns true if both bodies of a contact are soft, so that the surface depends on the field: if polygons have tets
/// of both bodies, or if they are on no face of a rigid mesh and not in one plane.
bool between_soft_bodies(const ContactSurface& surface);

/// Returns the polygons under a field of uniform stiffness: p = k depth with the depth below the skin and the mean
/// stiffness k of the sensor's own field. The depth is at most the thickness of a pad whose field ends with its tets.
/// Depth and gradient are evaluated at the centroid of each polygon, without tets. Valid if the other bodies are rigid:
/// then the place of the surfaces does not depend on the field.
OtherSurfaces with_even_stiffness(const SensorModel& model, std::span<const ContactSurface* const> surfaces);

// Remedies for sampling noise, each checked by reading the same contacts again with the remedy.

/// Returns the reading of the contact of a step by another model.
double reading_of(const SensorModel& model, int taxel, const SensorStep& step);

/// Multiples of the layout's number of samples that are tried, in this order.
inline constexpr std::array<double, 3> kTriedFactors{4, 16, 64};
/// Largest number of samples that is tried. With more samples an explanation would take too long.
inline constexpr double kMaxTriedSamples = 100'000;
/// A remedy brings the change below this fraction of the limit. The fraction is less than 1 because the limit is
/// relative to the taxel's largest reading, which changes a little with the samples too.
inline constexpr double kCureMargin = 0.9;

/// Models with more samples by factor, each built when it is first needed.
using DenserModels = std::map<double, SensorModelPtr>;

/// Reads both contacts with kTriedFactors times the samples until the change is below kCureMargin x limit. Returns the
/// first number of samples with such a change, or the largest number that was tried, or nothing if no model with more
/// samples could be built. A weighted_sum is scaled to the layout's number of samples. Throws Cancelled through
/// `progress`.
std::optional<SamplesNeeded> samples_that_cure(const SensorModelPtr& model, int taxel, const SensorStep& before,
                                               const SensorStep& now, double limit, DenserModels& made,
                                               SensorCache& cache, Progress* progress = nullptr);

/// Angle limits that are tried for a field that the limit cuts [degrees]; those below the layout's own are left out.
inline constexpr std::array<double, 5> kTriedAngles{60, 75, 90, 135, 180};

/// Returns the model without the angle limit of the receptive fields, for exact_reading() only: it has no samples of
/// its own.
SensorModel without_angle_limit(const SensorModel& model);

/// Reads both contacts with the limits of kTriedAngles until the change is below kCureMargin x limit. Returns the first
/// such limit, or the largest one that was tried, or nothing if none is larger than the layout's. Throws Cancelled
/// through `progress`.
std::optional<AngleTried> angle_that_cures(const SensorModelPtr& model, int taxel, const SensorStep& before,
                                           const SensorStep& now, double limit, SensorCache& cache,
                                           Progress* progress = nullptr);

/// Returns the change of the reading from `before` to `now` for the same samples with Voronoi weights.
double change_with_voronoi_weights(const SensorModel& model, int taxel, const SensorStep& before,
                                   const SensorStep& now);

// Remedies for jumps at mesh edges, each checked by reading the same contacts again with the remedy.

/// Widths of the roll-off below the angle limit that are tried [degrees]; those up to the layout's own are left out.
inline constexpr std::array<double, 3> kTriedFalloffs{10, 20, 40};
/// Factors of the taxel's radius that are tried.
inline constexpr std::array<double, 2> kTriedRadii{1.5, 2};

/// Returns the readings without the jumps of the faces' normals: the model's own, with the normals that the angle
/// refers to interpolated over the faces, for exact_reading() only. The result has no samples of its own.
SensorModel with_interpolated_angles(const SensorModel& model);

/// Reads both contacts with other settings until the change is below kCureMargin x limit: interpolated normals, a
/// roll-off over them, rays along the taxel's normal, exact readings, a larger radius. Only settings that the layout
/// does not have and that its aggregate allows are tried. Throws Cancelled through `progress`.
std::vector<SettingTried> settings_against_edges(const SensorModelPtr& model, int taxel, const SensorStep& before,
                                                 const SensorStep& now, double limit, SensorCache& cache,
                                                 Progress* progress = nullptr);

}  // namespace taxel
