// taxel validate: compares contact and sensing with closed forms.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/cli/command_line.h"
#include "app/cli/report_writer.h"
#include "app/validate/validation.h"
#include "core/base/files.h"
#include "core/base/page/chart.h"

namespace taxel::cli {
namespace {

/// Values at rounding level differ from machine to machine, so only this bound of theirs is shown.
constexpr double kRounding = 1e-9;

std::string error_text(const ClosedFormCheck& check) {
  const double floor = check.bound > 0 ? std::min(check.bound, kRounding) : kRounding;
  if (check.relation != Relation::equal && check.error == 0) return "-";
  return check.error < floor ? fmt::format("< {:g}", floor) : fmt::format("{:.2g}", check.error);
}

std::string computed_text(const ClosedFormCheck& check, int digits) {
  const bool rounding = std::abs(check.computed) < kRounding * std::max(1.0, std::abs(check.exact));
  if (check.relation != Relation::equal && rounding) return fmt::format("< {:g}", kRounding);
  return fmt::format("{:.{}g}", check.computed, digits);
}

/// Returns "", "<= " or ">= ".
std::string relation_text(Relation relation) {
  return relation == Relation::at_most ? "<= " : relation == Relation::at_least ? ">= " : "";
}

std::string exact_text(const ClosedFormCheck& check, int digits) {
  return fmt::format("{}{:.{}g}", relation_text(check.relation), check.exact, digits);
}

struct Formula {
  const char* form;
  const char* text;
  const char* picture = nullptr;  ///< caption of docs/pictures/samples.svg
};
constexpr Formula kFormulas[] = {
    {"A1",
     "Soft sphere, p = E (1 - r/R), on a rigid plane at depth x: F = pi E x^2 (1 - 2x/(3R)), area = pi a^2, rim radius "
     "a = sqrt(2Rx - x^2), largest pressure = E x/R. The error falls with the square of the edge length."},
    {"A2",
     "Rigid sphere at depth x in a soft half-space, p = kappa depth, kappa = E/H: F = kappa pi x^2 (R - x/3), area = "
     "2 pi R x."},
    {"A3",
     "Any closed rigid polyhedron in one linear field, if all faces count: F = kappa V of its submerged part, through "
     "that part's centroid. The surface integral of a linear pressure is exact, so only rounding is left."},
    {"A4",
     "Soft box with its medial-axis field on a rigid plane: F = (E/H)(x L1 L2 - x^2 (L1 + L2) + 4x^3/3). The field is "
     "linear on its tets, so only rounding is left."},
    {"A5", "Soft cylinder standing on a rigid plane: F = pi E (R^3 - (R - x)^3)/(3H), H = R."},
    {"A6",
     "Soft cylinder lying on a rigid plane, per length: F = E (a - (h^2/R) asinh(a/h)), h = R - x, a = sqrt(R^2 - "
     "h^2), area 2a."},
    {"A7",
     "Two soft spheres: equal pressures lie on kA rA - kB rB = EA - EB, k = E/R; on the axis p0 = x kA kB/(kA + "
     "kB); the rim is the lens circle. Force and area by quadrature over the radius."},
    {"A8",
     "Stacked slabs: p = x/(HA/EA + HB/EB) where both are pressed from above alone; a soft box on a soft slab feels "
     "the force of A4 at the depth x kB/(kA + kB), k = E/H; towards a stiff slab that of a rigid plane."},
    {"A9",
     "Motion, under each of MuJoCo's integrators: rest where F(x) = m g; the rebound of Hunt and Crossley, which is "
     "v/d - ln(1 + d v)/d^2 alike at impact and, with -v, at rebound, and less than 1/d; no flight with more energy "
     "than the one before; on a slope tan(theta) < mu a steady creep of vs tan(pi tan(theta)/(2 mu)), vs = 1e-4 "
     "m/s, and steeper an acceleration of g (sin(theta) - mu cos(theta))."},
    {"A10",
     "Friction that sticks, the brush model: on a ball moved sideways by u, the disc where k u < mu p, of radius c, "
     "c^2 "
     "= R^2 (1 - k u/(mu E))^2 - (R - x)^2, sticks, and the ring around it slips (Cattaneo); friction k u pi c^2 + mu "
     "(load outside of c); a cycle between -U and U takes 8 (integral of the friction from 0 to U - U F(U)/2) "
     "(Masing). "
     "A block on a slope stays where it is below the angle of friction, and slides above."},
    {"A11",
     "Rolling: the contact of a soft ball is flat and lies R - x below its centre, so the ball rolls with v = w (R - "
     "x)."},
    {"A12",
     "A rigid disc that spins in a soft half-space: friction torque (2/3) mu p pi R^3 (1 + 1.5 x/R), p = E x/H. The "
     "second term is that of the wall, on which the pressure falls from p to 0."},
    {"A13",
     "Rolling resistance of Hunt and Crossley's dissipation: the torque d w J, J = pi integral of p0 r^3 dr, so w "
     "falls by exp(-d J t/(I + m (R - x)^2))."},
    {"A14",
     "Impact without dissipation: at the largest depth m v^2/2 = integral of F dx, F of A1; the contact lasts 2 "
     "integral of dx/v, and the ball leaves with the speed of the impact."},
    {"A15",
     "Pressure laws p = E L(e), e the strain of the linear field: F = integral of E L(e) over the area of A1, A2 and "
     "A4; "
     "between slabs the pressure at which their depths add up to x."},
    {"B1",
     "Samples: the distance of each to its nearest neighbour over that of the densest packing, sqrt(2A/(sqrt(3) "
     "N)); the standard deviation of the areas nearest to each over their mean; the widest gap, from the emptiest "
     "place of the surface to its sample over that of the densest packing. Counted by a scorer that shares nothing "
     "with the sampler.",
     "Polished samples on the pad side of our fingertip, coloured by the distance to the nearest one, and how often "
     "each distance occurs, polished and in a preview"},
    {"B2",
     "Geodesic distances on a tube that unrolls into a plane: d^2 = du^2 + dz^2, u along the circumference. Shortest "
     "paths are exact, so only rounding is left."},
    {"B3",
     "The weighted mean, weights (r - d)^2, of a pressure that is linear over a flat patch: that at the taxel's "
     "centre. Voronoi areas as weights make up for samples that are nowhere quite even."}};

std::string rows_of(const ClosedFormChecks& checks, const std::string& form, const std::string& setting) {
  std::string rows;
  for (const ClosedFormCheck& check : checks) {
    if (check.form != form || check.setting != setting) continue;
    rows +=
        fmt::format("| {} | {} | {} | {} | {} | {:.2g} | {} |\n", check.quantity, check.unit, computed_text(check, 6),
                    exact_text(check, 6), error_text(check), check.bound, check.pass() ? "yes" : "**no**");
  }
  return rows;
}

ClosedFormChecks validate_all() {
  ClosedFormChecks all = validate_statics();
  for (const auto& validate : {validate_dynamics, validate_sticking, validate_rolling_and_impact}) {
    const ClosedFormChecks checks = validate();
    all.insert(all.end(), checks.begin(), checks.end());
  }
  return all;
}

struct ValidateReport {
  ClosedFormChecks checks;

  [[nodiscard]] bool is_passed() const {
    return std::all_of(checks.begin(), checks.end(), [](const ClosedFormCheck& check) { return check.pass(); });
  }
  void visit(ReportWriter& w) const {
    w.list("checks", checks, [](ReportWriter& one, const ClosedFormCheck& check) {
      one("form", check.form);
      one("setting", check.setting);
      one("quantity", check.quantity);
      one("unit", check.unit);
      one("computed", check.computed);
      one("exact", check.exact);
      one("relation", check.relation == Relation::equal ? "=" : check.relation == Relation::at_most ? "<=" : ">=");
      one("error", check.error);
      one("bound", check.bound);
      one("pass", check.pass());
    });
    w("pass", is_passed());
  }
  [[nodiscard]] std::string text() const;
};

std::string ValidateReport::text() const {
  std::string text = fmt::format("{:<4} {:<42} {:>14} {:>14} {:>9} {:>8}\n", "form", "quantity", "computed", "exact",
                                 "error", "bound");
  for (const ClosedFormCheck& check : checks) {
    text += fmt::format("{:<4} {:<42} {:>14} {:>14} {:>9} {:>8.2g}  {}\n", check.form,
                        check.quantity + (check.unit == "1" ? "" : " [" + check.unit + "]"), computed_text(check, 7),
                        exact_text(check, 7), error_text(check), check.bound, check.pass() ? "pass" : "FAIL");
  }
  const auto passed = std::count_if(checks.begin(), checks.end(), [](const ClosedFormCheck& c) { return c.pass(); });
  return text + fmt::format("{} of {} within their bounds\n", passed, checks.size());
}

/// Returns the page docs/validation.md, with formulas. Errors at rounding level are shown by their bound, so that the
/// page is the same on every machine.
std::string validate_markdown(const ClosedFormChecks& checks) {
  std::string text =
      "# Validation\n"
      "\n"
      "Relative errors of contact and sensing against closed forms; for an inequality, the amount by which it is "
      "violated. Written by `taxel validate --markdown`, through `scripts/validation`.\n"
      "The same numbers are tested through the program in `tests/cli`. Comparison with Drake: "
      "[bench/drake/results.md](../bench/drake/results.md).\n";
  for (const Formula& formula : kFormulas) {
    std::vector<std::string> settings;
    for (const ClosedFormCheck& check : checks) {
      if (check.form == formula.form && std::count(settings.begin(), settings.end(), check.setting) == 0)
        settings.push_back(check.setting);
    }
    if (settings.empty()) continue;
    text += fmt::format("\n## {}\n\n{}\n", formula.form, formula.text);
    if (formula.picture) text += fmt::format("\n![{}]({})\n", formula.picture, "pictures/samples.svg");
    for (const std::string& setting : settings) {
      text += fmt::format("\nHere: {}.\n\n", setting);
      text += "| quantity | unit | computed | exact | error | bound | within |\n";
      text += "| --- | --- | --- | --- | --- | --- | --- |\n";
      text += rows_of(checks, formula.form, setting);
    }
  }
  return text;
}

struct ValidateOptions {
  bool markdown = false;
  std::string samples;
};

int run_validate_command(const ValidateOptions& options, Console& console) {
  if (!options.samples.empty()) {
    const bool is_svg = options.samples.ends_with(".svg"), is_pdf = options.samples.ends_with(".pdf");
    write_file_atomically(options.samples, is_svg   ? page_to_svg(chart_page(samples_chart()))
                                           : is_pdf ? page_to_pdf(chart_page(samples_chart()))
                                                    : samples_csv());
    return kDone;
  }
  const ValidateReport report{validate_all()};
  if (options.markdown && !console.json())
    console.result(validate_markdown(report.checks));
  else
    print_report(console, report);
  return report.is_passed() ? kDone : kProblemsFound;
}

}  // namespace

Run add_validate(OptionList& list) {
  const auto options = std::make_shared<ValidateOptions>();
  list.add("--markdown", &options->markdown, "The page docs/validation.md instead of a table");
  list.add(
      "--samples", &options->samples,
      "Write only the samples of the fingertip in B1 and how even they are, as CSV: x,y,z [m],rho,area,quality; or "
      "as a picture, .svg or .pdf",
      {.unit = "FILE"});
  return [options](Console& console) { return run_validate_command(*options, console); };
}

}  // namespace taxel::cli
