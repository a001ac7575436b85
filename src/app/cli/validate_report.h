// `taxel validate`: the closed forms as a table, as JSON and as docs/validation.md.
#pragma once

#include <string>

#include "app/validate/closed_form.h"

namespace taxel::cli {

/// "", "<= " or ">= ".
std::string relation_text(Relation relation);

std::string validate_text(const ClosedFormChecks& checks);
std::string validate_json(const ClosedFormChecks& checks);
/// The page, with formulas. Errors at rounding level are shown by their bound, so that the page is the same everywhere.
std::string validate_markdown(const ClosedFormChecks& checks);

}  // namespace taxel::cli
