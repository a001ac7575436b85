// taxel validate: contact against closed forms.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/validate_report.h"

namespace taxel::cli {
namespace {

std::string error_text(double error) {
  return error < 1e-12 ? "< 1e-12" : fmt::format("{:.2g}", error);
}

struct Formula {
  const char* form;
  const char* text;
};
constexpr Formula kFormulas[] = {
    {"A1",
     "Soft sphere, p = E (1 - r/R), on a rigid plane at depth x: F = pi E x^2 (1 - 2x/(3R)), area = pi (2Rx - x^2), "
     "largest pressure = E x/R."},
    {"A2",
     "Rigid sphere at depth x in a soft half-space, p = kappa depth, kappa = E/H: F = kappa pi x^2 (R - x/3), area = "
     "2 pi R x."},
    {"A3",
     "Any closed rigid polyhedron in one linear field: F = kappa V of its submerged part, through that part's "
     "centroid. The surface integral of a linear pressure is exact, so only rounding is left."}};

}  // namespace

std::string validate_text(const std::vector<ClosedFormCheck>& checks) {
  std::string text = fmt::format("{:<4} {:<34} {:>14} {:>14} {:>9} {:>8}\n", "form", "quantity", "computed", "exact",
                                 "error", "bound");
  for (const ClosedFormCheck& check : checks) {
    text += fmt::format("{:<4} {:<34} {:>14.7g} {:>14.7g} {:>9} {:>8.2g}  {}\n", check.form,
                        check.quantity + (check.unit == "1" ? "" : " [" + check.unit + "]"), check.computed,
                        check.exact, error_text(check.error), check.bound, check.pass() ? "pass" : "FAIL");
  }
  const auto passed = std::count_if(checks.begin(), checks.end(), [](const ClosedFormCheck& c) { return c.pass(); });
  return text + fmt::format("{} of {} within their bounds\n", passed, checks.size());
}

std::string validate_markdown(const std::vector<ClosedFormCheck>& checks) {
  std::string text =
      "# Validation\n\n"
      "Contact against closed forms, relative errors. Written by `taxel validate --markdown > docs/validation.md`.\n"
      "The same numbers are tested in `tests/unit/project`, and through the program in `tests/cli`.\n";
  for (const Formula& formula : kFormulas) {
    std::string setting;
    std::string rows;
    for (const ClosedFormCheck& check : checks) {
      if (check.form != formula.form) continue;
      setting = check.setting;
      rows +=
          fmt::format("| {} | {} | {:.6g} | {:.6g} | {} | {:.2g} | {} |\n", check.quantity, check.unit, check.computed,
                      check.exact, error_text(check.error), check.bound, check.pass() ? "yes" : "**no**");
    }
    if (rows.empty()) continue;
    text += fmt::format("\n## {}\n\n{}\n\nHere: {}.\n\n", formula.form, formula.text, setting);
    text += "| quantity | unit | computed | exact | error | bound | within |\n";
    text += "| --- | --- | --- | --- | --- | --- | --- |\n";
    text += rows;
  }
  return text;
}

namespace {

int run(bool markdown, Console& console) {
  const std::vector<ClosedFormCheck> checks = validate_all();
  console.result(console.json() ? validate_json(checks) : markdown ? validate_markdown(checks) : validate_text(checks));
  const bool pass = std::all_of(checks.begin(), checks.end(), [](const ClosedFormCheck& c) { return c.pass(); });
  return pass ? kDone : kProblemsFound;
}

}  // namespace

Command add_validate(CLI::App& parent, CommonOptions& common) {
  const auto markdown = std::make_shared<bool>(false);
  CLI::App* app = add_command(parent, common, "validate", "Contact against closed forms: computed, exact, error, bound",
                              "taxel validate --markdown > docs/validation.md");
  app->add_flag("--markdown", *markdown, "The page docs/validation.md instead of a table");
  return {app, [markdown](Console& console) { return run(*markdown, console); }};
}

}  // namespace taxel::cli
