// Decides whether a reading changed because of the contact or because of the method, and says so in sentences.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// An edge of the skin's mesh in the receptive field of a taxel. Force crossed the edge from one step to the next.
struct CrossedEdge {
  std::array<int, 2> faces{};  ///< faces of SensorModel::mesh at the edge, ascending
  double bend_deg = 0;         ///< angle between the normals of the faces [degrees]
  double distance = 0;         ///< distance of the edge from the taxel's centre [m]
  double force = 0;            ///< force that crossed the edge [N]
};

/// A change of one setting of the layout with which the contacts of two steps were read again.
struct SettingTried {
  std::string text;          ///< the setting in words: "rays along the taxel's normal"
  ReceptiveFieldRule field;  ///< rule of the receptive fields
  Readout readout;           ///< readout of the layout
  double radius = 1;         ///< factor of the taxel's radius
  double change = 0;         ///< change of the reading, scaled to the mean of the original readings
  bool cures = false;        ///< true if the change is below the limit with a margin
};

/// Returns the first setting that cures, or the one with the smallest change, or null if no change is below `helpful`.
/// The result is valid as long as `tried`.
inline const SettingTried* best_setting(const std::vector<SettingTried>& tried, double helpful) {
  const SettingTried* best = nullptr;
  for (const SettingTried& setting : tried) {
    if (!(std::abs(setting.change) < helpful)) continue;
    if (setting.cures) return &setting;
    if (best == nullptr || std::abs(setting.change) < std::abs(best->change)) best = &setting;
  }
  return best;
}

/// The cause of a change.
enum class Cause {
  none,            ///< the reading did not jump
  sampling_noise,  ///< samples: the exact integral changes smoothly
  star_field,      ///< stiffness of a star, which differs between tets
  inverted_tets,   ///< tets that are outside of their skin
  cone,            ///< limit of the angle: the contact crossed the edge at which it cuts the field
  mesh_edges,      ///< normals of the faces, which change at the mesh edges that the contact crossed
  redistribution,  ///< contact: pressure moved at constant force
  contact          ///< contact: the force changed as well
};
inline constexpr std::array<std::string_view, 8> kCauseWords{
    "none", "sampling_noise", "star_field", "inverted_tets", "cone", "mesh_edges", "redistribution", "contact"};
inline std::string_view to_word(Cause cause) {
  return kCauseWords[static_cast<std::size_t>(cause)];
}

/// The limits of a jump and of a constant force, as in Breakpoints.
struct ExplainLimits {
  double jump = 0;         ///< fraction of `largest`
  double equal_force = 0;  ///< fraction of the larger force
  double largest = 0;      ///< largest reading of the run, at least reading_floor()
  bool of_sensor = false;  ///< true if `largest` is of all taxels of the sensor
  /// Largest reading of all taxels of the sensor in the run, or 0 if unknown. A taxel whose largest reading is below
  /// kHardlyReads of it hardly reads: the sentences give fractions of this one.
  double sensor_largest = 0;
};
/// See ExplainLimits::sensor_largest.
inline constexpr double kHardlyReads = 0.05;

/// A value in the previous and in this step.
struct Readings {
  double before = 0, now = 0;
  [[nodiscard]] double change() const { return now - before; }
};

/// A number of samples with which both contacts were read again.
struct SamplesNeeded {
  double samples = 0;  ///< number on the sampled faces
  double factor = 0;   ///< exact multiple of the layout's density
  double change = 0;   ///< change of the reading with this number of samples
  bool cures = false;  ///< true if the change is below the limit with a margin
};

/// An angle limit of the receptive fields with which both contacts were read again.
struct AngleTried {
  double angle_deg = 0;  ///< receptive_field.max_angle_deg
  double change = 0;     ///< change of the reading with this limit
  bool cures = false;    ///< true if the change is below the limit with a margin
};

/// The largest change of the taxel's reading from one step to the next in the run, if that is not the explained one.
struct WorstChange {
  double time = 0;    ///< time of the later step [s]
  double change = 0;  ///< [unit of the reading]
  /// Numbers of samples and limits of the angle, tried on this change as on the explained one.
  std::optional<SamplesNeeded> needed;
  std::optional<AngleTried> wider;
};

/// The parts of a change of a reading: noise + field + cone + edges + contact = change.
struct Verdict {
  Cause cause = Cause::none;
  double change = 0;   ///< change of the reading [its unit]
  double noise = 0;    ///< part of the samples: change less exact change
  double field = 0;    ///< part of the field: exact change less uniform change
  double cone = 0;     ///< part of the angle limit: the change with the limit less the change without
  double edges = 0;    ///< part of the mesh edges: exact change less that with interpolated normals
  double contact = 0;  ///< remainder
  double limit = 0;    ///< smallest change that is a jump
  bool force_stays = false;
  /// For sampling_noise, and if is_partly_noise(): the smallest number of samples that cures, or the largest number
  /// that was tried. A change below the limit is cured if half of its noise is gone.
  std::optional<SamplesNeeded> needed;
  /// For sampling_noise: the change of the reading for the same samples with Voronoi weights [its unit].
  std::optional<double> voronoi_change;
  /// For cone: the smallest angle limit that cures, or the largest that was tried.
  std::optional<AngleTried> wider;
  std::vector<CrossedEdge> crossed;  ///< mesh edges under the taxel that the contact crossed, largest effect first
  /// For mesh_edges: the settings of the layout that were tried, in order.
  std::vector<SettingTried> tried;
  /// The worst change of the run if it is known, larger than the explained one and above the limit.
  std::optional<WorstChange> worst;
  std::string text;  ///< one to four sentences
};

/// The input of a verdict.
struct VerdictInput {
  ExplainLimits limits;
  Readings sampled;
  std::optional<Readings> exact;  ///< exact readings, if there are any
  std::optional<Readings> even;   ///< exact readings under uniform stiffness, for a suspect field
  /// Exact readings with the normals of the skin interpolated over its faces, for rays and angles, if edges were
  /// crossed.
  std::optional<Readings> smooth;
  /// Exact readings without the angle limit of the fields, with the normals of `smooth` if there is one.
  std::optional<Readings> uncut;
  /// The parts of `exact` and `even` on polygons of inverted tets.
  std::optional<Readings> exact_inverted, even_inverted;
  bool soft_contact = false;  ///< true if the field is suspect but `even` is unknown
  Readings force;             ///< magnitude of the force on the sensor [N]
};

/// Decides on the cause, without setting `needed`, `voronoi_change`, `wider`, `crossed`, `tried` and `worst`. The cause
/// belongs to the part that is largest in the direction of the change. The other readings of the two contacts are
/// scaled to the mean of the exact readings, so that only differences between places count as a part.
Verdict decide(const VerdictInput& input);

/// Returns true for a change below the limit that is large all the same, at least a quarter of it noise of the samples.
bool is_partly_noise(const Verdict& verdict, const VerdictInput& input);

/// Returns the sentences. Call after all other values of the verdict are set.
std::string verdict_text(const Verdict& verdict, const VerdictInput& input);

}  // namespace taxel
