// The cause of a change of a reading, and the sentences about it.
//
// The change is a sum of parts: noise (samples less exact integral), field (exact less uniform stiffness), edges (exact
// less interpolated normals), cone (less no limit of the angle) and contact, the rest. Each part is the difference of
// two changes that are measured on the same two contacts. The other readings are first scaled to the mean of the exact
// ones: only how they differ from step to step counts, not that they are larger or smaller. The largest part in the
// direction of the change is the cause.
//
// Without an exact integral the noise is unknown and counts as 0, and the text says so. Apart from the half of the
// field's part that inverted tets need, no threshold decides between the causes; the limits only decide whether there
// was a jump, and whether the force stayed. Theory: docs/theory/sensor.md, "Why a reading changed".
#include "core/sensor/explain/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/text/message.h"

namespace taxel {
namespace {

/// Returns the factor that scales other readings of the same two contacts to the mean of the exact readings.
double scale_to_exact(const Readings& other, const VerdictInput& in) {
  const double sum = other.before + other.now;
  return sum > 0 ? (in.exact->before + in.exact->now) / sum : 0.0;
}

/// Returns true if fractions of the taxel's own largest reading would mean nothing.
bool hardly_reads(const ExplainLimits& limits) {
  return !limits.of_sensor && limits.largest < kHardlyReads * limits.sensor_largest;
}

std::string percent(double value, const ExplainLimits& limits) {
  const double whole = hardly_reads(limits) ? limits.sensor_largest : limits.largest;
  return fmt::format("{:.3g} %", whole > 0 ? 100 * std::abs(value) / whole : 0.0);
}

/// Returns "rose by 12 %", as a fraction of the largest reading.
std::string moved(double change, const ExplainLimits& limits) {
  return fmt::format("{} by {}", change < 0 ? "fell" : "rose", percent(change, limits));
}

/// Largest fraction of a change that remains after a useful remedy.
constexpr double kHelps = 0.9;
/// Number of crossed edges that the sentences name.
constexpr std::size_t kNamedEdges = 2;

/// Returns the effect of other samples on the change, measured on the same two contacts.
std::string cure(const Verdict& v, const ExplainLimits& limits) {
  const auto instead = [&](double change) {
    return fmt::format("it would be {} instead of {}", percent(change, limits), percent(v.change, limits));
  };
  std::string text;
  if (v.needed)
    text = fmt::format(" {} {:.0f} samples, {:.3g} times as many, {}{}.", v.needed->cures ? "With" : "Even with",
                       v.needed->samples, v.needed->factor, instead(v.needed->change),
                       v.needed->cures ? ", below the limit" : ", not safely below the limit");
  if (v.voronoi_change) {
    const bool helps = std::abs(*v.voronoi_change) < kHelps * std::abs(v.change);
    text += fmt::format(" {} the same samples, {}.",
                        helps ? "With Voronoi weights of" : "Voronoi weights do not help: with them on",
                        instead(*v.voronoi_change));
  }
  return text;
}

/// Returns the sentence about the worst change of the run and the remedy for it.
std::string worst_text(const Verdict& v, const ExplainLimits& limits) {
  if (!v.worst) return "";
  const WorstChange& worst = *v.worst;
  std::string text = fmt::format(" The largest step of the taxel in the run is another one, {} at {:.6g} s",
                                 percent(worst.change, limits), worst.time);
  if (worst.needed)
    text +=
        fmt::format(": {} {:.3g} times as many samples it would be {}{}", worst.needed->cures ? "with" : "even with",
                    worst.needed->factor, percent(worst.needed->change, limits),
                    worst.needed->cures ? "" : ", not safely below the limit");
  if (worst.wider)
    text += fmt::format(": {} a limit of {:g} degrees it would be {}{}", worst.wider->cures ? "with" : "even with",
                        worst.wider->angle_deg, percent(worst.wider->change, limits),
                        worst.wider->cures ? "" : ", not safely below the limit");
  return text + ".";
}

/// Returns the sentence about a change below the limit. One that is large all the same, and partly noise, is no smooth
/// one.
std::string below_limit_text(const Verdict& v, const VerdictInput& in, const std::string& reading,
                             const std::string& exactly) {
  if (v.change == 0) return "No jump: the reading did not change in this step.";
  const std::string limit = hardly_reads(in.limits) ? "" : fmt::format(", the limit is {:.3g} %", 100 * in.limits.jump);
  if (!is_partly_noise(v, in)) return fmt::format("No jump: {}{}.", reading, limit);
  std::string text = fmt::format(
      "Below the limit of a jump, {:.3g} %, but partly noise: {}{}. {:.0f} % of the step is noise of the samples",
      100 * in.limits.jump, reading, exactly, 100 * std::min(1.0, v.noise / v.change));
  if (v.needed)
    text += fmt::format(": {} {:.3g} times as many samples it would be {}", v.needed->cures ? "with" : "even with",
                        v.needed->factor, percent(v.needed->change, in.limits));
  return text + ".";
}

/// Returns the effect of a wider limit of the angle on the change, measured on the same two contacts.
std::string wider_text(const Verdict& v, const ExplainLimits& limits) {
  if (!v.wider) return "";
  return fmt::format(" {} a limit of {:g} degrees it would be {} instead of {}{}.",
                     v.wider->cures ? "With" : "Even with", v.wider->angle_deg, percent(v.wider->change, limits),
                     percent(v.change, limits), v.wider->cures ? ", below the limit" : ", not safely below the limit");
}

/// Returns the sentence about the edges that the contact crossed.
std::string crossed_text(const Verdict& v) {
  if (v.crossed.empty()) return "";
  std::string text;
  for (std::size_t i = 0; i < std::min(v.crossed.size(), kNamedEdges); ++i) {
    const CrossedEdge& edge = v.crossed[i];
    text +=
        fmt::format("{} that between the faces {} and {}, bent by {:.3g} degrees, {:.3g} mm from the taxel's centre",
                    i == 0 ? "" : ",", edge.faces[0], edge.faces[1], edge.bend_deg, 1e3 * edge.distance);
  }
  return fmt::format(
      " The contact crossed {} under the taxel:{}.",
      v.crossed.size() == 1 ? "an edge of the mesh" : fmt::format("{} edges of the mesh", v.crossed.size()), text);
}

/// Returns the effect of the best setting that was tried, measured on the same two contacts.
std::string tried_text(const Verdict& v, const ExplainLimits& limits) {
  const SettingTried* best = best_setting(v.tried, kHelps * std::abs(v.change));
  if (best == nullptr)
    return v.tried.empty()
               ? ""
               : fmt::format(" None of {} other settings of the layout that were tried helps.", v.tried.size());
  return fmt::format(" With {} it would be {} instead of {}{}.", best->text, percent(best->change, limits),
                     percent(v.change, limits), best->cures ? ", below the limit" : ", not safely below the limit");
}

}  // namespace

bool is_partly_noise(const Verdict& v, const VerdictInput& in) {
  constexpr double kLarge = 0.2, kNoisy = 0.25;  // fractions of the limit and of the change
  return v.cause == Cause::none && in.exact && std::abs(v.change) > kLarge * v.limit && v.noise * v.change > 0 &&
         std::abs(v.noise) > kNoisy * std::abs(v.change) && !hardly_reads(in.limits);
}

Verdict decide(const VerdictInput& in) {
  Verdict v;
  v.limit = in.limits.jump * in.limits.largest;
  v.change = in.sampled.change();
  const double exact = in.exact ? in.exact->change() : v.change;
  // Returns the change of other readings of the two contacts, or `otherwise` if they are unknown.
  const auto scaled = [&](const std::optional<Readings>& other, double otherwise) {
    return other && in.exact ? scale_to_exact(*other, in) * other->change() : otherwise;
  };
  v.noise = v.change - exact;
  v.field = exact - scaled(in.even, exact);
  const double smooth = scaled(in.smooth, exact);
  v.edges = exact - smooth;
  v.cone = smooth - scaled(in.uncut, smooth);
  v.contact = exact - v.field - v.edges - v.cone;
  v.force_stays = std::abs(in.force.change()) <=
                  in.limits.equal_force * std::max(std::abs(in.force.before), std::abs(in.force.now));
  if (!(std::abs(v.change) > v.limit)) return v;

  const double sign = v.change < 0 ? -1 : 1;
  const double noise = sign * v.noise, field = sign * v.field, cone = sign * v.cone, edges = sign * v.edges;
  const double rest = sign * v.contact;
  if (noise >= std::max({field, cone, edges, rest})) {
    v.cause = Cause::sampling_noise;
  } else if (cone > field && cone >= std::max(edges, rest)) {
    v.cause = Cause::cone;
  } else if (edges > field && edges >= rest) {
    v.cause = Cause::mesh_edges;
  } else if (field >= rest) {
    // The inverted tets cause it if most of the difference from uniform stiffness is on their polygons.
    const double inverted =
        in.exact_inverted && in.even_inverted
            ? sign * (in.exact_inverted->change() - scale_to_exact(*in.even, in) * in.even_inverted->change())
            : 0.0;
    v.cause = inverted >= 0.5 * field ? Cause::inverted_tets : Cause::star_field;
  } else {
    v.cause = v.force_stays ? Cause::redistribution : Cause::contact;
  }
  return v;
}

namespace {

std::string explained_text(const Verdict& v, const VerdictInput& in) {
  const bool of_sensor = in.limits.of_sensor || hardly_reads(in.limits);
  const std::string reading = "the reading " + moved(v.change, in.limits) +
                              (of_sensor ? " of the sensor's largest" : " of the taxel's largest");
  const std::string exactly =
      in.exact ? ", the exact integral of the same contact " + moved(in.exact->change(), in.limits) : std::string();
  switch (v.cause) {
    case Cause::none:
      return below_limit_text(v, in, reading, exactly);
    case Cause::sampling_noise:
      return fmt::format("Sampling noise: {}{}.", reading, exactly) + cure(v, in.limits);
    case Cause::star_field:
      return fmt::format(
          "Pressure field: {}{}, and with uniform stiffness it {}. The tets of a star field differ in stiffness; "
          "a pad has uniform stiffness.",
          reading, exactly, moved(v.contact, in.limits));
    case Cause::inverted_tets:
      return fmt::format(
          "Inverted tets: {}{}, and with uniform stiffness it {}. Tets of the skin there are inverted, and other tets "
          "overlap them; a pad has no inverted tets.",
          reading, exactly, moved(v.contact, in.limits));
    case Cause::cone:
      return fmt::format(
                 "Cone: {}{}, and without the limit of the angle {}. The contact crossed the edge at which the limit "
                 "cuts the field of the taxel.",
                 reading, exactly, moved(v.change - v.noise - v.cone, in.limits)) +
             wider_text(v, in.limits);
    case Cause::mesh_edges:
      return fmt::format("Mesh edges: {}{}, and with normals interpolated over the faces it {}.{}{}", reading, exactly,
                         moved(v.change - v.noise - v.edges, in.limits), crossed_text(v), tried_text(v, in.limits));
    case Cause::redistribution:
    case Cause::contact:
      break;
  }
  constexpr int kForceDigits = 3;
  const double larger = std::max(in.force.before, in.force.now);
  const NumberPair forces = number_pair(in.force.before, in.force.now, kForceDigits);
  const std::string force = v.force_stays
                                ? fmt::format("the force on the sensor stayed at {:.3g} N", in.force.now)
                                : fmt::format("the force on the sensor went from {} to {} N ({:+.3g} %)", forces.first,
                                              forces.second, larger > 0 ? 100 * in.force.change() / larger : 0.0);
  std::string text = fmt::format("{}: {}{}; {}.", v.cause == Cause::contact ? "The contact itself" : "Redistribution",
                                 reading, exactly, force);
  if (v.cause == Cause::redistribution) text += " The pressure moved to other places.";
  if (!in.exact) text += " It is unknown whether samples or contact caused it: there is no exact integral.";
  if (in.soft_contact) text += " It is unknown whether the field contributed: both bodies are soft.";
  return text;
}

}  // namespace

std::string verdict_text(const Verdict& v, const VerdictInput& in) {
  std::string text = explained_text(v, in);
  if (hardly_reads(in.limits))
    text += fmt::format(" The taxel hardly reads: its largest reading is {:.2g} % of the sensor's.",
                        100 * in.limits.largest / in.limits.sensor_largest);
  return text + worst_text(v, in.limits);
}

}  // namespace taxel
