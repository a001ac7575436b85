// Whether a reading that changed did so by the contact or by the method, in words.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace taxel {

enum class Cause {
  none,            ///< the reading did not jump
  sampling_noise,  ///< the samples, where the exact integral goes on smoothly
  star_field,      ///< the stiffness of a star, which differs from tet to tet
  inverted_tets,   ///< tets that lie outside of the skin they belong to, and leave it to others
  redistribution,  ///< the contact: pressure moved while the sensor's force stayed
  contact          ///< the contact: the sensor's force changed as well
};
inline constexpr std::array<std::string_view, 6> kCauseWords{"none",          "sampling_noise", "star_field",
                                                             "inverted_tets", "redistribution", "contact"};
inline std::string_view to_word(Cause cause) {
  return kCauseWords[static_cast<std::size_t>(cause)];
}

/// What counts as a jump, and as a force that stays: those of Breakpoints.
struct ExplainLimits {
  double jump = 0;         ///< part of `largest`
  double equal_force = 0;  ///< part of the larger force
  double largest = 0;      ///< reading of the taxel in the run, at least reading_floor() [its unit]
  bool of_sensor = false;  ///< `largest` is that of all taxels of the sensor
};

/// Two readings of one thing, before and now.
struct Readings {
  double before = 0, now = 0;
  [[nodiscard]] double change() const { return now - before; }
};

/// A number of samples with which the same two contacts were read again.
struct SamplesNeeded {
  double samples = 0;  ///< number on the sampled faces
  double factor = 0;   ///< multiple of the layout's density, exactly
  double change = 0;   ///< of the reading with so many samples [its unit]
  bool cures = false;  ///< the change stays below the limit, with a margin
};

/// The change of a reading, taken apart: noise + field + contact = change.
struct Verdict {
  Cause cause = Cause::none;
  double change = 0;   ///< of the reading [its unit]
  double noise = 0;    ///< of the samples: change less that of the exact integral
  double field = 0;    ///< of the pressure field: that less the change under even stiffness
  double contact = 0;  ///< what remains
  double limit = 0;    ///< of a jump
  bool force_stays = false;
  /// For sampling_noise: the least number of samples that cures, or the largest that was tried in vain.
  std::optional<SamplesNeeded> needed;
  /// For sampling_noise: change of the reading of the same samples with Voronoi weights [its unit].
  std::optional<double> voronoi_change;
  std::string text;  ///< one to three sentences
};

/// What a verdict is made of.
struct VerdictInput {
  ExplainLimits limits;
  Readings sampled;
  std::optional<Readings> exact;  ///< none: there is no exact integral
  std::optional<Readings> even;   ///< exact, under even stiffness; only where the field is suspect
  /// The parts of `exact` and `even` that polygons bring which inverted tets concern.
  std::optional<Readings> exact_inverted, even_inverted;
  bool soft_contact = false;  ///< the field is suspect, but `even` cannot tell
  Readings force;             ///< magnitude, of the whole sensor [N]
};

/// Decides, without `needed` and `voronoi_change`. The part of the change that is largest in its direction names the
/// cause. The change under even stiffness is scaled so that the mean of both its readings is that of the exact ones:
/// only how a field differs from place to place counts against it.
Verdict decide(const VerdictInput& input);

/// The sentences; `unit_text` as "Pa". To be called when all else is there.
std::string verdict_text(const Verdict& verdict, const VerdictInput& input);

}  // namespace taxel
