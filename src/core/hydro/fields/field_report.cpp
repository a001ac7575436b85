#include "core/hydro/fields/field_report.h"

#include <fmt/format.h>

#include "core/base/text/number_text.h"

namespace taxel {
namespace {

const char* plural(int count) {
  return count == 1 ? "" : "s";
}

/// Returns for example "13 faces (0.2 mm\u00b2, 0.1 % of the skin) between (..) mm and (..) mm".
std::string part_text(const SkinPart& part, double skin_area) {
  return fmt::format("{} face{} ({}, {:.3g} % of the skin) between {} and {}", part.faces, plural(part.faces),
                     in_mm2(part.area), 100 * part.area / skin_area, place_in_mm(part.bounds.lo),
                     place_in_mm(part.bounds.hi));
}

/// Returns for example "face 12, (1, 2, 3) mm". A face that the repair added has no number in the file.
std::string worst_face_text(const SkinPart& part) {
  const std::string face =
      part.worst_face < 0 ? "a face that the repair filled in" : fmt::format("face {}", part.worst_face);
  return fmt::format("{}, {}", face, place_in_mm(part.worst_place));
}

/// Returns for example "; 0.1 H deep 1 +- 0.003 times E depth/H, 0.25 H deep 0.99 +- 0.02; no tets 0.25 H below 4 %, 1
/// H below 78 % of the skin (depth pieces serve contact there)".
std::string press_text(const FieldReport& report) {
  std::string felt, missing;
  for (const FieldReport::PressError& press : report.press_errors) {
    if (press.deviation > 0 || press.mean != 1)
      felt += fmt::format("{} {:.3g} H deep {:.3g} +- {:.2g}", felt.empty() ? ";" : ",", press.part, press.mean,
                          press.deviation);
    if (press.without_tets >= 0.001)
      missing += fmt::format("{} {:.3g} H below {:.2g} %", missing.empty() ? "; no tets" : ",", press.part,
                             100 * press.without_tets);
  }
  if (!felt.empty()) felt += " times E depth/H";
  if (!missing.empty()) missing += " of the skin (depth pieces serve contact there)";
  return felt + missing;
}

/// Returns the sentence about a pad: its two-layer faces and its error of depth.
std::string pad_text(const FieldReport& report) {
  if (!report.core) return "";
  const std::string layers =
      report.two_layer_faces > 0
          ? fmt::format("two layers of prisms below {} face{}", report.two_layer_faces, plural(report.two_layer_faces))
          : std::string("one layer of prisms");
  std::string text = fmt::format("; {}, {:.2g} % of the modulus away from E depth/H (root mean square)", layers,
                                 100 * report.depth_error_rms);
  if (report.refined_faces > 0)
    text += fmt::format("; {} face{} added by refinement", report.refined_faces, plural(report.refined_faces));
  if (report.tents > 0) text += fmt::format("; tents above {} face{}", report.tents, plural(report.tents));
  return text + press_text(report);
}

void add_limits(const FieldReport& report, const std::string& file, const std::string& pointer, Problems& out) {
  if (report.thickness > report.deepest && report.core) {
    out.push_back({file, pointer, Severity::warning, "field_thicker_than_body",
                   fmt::format("the pad is {} thick, more than half of the body's smallest extent, {}: it "
                               "ends in the middle, where the pressure is below the modulus",
                               in_mm(report.thickness), in_mm(report.deepest)),
                   "a thickness in metres, below that"});
  }
  if (report.limited.faces > 0) {
    out.push_back(
        {file, pointer, Severity::note, "field_thickness_limited",
         fmt::format("the pad is thinner than {} at {}: {:.3g} of it is left at {}", in_mm(report.thickness),
                     part_text(report.limited, report.skin_area), report.least_part, worst_face_text(report.limited)),
         ""});
  }
  if (report.bare.faces > 0) {
    out.push_back(
        {file, pointer, Severity::note, "field_bare",
         fmt::format("{} have no tets, folded or edge on: depth pieces serve contact there; the largest is {}",
                     part_text(report.bare, report.skin_area), worst_face_text(report.bare)),
         ""});
  }
}

}  // namespace

Problems field_problems(const FieldReport& report, const std::string& file, const std::string& pointer) {
  constexpr double kUneven = 0.06;
  Problems out;
  out.push_back(
      {file, pointer, Severity::note, "field_report",
       fmt::format("pressure field of {} tets; stiffness {:.4g} Pa/m, from {:.4g} to {:.4g}, varies by {:.2g} % "
                   "over the skin{}",
                   report.tets, report.stiffness_mean, report.stiffness_min, report.stiffness_max,
                   100 * report.stiffness_cv, pad_text(report)),
       ""});
  if (report.inverted > 0) {
    out.push_back({file, pointer, Severity::warning, "field_inverted",
                   fmt::format("{} of {} tets of the pressure field were inside out and have been turned: it overlaps "
                               "itself there",
                               report.inverted, report.tets),
                   "use a pad"});
  }
  if (report.zero_gradient > 0) {
    out.push_back(
        {file, pointer, Severity::warning, "field_zero_gradient",
         fmt::format("{} of {} tets of the pressure field have no pressure that grows inward: nothing is felt "
                     "in them",
                     report.zero_gradient, report.tets),
         "give the tets vertices inside of the body"});
  }
  add_limits(report, file, pointer, out);
  if (report.core && report.stiffness_cv > kUneven) {
    out.push_back({file, pointer, Severity::warning, "field_uneven",
                   fmt::format("the pad's stiffness varies by {:.2g} % over the skin", 100 * report.stiffness_cv),
                   "a thinner pad, or a finer mesh where it is sharp"});
  }
  for (const std::string& note : report.notes) out.push_back({file, pointer, Severity::note, "field_note", note, ""});
  return out;
}

}  // namespace taxel
